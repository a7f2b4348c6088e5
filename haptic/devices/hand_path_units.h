// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/devices/hand_path.h"

namespace hapticell::haptic {

/// Converts a hand path to seconds from its beginning and to metres, as HandPath requires, and returns one sentence for
/// each assumption:
///  - times that begin at a clock's time (before 0, or later than both the path's duration and 1 s): counted from the
///    first
///    row; such times over 1e11 are a clock's milliseconds, over 1e14 microseconds, over 1e17 nanoseconds;
///  - a hundred rows or more, all at whole numbers, a second or more apart: milliseconds;
///  - positions over kFarthestStylus from the middle: millimetres. If they are still farther after that: an error.
///    Errors use `name` as the file. `samples` are in the order of time, at least one.
Expected<std::vector<Text>> recogniseHandUnits(std::vector<HandSample>& samples, const std::string& name);

/// m from the middle of the workspace along one axis: more than any stylus reaches. Half: paths of large devices are
/// refused or scaled; twice: a path of 0.6 to 1.2 mm in millimetres is taken for metres.
constexpr double kFarthestStylus = 0.6;

}  // namespace hapticell::haptic
