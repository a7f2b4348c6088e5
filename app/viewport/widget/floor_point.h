// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <optional>

#include "geometry/shapes/pose.h"

class QMouseEvent;

namespace hapticell::app {

class ViewportWidget;

/// Whether a control that the viewport draws over the scene (the view strip, the cube) is at this position, in pixels:
/// a click there is not a click into the scene.
bool isOverViewControls(const ViewportWidget& viewport, const QPointF& position);

/// The point of the floor (z = 0) under this position of the viewport, in the cell. Empty above the horizon, and if
/// farther than 200 m along the ray.
std::optional<dvec3> floorPoint(const ViewportWidget& viewport, const QPointF& position);

/// Whether the left button is released where it was pressed, not at the end of a drag.
bool endsClick(const QMouseEvent& event, const QPointF& pressed);

}  // namespace hapticell::app
