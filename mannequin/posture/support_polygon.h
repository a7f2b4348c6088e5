// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {

/// The support of the figure, seen from above: the convex hull of both soles, counter-clockwise, metres in the world.
struct SupportPolygon {
  std::array<glm::dvec2, 12> points{};
  std::size_t count = 0;

  /// Distance (m) of a point inside its nearest edge; negative outside.
  double margin(const glm::dvec2& point) const;
};

/// Hull of the soles of feet at these poses (left, right). Feet in the air count as if on the floor: select by
/// `on_ground`.
SupportPolygon supportPolygon(const Figure& figure, const std::array<SegmentPlace, 2>& feet,
                              const std::array<bool, 2>& on_ground = {true, true});

/// The feet (left, right) that carry weight: a foot whose sole is a centimetre or more above the other's does not.
std::array<bool, 2> standingFeet(const Figure& figure, const FigurePose& pose);

}  // namespace hapticell::mannequin
