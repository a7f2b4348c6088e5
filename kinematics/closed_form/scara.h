// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "kinematics/closed_form/closed_form.h"

namespace hapticell::kinematics {

/// Arms of class kScara: three parallel turning joints and a slide along them, in any order; two solutions. A tip that
/// is tilted against the axes is solved as if it were not: the caller must check the pose.
std::unique_ptr<const ClosedForm> makeScara(const ArmAxes& axes);

}  // namespace hapticell::kinematics
