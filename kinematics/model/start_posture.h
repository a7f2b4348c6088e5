// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// A posture near the rest positions from which the tip can move in every direction.
struct StartPosture {
  std::vector<double> q;                 ///< All variables of the model.
  std::vector<std::string> bent_joints;  ///< Those that differ from the rest positions, by at least 20 deg.
};

/// The start of a robot without a home. Empty if its rest positions are not singular for the tip, if bending one or two
/// joints within their limits does not help, or if nothing moves the tip. The joints nearest to the tip are tried
/// first.
std::optional<StartPosture> bentStart(const RobotModel& model, int tip_link);

}  // namespace hapticell::kinematics
