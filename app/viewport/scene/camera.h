// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "geometry/shapes/bounds.h"

namespace hapticell::app {

/// Pixels of the viewport, origin at the top left, y down.
struct ViewSize {
  double width = 1.0;
  double height = 1.0;
};

struct Ray {
  dvec3 origin_W{0.0};
  dvec3 direction_W{0.0, 0.0, 1.0};  ///< Unit.
};

enum class StandardView { kFront, kBack, kRight, kLeft, kTop, kBottom, kIsometric };

/// Position of the eye: a turntable about a target with Z up. A value; all computations of the view, no OpenGL.
///
/// Azimuth 0 looks along +Y (front); positive moves the eye to the right (towards +X). Elevation is that of the eye
/// above the target, within ±90 degrees. Screen axes: x to the right, y up, z towards the eye.
class Camera {
 public:
  dvec3 target_W{0.0};
  double azimuth = 0.6;         ///< rad
  double elevation = 0.45;      ///< rad
  double distance = 4.0;        ///< m, from the eye to the target.
  double field_of_view = 0.61;  ///< rad, vertical; also gives the size of the orthographic view at the target.
  bool perspective = true;

  dvec3 eye_W() const;
  dvec3 right_W() const;
  dvec3 up_W() const;
  dvec3 forward_W() const;  ///< Unit, from the eye into the scene.

  glm::dmat4 viewMatrix() const;
  /// Depth range that just encloses `scene_W`, for the best depth precision.
  glm::dmat4 projectionMatrix(const ViewSize& size, const geometry::Bounds& scene_W) const;

  /// Pixel of a point; empty if it is behind the eye.
  std::optional<glm::dvec2> project(const dvec3& p_WQ, const ViewSize& size) const;
  Ray rayThrough(const glm::dvec2& pixel, const ViewSize& size) const;
  /// Metres in the cell that one pixel covers at a point.
  double metresPerPixel(const dvec3& p_WQ, const ViewSize& size) const;

  /// Turns by a drag of so many pixels about a pivot, which keeps its position in the picture.
  void orbit(const glm::dvec2& pixels, const dvec3& pivot_W);
  /// Shifts so that a point at the depth of `p_WQ` follows the cursor.
  void pan(const glm::dvec2& pixels, const dvec3& p_WQ, const ViewSize& size);
  /// Moves the eye by a factor (< 1: nearer) so that `p_WQ` keeps its pixel.
  void zoom(double factor, const dvec3& p_WQ);

  /// The same direction, moved until the box fills the view except for a margin. An empty box changes nothing.
  Camera fitted(const geometry::Bounds& bounds_W, const ViewSize& size) const;
  /// The same for points: the nearest position of the eye from which all are visible.
  Camera fitted(const std::vector<dvec3>& points_W, const ViewSize& size) const;
  Camera turnedTo(StandardView view) const;
  /// The eye at one point, looking at another one, as stored for saved views. Coincident points change nothing.
  Camera looking(const dvec3& p_WEye, const dvec3& p_WTarget) const;
  /// Looking along a direction (from the eye into the scene, W).
  Camera turnedTo(const dvec3& direction_W) const;
};

/// The camera between two, `s` in [0, 1]; turns in the shorter direction.
Camera interpolate(const Camera& from, const Camera& to, double s);

/// Eases in and out: 0 at 0, 1 at 1, zero slope at both ends.
double eased(double s);

}  // namespace hapticell::app
