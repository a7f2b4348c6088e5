// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <optional>

#include "geometry/shapes/pose.h"

class QMouseEvent;

namespace hapticell::app {

class ViewportWidget;

/// Whether what the viewport draws over the scene (the strip of views, the cube) is at this place of it, in pixels:
/// a click there is not one into the scene.
bool isOverViewControls(const ViewportWidget& viewport, const QPointF& position);

/// Where the floor (z = 0) is under this place of the viewport, in the cell. Nothing above the horizon, and farther
/// than 200 m along the ray.
std::optional<dvec3> floorPoint(const ViewportWidget& viewport, const QPointF& position);

/// Whether the left button is let go where it was pressed, not at the end of a drag.
bool endsClick(const QMouseEvent& event, const QPointF& pressed);

}  // namespace hapticell::app
