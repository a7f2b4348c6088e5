// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// What a file's nodes may become once each stands in every place that names it.
struct UnfoldingLimits {
  int deepest = 200;             ///< Levels below each other.
  std::uint64_t most = 200'000;  ///< Nodes in all, or twenty times those that the file states, whichever is more.
};

/// Counts, before anything is made, what the nodes below `roots` unfold to: `below[k]` are the nodes that node k holds;
/// numbers beyond the last are left out. Error: a node that holds itself, directly or through others; more levels or more
/// nodes than may be. `place_of` says what a node is called. Linear in nodes and links, without recursion.
Expected<void> checkUnfolding(const std::vector<std::vector<std::uint32_t>>& below,
                              const std::vector<std::uint32_t>& roots, const UnfoldingLimits& limits,
                              const std::function<std::string(std::uint32_t)>& place_of);

}  // namespace hapticell::geometry
