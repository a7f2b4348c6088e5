// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>

namespace hapticell::workcell {

/// What is wrong with how names stand above each other.
struct Levels {
  std::unordered_set<std::string> in_circle;  ///< One name of each circle.
  std::string too_deep;                       ///< A name with more than so many above it; empty: none.
};

/// Looks at who stands above whom. `above`: the one above each name, where there is one. Linear: each name is looked at
/// once.
Levels levelsOf(const std::unordered_map<std::string, std::string>& above, int most);

}  // namespace hapticell::workcell
