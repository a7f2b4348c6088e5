// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"
#include "geometry/shapes/pose.h"

namespace hapticell::app {

/// Arrows along three axes, rings about them, and a handle in the middle that moves freely, for dragging a pose: the
/// computation, no widgets. A value.
struct Gizmo {
  Pose X_WG;                                         ///< Its pose, with axes along the arrows.
  double size = 0.15;                                ///< m, length of an arrow; the radius of rings is 0.75 of it.
  bool arrows = true, rings = true, middle = false;  ///< The handles that it has.

  /// Handle::axis of the middle handle: it moves in the plane of the screen.
  static constexpr int kFree = 3;

  struct Handle {
    int axis = 0;  ///< 0, 1, 2: x, y, z; kFree.
    bool turns = false;
    bool operator==(const Handle& other) const { return axis == other.axis && turns == other.turns; }
  };
  /// The nearest handle within 8 pixels of a pixel; empty if no handle is near.
  std::optional<Handle> hit(const glm::dvec2& pixel, const Camera& camera, const ViewSize& view) const;

  /// The value along the axis of a handle (m) or about it (rad, from the zero direction of the ring) at which a ray
  /// points; empty if that is undefined (an axis seen from its end, a ring from its edge).
  std::optional<double> valueOf(const Handle& handle, const Ray& ray_W) const;

  /// The value of a point: its coordinate along the axis, or its angle about it; not for kFree.
  double valueAt(const Handle& handle, const dvec3& p_W) const;

  /// Where a ray meets the plane through the middle that is parallel to the screen.
  dvec3 freePoint_W(const Ray& ray_W, const Camera& camera) const;

  /// The pose X_WT after a drag of the gizmo's handle from one value to another.
  Pose dragged(const Handle& handle, double from, double to, const Pose& X_WT) const;

  /// The curves to draw; `active` is thicker.
  std::vector<SceneCurve> curves(const std::optional<Handle>& active) const;

 private:
  dvec3 axis_W(int axis) const;
  dvec3 zero_W(int axis) const;  ///< Perpendicular to the axis: where a ring's angle is 0.
  std::vector<dvec3> ring_W(int axis) const;
};

}  // namespace hapticell::app
