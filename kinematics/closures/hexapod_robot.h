// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/closures/arm_builder.h"
#include "kinematics/closures/hexapod.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Properties of a hexapod other than the positions of its hinges.
struct HexapodOptions {
  Pose X_BPHome;                ///< The platform in its home position.
  double swivel_limit = 1.0;    ///< rad: greatest angle of a leg to its direction at home, at either end.
  double least_regular = 0.02;  ///< As a share of det J at home: how close the platform may come to a singular surface.
  double tool_length = 0.0;     ///< m: from the platform's frame to tool0, along its z.
};

/// The model of a Gough-Stewart platform: six prismatic joints, whose positions are the leg lengths (m, hinge to
/// hinge). Links base_link, leg_1_lower .. leg_6_upper (z along the leg, from the base and from the platform
/// downwards), platform, tool0. Inverse model "hexapod". Errors: not six joints, coinciding hinges, a home that is
/// singular or whose lengths are outside the limits.
Expected<RobotModel> buildHexapod(const std::string& name, const HexapodGeometry& geometry,
                                  const HexapodOptions& options, const std::vector<JointData>& joints);

}  // namespace hapticell::kinematics
