// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// Limits for a file's nodes after each is copied to every place that refers to it.
struct UnfoldingLimits {
  int deepest = 200;             ///< Levels below each other.
  std::uint64_t most = 200'000;  ///< Nodes in all, or 20 times the nodes in the file, whichever is more.
};

/// Counts, before anything is made, the nodes that `roots` unfold to. `below[k]` lists the nodes that node k holds;
/// invalid numbers are ignored. Error: a node that holds itself, directly or through others; more levels or nodes than
/// the limits. `place_of` gives a node's name for the error. Linear in nodes and links, without recursion.
Expected<void> checkUnfolding(const std::vector<std::vector<std::uint32_t>>& below,
                              const std::vector<std::uint32_t>& roots, const UnfoldingLimits& limits,
                              const std::function<Text(std::uint32_t)>& place_of);

}  // namespace hapticell::geometry
