// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/contacts/contact_rows.h"

namespace hapticell::collision {

/// A rod in the world.
struct PlacedRod {
  dvec3 a_W, b_W;
  double radius = 0.0;
  dvec3 n1_W, n2_W;
  double cosine = -1.0;
};

PlacedRod placed(const BodyRod& rod, const Pose& X_W);

/// Appends the group of two edges (or cylinders) that cross: the plane that keeps them apart and, as alternatives, the
/// places where one has passed the other's end. Parallel cylinders give one group for each end of their overlap.
/// Appends nothing if they cannot touch within the reach (m) or if other features of their bodies touch instead
/// (Gauss-map test: Gregorius, "The separating axis test between convex polyhedra", GDC 2013).
void appendCrossing(const PlacedRod& moving, const PlacedRod& obstacle, double reach, const ContactGroup& like,
                    std::vector<ContactGroup>& groups);

}  // namespace hapticell::collision
