// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

/// One visible face of the view cube.
struct ViewCubeFace {
  StandardView view{};
  const char* name = "";  ///< "FRONT"
  dvec3 normal_W{0.0};
  std::array<glm::dvec2, 4>
      corners{};        ///< Pixels; in reading order of the name: top left, top right, bottom right, bottom left.
  double facing = 0.0;  ///< 1 if seen from straight ahead, 0 edge-on.
};

/// The meaning of a click on the cube: the direction from the cube's middle to the face, edge or corner that was hit,
/// with components -1, 0 or 1. The camera then looks in the opposite direction.
using ViewCubeSpot = dvec3;

/// The cube in the corner of the viewport that shows and sets the viewing direction. Arithmetic only.
class ViewCube {
 public:
  /// `center` in pixels of the viewport, `half_edge` half the cube's edge in pixels.
  ViewCube(const glm::dvec2& center, double half_edge) : center_(center), half_edge_(half_edge) {}

  /// The faces that are turned to the eye (at most three).
  std::vector<ViewCubeFace> visibleFaces(const Camera& camera) const;
  /// Position in the viewport of a point of the cube (components within -1 to 1).
  glm::dvec2 project(const dvec3& point, const Camera& camera) const;
  /// The face, edge or corner under a pixel; empty outside the cube.
  std::optional<ViewCubeSpot> pick(const glm::dvec2& pixel, const Camera& camera) const;
  /// Areas of a spot on the visible faces, four corners each: the middle of a face, both sides of an edge, or the three
  /// of a corner.
  std::vector<std::array<glm::dvec2, 4>> patches(const ViewCubeSpot& spot, const Camera& camera) const;
  const glm::dvec2& center() const { return center_; }
  double halfEdge() const { return half_edge_; }

 private:
  glm::dvec2 center_;
  double half_edge_;
};

}  // namespace hapticell::app
