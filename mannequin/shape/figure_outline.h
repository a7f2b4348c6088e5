// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

/// Where a drawing is looked from: parallel, along -(right x up).
struct OutlineView {
  dvec3 right_W{1.0, 0.0, 0.0};  ///< Unit, across the drawing.
  dvec3 up_W{0.0, 0.0, 1.0};     ///< Unit, up the drawing.
  /// Seen from the figure's right and a little in front of it: what shows trunk and arm best.
  static OutlineView besides(const Posture& posture, double turn = 0.6);
};

/// One body of the figure as seen from there: the shapes whose union it is, in metres along `right` and `up`.
struct OutlinePart {
  std::size_t body = 0;  ///< As fleshOf() counts them.
  double depth = 0.0;    ///< m towards the eye.
  std::vector<std::vector<glm::dvec2>> shapes{};
};

/// The figure as flat convex shapes, furthest first: a line drawing for panels, reports and files, without OpenGL.
/// `flesh` is fleshOf(figure). Fingers are left out. Well under a millisecond.
std::vector<OutlinePart> outlineOf(const Figure& figure, const Posture& posture, const std::vector<Flesh>& flesh,
                                   const OutlineView& view);

}  // namespace hapticell::mannequin
