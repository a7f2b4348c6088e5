// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

/// The view of a drawing: parallel projection, along -(right x up).
struct OutlineView {
  dvec3 right_W{1.0, 0.0, 0.0};  ///< Unit, across the drawing.
  dvec3 up_W{0.0, 0.0, 1.0};     ///< Unit, up the drawing.
  /// From the figure's right and a little in front: shows trunk and arm best.
  static OutlineView besides(const Posture& posture, double turn = 0.6);
};

/// One body of the figure in this view: the shapes whose union it is, in metres along `right` and `up`.
struct OutlinePart {
  std::size_t body = 0;  ///< Index as in fleshOf().
  double depth = 0.0;    ///< m towards the viewer.
  std::vector<std::vector<glm::dvec2>> shapes{};
};

/// The figure as flat convex shapes, furthest first: a line drawing for panels, reports and files, without OpenGL.
/// `flesh` is fleshOf(figure). Fingers are omitted. Well under a millisecond.
std::vector<OutlinePart> outlineOf(const Figure& figure, const Posture& posture, const std::vector<Flesh>& flesh,
                                   const OutlineView& view);

}  // namespace hapticell::mannequin
