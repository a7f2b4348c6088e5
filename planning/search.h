// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "planning/free_space.h"

namespace hapticell::planning {

/// A kind of search, and how far it goes in one step, as a share of the space's extent.
struct SearchKind {
  enum class Method { kRrtConnect, kBiEst };
  Method method = Method::kRrtConnect;
  double range = 0.1;
};

/// "rrt_connect", "bi_est".
const char* toString(SearchKind::Method method);

/// A search from one configuration to any of several.
struct SearchJob {
  EntityConfiguration start;
  std::vector<EntityConfiguration> goals;  ///< All free.
  std::uint64_t seed = 1;
  std::size_t most_checks = 100'000;  ///< Of each search.
  int threads = 1;
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double)> progress = {};
  std::vector<SearchKind> kinds = {};  ///< One a search; empty: the shipped ones.
};

struct SearchResult {
  std::vector<EntityConfiguration> path;  ///< From the start to a goal; empty: none was found.
  std::size_t checks = 0;                 ///< Of the search that won.
  std::string planner;
  /// What was in the way of the first search, by name, and how often.
  std::map<std::string, std::size_t> blocks;
  /// Reached from the start, and nearest to a goal; empty with a path.
  std::optional<EntityConfiguration> nearest;
};

/// Runs several searches (OMPL) with seeds of their own in rounds: in each round every search may use so many checks,
/// twice as many as in the one before. In the first round in which one gets there, the one wins that used the fewest
/// checks: so the result depends on the job alone, not on threads or time, unless deadline or stop end it. Straight
/// motions to the goals are tried first.
SearchResult search(const FreeSpace& space, const SearchJob& job);

}  // namespace hapticell::planning
