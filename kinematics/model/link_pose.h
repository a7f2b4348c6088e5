// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// X_BL of one link, as from forwardKinematics(): evaluates only the joints between the base and the link (in a model
/// with closed loops, all).
Pose linkPose(const RobotModel& model, const std::vector<double>& q, int link);

}  // namespace hapticell::kinematics
