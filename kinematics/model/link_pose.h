// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// X_BL of one link, as forwardKinematics() gives it: only the joints between it and the base are gone through (of a
/// model with closed loops all of them).
Pose linkPose(const RobotModel& model, const std::vector<double>& q, int link);

}  // namespace hapticell::kinematics
