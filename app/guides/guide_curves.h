// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/scene/scene_curve.h"
#include "workcell/entity/guide.h"

namespace hapticell::app {

/// The curves that show a guide in the scene: axis, circle, arc of a hinge from stop to stop with its detents, outline
/// of a plane, path and rings of a tube, locked and free axes. Dash-dot in the guide's colour; stops are marked at the
/// ends.
///
/// `p_WMoved` is the origin of the guided entity's moved frame: a hinge's arc runs through it. `named`: draws the
/// guide's name too.
std::vector<SceneCurve> guideCurves(const workcell::Guide& guide, const dvec3& p_WMoved, bool named);

}  // namespace hapticell::app
