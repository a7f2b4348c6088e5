// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// A figure as a tree of links and joints, so that it is drawn and checked like a robot.
///
/// The root link is on the floor under the standing figure and moves with the pelvis. The variables are the 56 degrees
/// of freedom, in the order of Dof, then the gaze's yaw and pitch, which turn the eyes; fingers follow their curl as
/// mimic joints. Links have H-Anim names and the generated body: fine meshes for display, coarser ones for checks.
inline constexpr std::size_t kModelVariables = kDofCount + 2;
std::shared_ptr<const kinematics::RobotModel> figureModel(const Figure& figure);

/// The root link's frame E in the pelvis's frame R.
Pose rootInPelvis(const Figure& figure);

/// Converts a posture to the pose of the root link and joint positions, and back.
struct ModelConfiguration {
  Pose X_WE;
  std::vector<double> joints;
};
ModelConfiguration toModel(const Figure& figure, const Posture& posture);
Posture toPosture(const Figure& figure, const ModelConfiguration& configuration);

/// Which body (see fleshOf()) a link of the model is; -1 for links that only carry a joint.
int bodyOfLink(const kinematics::RobotModel& model, int link);

}  // namespace hapticell::mannequin
