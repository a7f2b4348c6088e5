// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/system/error.h"
#include "planning/free_space.h"
#include "planning/plan.h"
#include "planning/problem.h"

namespace hapticell::planning {

/// The free configurations of a goal, or why it has no free one.
struct GoalStates {
  std::vector<EntityConfiguration> free;  ///< Nearest to the start first; empty with a failure.
  std::optional<Failure> failure;
  std::vector<EntityConfiguration> tight = {};  ///< Some of those that are not free, nearest to the start first.
};

/// All configurations of the goal that are free with the clearance of `space`: for a pose every solution of the robot's
/// inverse model within its limits, full turns too; for a region and for redundant robots a sample that follows from
/// `seed`. Errors: the goal does not suit the entity, numbers that do not fit or are not finite, no inverse model.
Expected<GoalStates> goalStates(const Goal& goal, FreeSpace& space, const EntityConfiguration& start,
                                std::uint64_t seed);

}  // namespace hapticell::planning
