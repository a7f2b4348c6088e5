// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>

#include "access/removal_way.h"

namespace hapticell::access {

/// A way out with turns, by the planner (planning/plan.h), when `gone` have gone: from where the unit stands, or from
/// the middle of a straight piece that leads away from a tight seat, to outside of all that it could meet. Checked by
/// UnitMotion. Nothing: none was found within the planner's checks, which proves nothing. Deterministic; many seconds;
/// `cancel` ends it early with nothing. Any thread.
std::optional<RemovalWay> plannedWay(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                     const std::atomic<bool>& cancel);

}  // namespace hapticell::access
