// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "access/removal_scene.h"

namespace hapticell::access {

/// In which order parts go until one of them can.
struct RemovalOrder {
  std::vector<std::size_t> units;  ///< First to go first; the wanted one last.
  bool is_shortest = true;         ///< False: the search ended early, and there may be a shorter one.
};

/// The alternatives of a unit: each a set of units that must be gone before it can leave; an empty set: it can leave
/// now. No alternative: it never can.
using Alternatives = std::function<const std::vector<UnitSet>&(std::size_t unit)>;

/// The least number of units that must go first, and their order (of equal ones the lowest numbers first). Nothing where
/// `wanted` can never leave: no order of all `count` units frees it. Asks only for what it needs at first, but for all
/// units where `wanted` cannot leave.
std::optional<RemovalOrder> removalOrder(std::size_t count, std::size_t wanted, const Alternatives& alternatives);

}  // namespace hapticell::access
