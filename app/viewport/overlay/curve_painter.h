// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

// Pixels at 100 %. Points behind the eye are left out.

/// Paints the curve with its halo, without its text.
void paintCurve(QPainter& painter, const SceneCurve& curve, const Camera& camera, const ViewSize& size,
                const Theme& theme);

/// Paints the curve's text in a box of curveTextSize().
void paintCurveText(QPainter& painter, const SceneCurve& curve, const QRectF& box, const Theme& theme);
QSizeF curveTextSize(const SceneCurve& curve);
/// The end of the curve where its text is; empty if it has no text or the end is behind the eye.
std::optional<QPointF> curveTextPoint(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

/// The visible pieces of the curve.
std::vector<QPolygonF> seenRuns(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

/// The bounding box in the view of what paintCurve() paints; empty if nothing is visible.
QRectF curveBox(const SceneCurve& curve, const Camera& camera, const ViewSize& size);

}  // namespace hapticell::app
