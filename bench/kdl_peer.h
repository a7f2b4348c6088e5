// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/kinematics_figures.h"

namespace hapticell::bench {

/// KDL's Newton-Raphson with joint limits and its Levenberg-Marquardt, one shot from the middle of the limits.
void kdlFromMiddle(const char* robot, const kinematics::RobotModel& model, int poses);

}  // namespace hapticell::bench
