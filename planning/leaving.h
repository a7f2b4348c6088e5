// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/system/text.h"
#include "planning/free_space.h"
#include "planning/plan.h"

namespace hapticell::planning {

/// Where a straight motion ends that leaves all that is nearer than the clearance of `space` at `at`, by LeavingRule,
/// and is free but for that; the end is free. The same motion backwards reaches `at`. Tried are motions of the tool (of a
/// solid) along the directions in which these pairs open and along the axes of world and tool, and of single joints.
/// Empty: none of them does.
std::optional<EntityConfiguration> wayOut(FreeSpace& space, const EntityConfiguration& at);

/// The sentence on why there is no wayOut(): too deep, with the part that has to be moved, or `where` and that nothing
/// leads out.
Text whyNoWayOut(FreeSpace& space, const EntityConfiguration& at, const Text& where);

/// The sentence on a start that is not free.
Failure startFailure(FreeSpace& space, const EntityConfiguration& start);

}  // namespace hapticell::planning
