// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/closures/arm_builder.h"
#include "kinematics/closures/delta.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Properties of a Delta robot other than its lengths.
struct DeltaOptions {
  double ball_limit = 1.0;  ///< rad: greatest angle of a rod to the plane of its arm.
  /// The directions of the rods span at least this volume (1 if they are at right angles).
  double least_regular = 0.02;
  double tool_length = 0.0;  ///< m: from the platform's centre to tool0, away from the base.
};

/// The model of a Delta with three joints, or four: the last one then turns tool0 about z. Links base_link, arm_1 ..
/// arm_3 (frame at the motor axis, x along the arm, y along the axis), rod_1a .. rod_3b (frame at the knee, x to the
/// platform), platform, tool0. Inverse model "delta". Errors: invalid lengths, or lengths with which the robot cannot
/// be assembled at its home (all joints at 0, or `home`); not 3 or 4 joints.
Expected<RobotModel> buildDelta(const std::string& name, const DeltaGeometry& geometry, const DeltaOptions& options,
                                const std::vector<JointData>& joints, const std::vector<double>& home);

}  // namespace hapticell::kinematics
