// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/closed_form/closed_form.h"

namespace hapticell::kinematics {

/// The canonical parameters of an arm with axes 2 and 3 parallel, axis 4 square to them, and axes 4 and 5 meeting.
struct OpwGeometry {
  explicit OpwGeometry(const ArmAxes& axes);

  kernels::OpwArm arm{};
  CanonicalFrames frames;  ///< To the frame of joint 6 with its origin in the wrist centre.
  dmat3 R_B0{1.0};         ///< Canonical base frame.
  dvec3 p_B0{0.0};
  dmat3 R_B4{1.0};     ///< At zero: z along axis 4, y along axis 5.
  dvec3 wrist_B{0.0};  ///< Where axes 4 and 5 meet at zero.
};

}  // namespace hapticell::kinematics
