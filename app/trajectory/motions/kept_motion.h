// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::app {

/// Measures on a file what was asked of the motion in it (trajectory/checks/motion_promises.h).
using MeasureMotion = std::function<Expected<Promises>(const std::filesystem::path& written)>;

/// The promise that a motion misses, as its file would be read back: written aside, read, measured and removed. Nothing
/// where all are kept. Any thread.
std::optional<Promise> missedPromise(const trajectory::Trajectory& made, const MeasureMotion& measure);

}  // namespace hapticell::app
