// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/contacts/contact_rows.h"

namespace hapticell::collision {

/// How far (m) the quadric of a ring's row is from the ring at most, where a ball whose centre goes `ball.reach` from
/// where it is could meet it and the element counts there. `row_M` is the row's matrix in the mesh's frame, `offset` of
/// the ball. Planes, spheres, cylinders and cones are their quadrics; of a ring it holds only near the foot, since
/// round the tube it bends the other way.
double ringDeviation(const BallQuery& ball, const SurfaceElement& element, const dmat3& row_M);

}  // namespace hapticell::collision
