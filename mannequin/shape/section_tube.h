// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::mannequin {

/// A cross-section of a tube: a closed curve about a centre, with a given extent in four directions. Metres.
struct TubeSection {
  double t = 0.0;             ///< Along the tube's axis from its origin.
  double u = 0.0, v = 0.0;    ///< Of the centre, off the axis.
  double half_breadth = 0.0;  ///< Along u, to both sides.
  double front = 0.0;         ///< Along v.
  double back = 0.0;          ///< Against v.
  double roundness = 2.0;     ///< 2: an ellipse; more: squarer.
};

/// Length of the curve of a section, m.
double perimeterOf(const TubeSection& section);
/// The section with its breadth and depth kept and the roundness (1.9 to 3.6) that is closest to a girth, then scaled
/// for the remainder.
TubeSection withGirth(TubeSection section, double girth);
/// The section with its depth and roundness kept, and the breadth that gives its girth.
TubeSection asBroadAs(TubeSection section, double girth);

/// A limb or a trunk: sections along an axis with a smooth surface through them, closed round at both ends.
class SectionTube {
 public:
  /// `axis` and `across` (u) are unit and perpendicular; v is axis x u. At least two sections with increasing t.
  SectionTube(const dvec3& origin, const dvec3& axis, const dvec3& across, std::vector<TubeSection> sections);

  /// Approximate distance (m) to the surface, negative inside; beyond 80 mm a lower bound.
  double distance(const dvec3& p) const;
  /// The section at t, clamped to the ends.
  TubeSection at(double t) const;
  geometry::Bounds bounds() const;
  const std::vector<TubeSection>& sections() const { return sections_; }
  const dvec3& across() const { return u_; }
  /// A point by its coordinates along the axis and across.
  dvec3 place(double t, double u, double v) const { return origin_ + t * axis_ + u * u_ + v * v_; }

 private:
  dvec3 origin_, axis_, u_, v_;
  std::vector<TubeSection> sections_;
  double most_ = 0.0;  ///< m from the axis, of any section.
};

}  // namespace hapticell::mannequin
