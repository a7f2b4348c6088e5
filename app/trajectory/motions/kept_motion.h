// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::app {

/// Measures whether the motion in a file meets what was asked (trajectory/checks/motion_promises.h).
using MeasureMotion = std::function<Expected<Promises>(const std::filesystem::path& written)>;

/// The promise that a motion would miss if its file were read back: writes a temporary file, reads and measures it, and
/// removes it. Empty if all promises are kept. Any thread.
std::optional<Promise> missedPromise(const trajectory::Trajectory& made, const MeasureMotion& measure);

}  // namespace hapticell::app
