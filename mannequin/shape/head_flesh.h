// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body/figure.h"
#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

inline constexpr std::array<float, 3> kSkinColor{0.80f, 0.62f, 0.52f};

/// Sizes for drawing a head, from the figure's measures; positions are relative to the point under the vertex at the
/// height of the eyes: x forward, y left, z up, in metres of a man of 1.755 m.
struct HeadMeasures {
  explicit HeadMeasures(const Figure& figure);
  dvec3 at(double x, double y, double z) const { return origin + scale * dvec3(x, y, z); }
  /// Of radii.
  double size() const { return scale.y; }

  dvec3 origin{0.0};  ///< In the head's frame.
  dvec3 scale{1.0};
  bool female = false;
};

/// Skull, jaw, nose, ears and sockets in the head's frame, in proportions of a grown-up; our choice.
Flesh headFlesh(const Figure& figure);

}  // namespace hapticell::mannequin
