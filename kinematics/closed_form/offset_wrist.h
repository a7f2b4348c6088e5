// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "kinematics/closed_form/closed_form.h"

namespace hapticell::kinematics {

/// Arms of class kOffsetWrist: a search over joint 6 for all of up to 16 solutions.
///
/// The point where axes 4 and 5 meet is on a circle about axis 6; joints 1 to 3 follow in four branches, and one
/// equation is left, that axis 4 be square to axis 5. It is sampled where the circle is in reach and refined where it
/// bends, so that close pairs of roots are separated.
std::unique_ptr<const ClosedForm> makeOffsetWrist(const ArmAxes& axes);

}  // namespace hapticell::kinematics
