// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

/// A point that a dragged part may snap to.
struct SnapPoint {
  Pose X_WS;     ///< Origin: the point; axes as featureFrame_W() has them, or those of a frame.
  QString text;  ///< "Corner", "Frame grip of gripper".
};

/// The snap point under the pointer: a named frame or an origin is preferred to a corner, an edge or a face. Looks
/// through the entities of `without`.
std::optional<SnapPoint> snapAt(ViewportWidget& viewport, const QPointF& position,
                                const std::vector<workcell::EntityId>& without);

}  // namespace hapticell::app
