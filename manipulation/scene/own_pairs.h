// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::manipulation {

/// A part that moves with a robot: a link's own shape, or a part attached to the link (a gripped part).
struct OwnPart {
  int link = 0;
  bool carried = false;
};

/// Two parts of one robot that are checked against each other: indices into a list of parts.
struct OwnPair {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// The pairs to check against each other, by the robot's structure alone. Left out: parts of one rigid body (links
/// joined by fixed joints); of the links' own shapes, those connected by one joint, and those that an SRDF or the maker
/// of the closure disabled. Two carried parts are not a pair: they were put together on purpose.
std::vector<OwnPair> ownPairs(const kinematics::RobotModel& model, std::span<const OwnPart> parts);

}  // namespace hapticell::manipulation
