// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

// Pixels at 100 %. What lies behind the eye is left out.

/// Paints the curve with its halo, without its text.
void paintCurve(QPainter& painter, const SceneCurve& curve, const Camera& camera, const ViewSize& size,
                const Theme& theme);

/// Paints the curve's text in a box of curveTextSize().
void paintCurveText(QPainter& painter, const SceneCurve& curve, const QRectF& box, const Theme& theme);
QSizeF curveTextSize(const SceneCurve& curve);
/// The end that its text stands beside; nothing where it has no text or the end is not before the eye.
std::optional<QPointF> curveTextPoint(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

/// The pieces of the curve that are seen.
std::vector<QPolygonF> seenRuns(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

/// The box of the view that holds what paintCurve() paints; empty where nothing is seen.
QRectF curveBox(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

}  // namespace hapticell::app
