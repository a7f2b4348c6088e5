// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/contacts/contact_rows.h"

namespace hapticell::collision {

/// The largest deviation (m) between the quadric of a ring's row and the ring, over the places where the element counts
/// and where a ball could meet it whose centre moves up to `ball.reach`. `row_M` is the row's matrix in the mesh's
/// frame, `offset` that of the ball. Planes, spheres, cylinders and cones equal their quadrics. The quadric of a ring
/// is valid only near the foot, because the ring bends the other way around the tube.
double ringDeviation(const BallQuery& ball, const SurfaceElement& element, const dmat3& row_M);

}  // namespace hapticell::collision
