// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "trajectory/programs/reading/program_expression.h"

namespace hapticell::trajectory {

/// What RAPID defines by itself: `tool0`, `wobj0`, `pi`, `vmax`, `v100` and the like (lower case); unknown for any other name.
Value rapidWord(const std::string& name);

/// The value of a function of RAPID: `Offs`, `RelTool`, `CRobT`, `OrientZYX`, `PoseMult`, `PoseInv`, `Dim` and those of
/// numbers (`Abs`, `Sqrt`, `Sin` ... in degrees); `name` in lower case. `here`: where the robot is, if that is known. Unknown, with the
/// reason, for other functions and for arguments that are unknown.
Value rapidFunction(const std::string& name, const std::vector<Argument>& given, const std::optional<Pose>& here);

/// The argument `i` as a number, if it is one.
std::optional<double> rapidNumberAt(const std::vector<Argument>& given, std::size_t i);

}  // namespace hapticell::trajectory
