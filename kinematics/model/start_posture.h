// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// A posture near the rest positions from which the tip can be drawn every way.
struct StartPosture {
  std::vector<double> q;                 ///< All variables of the model.
  std::vector<std::string> bent_joints;  ///< Those that differ from the rest positions, by at least 20 deg.
};

/// Where a robot without a home of its own should start: nothing where its rest positions are good, that is not
/// singular for the tip, or where bending one joint or two within their limits does not help (or nothing moves the
/// tip). The joints nearest to the tip are tried first.
std::optional<StartPosture> bentStart(const RobotModel& model, int tip_link);

}  // namespace hapticell::kinematics
