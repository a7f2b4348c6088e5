// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/trajectory/motions/motion_list.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

/// The path of a motion's moved frame as lines in the scene, at most `most` points. Discs mark frames set by hand and
/// the ends; findings of its check are pieces and discs in their colour (contact, limit, careful). Axes of
/// `axis_length` (m) mark `frame`.
std::vector<SceneCurve> traceCurves(const Motion& motion, std::size_t most, std::optional<std::size_t> frame,
                                    double axis_length);

}  // namespace hapticell::app
