// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/camera.h"
#include "app/viewport/scene_curve.h"

namespace hapticell::app {

/// Paints the curve with its halo; what lies behind the eye is left out.
void paintCurve(QPainter& painter, const SceneCurve& curve, const Camera& camera, const ViewSize& size,
                const Theme& theme);

/// The box of the view that holds what paintCurve() paints; empty where nothing is seen.
QRectF curveBox(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

}  // namespace hapticell::app
