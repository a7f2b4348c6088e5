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

/// Edges (or cylinders) that cross: a group of the plane that holds them apart and, as alternatives, of the places
/// where one has gone past the other's end. Parallel cylinders give such a group for either end of where they lie along
/// each other. Appends nothing where they cannot touch within the reach (m), or touch along other features of their
/// bodies (Gauss-map test: Gregorius, "The separating axis test between convex polyhedra", GDC 2013).
void appendCrossing(const PlacedRod& moving, const PlacedRod& obstacle, double reach, const ContactGroup& like,
                    std::vector<ContactGroup>& groups);

}  // namespace hapticell::collision
