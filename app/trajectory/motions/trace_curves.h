// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/trajectory/motions/motion_list.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

/// The path of a motion's moved frame as lines in the scene, at most `most` points; its frames set by hand and the ends
/// as discs; where its check found something, pieces and discs in that colour (contact, limit, careful). `frame` is
/// marked with axes of `axis_length` (m).
std::vector<SceneCurve> traceCurves(const Motion& motion, std::size_t most, std::optional<std::size_t> frame,
                                    double axis_length);

}  // namespace hapticell::app
