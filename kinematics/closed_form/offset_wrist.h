// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "kinematics/closed_form/closed_form.h"

namespace hapticell::kinematics {

/// Arms of class kOffsetWrist: a search over joint 6 for all solutions, up to 16.
///
/// The intersection of axes 4 and 5 lies on a circle about axis 6. Joints 1 to 3 follow in four branches, and one
/// equation remains: axis 4 is perpendicular to axis 5. It is sampled where the circle is within reach, and refined
/// where it bends so that close pairs of roots are separated.
std::unique_ptr<const ClosedForm> makeOffsetWrist(const ArmAxes& axes);

}  // namespace hapticell::kinematics
