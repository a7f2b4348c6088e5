// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"
#include "geometry/shapes/pose.h"

namespace hapticell::app {

/// Arrows along three axes, rings about them, and a middle that moves freely, by which a pose is dragged: the
/// arithmetic, no widgets. A value.
struct Gizmo {
  Pose X_WG;                                         ///< Its pose; its axes are those of the arrows.
  double size = 0.15;                                ///< m, of an arrow; rings have 0.75 of it.
  bool arrows = true, rings = true, middle = false;  ///< Which handles it has.

  /// Handle::axis of the middle: it moves in the plane of the screen.
  static constexpr int kFree = 3;

  struct Handle {
    int axis = 0;  ///< 0, 1, 2: x, y, z; kFree.
    bool turns = false;
    bool operator==(const Handle& other) const { return axis == other.axis && turns == other.turns; }
  };
  /// The handle within 8 pixels of a pixel, the nearest of them; nothing beside all.
  std::optional<Handle> hit(const glm::dvec2& pixel, const Camera& camera, const ViewSize& view) const;

  /// How far along its axis (m) or about it (rad, against the zero direction of the ring) a ray points; nothing where
  /// it cannot be said (an axis seen from its end, a ring from its edge).
  std::optional<double> valueOf(const Handle& handle, const Ray& ray_W) const;

  /// The value of a point: how far along the axis, or in which direction about it, it lies; not for kFree.
  double valueAt(const Handle& handle, const dvec3& p_W) const;

  /// Where a ray meets the plane through the middle that the camera looks at squarely.
  dvec3 freePoint_W(const Ray& ray_W, const Camera& camera) const;

  /// What a drag from one value to another does to a pose at the gizmo's place.
  Pose dragged(const Handle& handle, double from, double to, const Pose& X_WT) const;

  /// To be drawn; `active` is thicker.
  std::vector<SceneCurve> curves(const std::optional<Handle>& active) const;

 private:
  dvec3 axis_W(int axis) const;
  dvec3 zero_W(int axis) const;  ///< Square to the axis: where a ring's angle is 0.
  std::vector<dvec3> ring_W(int axis) const;
};

}  // namespace hapticell::app
