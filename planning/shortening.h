// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "planning/free_space.h"

namespace hapticell::planning {

/// Greatest speeds of a solid, m/s and rad/s, as `trajectory retime` assumes; our choice. Half, twice: motions take
/// twice or half the time.
inline constexpr double kSolidSpeed = 0.5, kSolidTurn = 2.0;

/// The least time (s) of the motion between two configurations: the slowest joint at its greatest speed, or a solid at
/// 0.5 m/s and 2 rad/s; a mannequin by StandingFigure::leastTime().
double leastTime(const FreeSpace& space, const EntityConfiguration& from, const EntityConfiguration& to);

/// A path with the same ends, free like the given one, that takes less time: waypoints are left out, random shortcuts
/// are tried, and corners are cut. The result follows from `seed`. A stop of the space ends it early, and the path is
/// free all the same.
std::vector<EntityConfiguration> shortened(FreeSpace& space, std::vector<EntityConfiguration> path, std::uint64_t seed);

}  // namespace hapticell::planning
