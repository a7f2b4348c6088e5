// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

/// A place that a dragged part may snap to.
struct SnapPoint {
  Pose X_WS;     ///< Its point; axes as featureFrame_W() has them, or those of a frame.
  QString text;  ///< "Corner", "Frame grip of gripper".
};

/// The snap point under the pointer: a named frame or an origin before a corner, an edge or a face. Entities of
/// `without` are looked through.
std::optional<SnapPoint> snapAt(ViewportWidget& viewport, const QPointF& position,
                                const std::vector<workcell::EntityId>& without);

}  // namespace hapticell::app
