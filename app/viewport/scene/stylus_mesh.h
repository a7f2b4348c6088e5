// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// The parts of the drawn stylus in its own frame S, metres: tip at the origin, the pen rises to the right, towards the
/// user, as a right hand holds it. One metre of it is one length of the pen.
struct StylusMesh {
  std::shared_ptr<const geometry::TriangleMesh> body;
  std::shared_ptr<const geometry::TriangleMesh> band;  ///< In the selection colour.
};

StylusMesh makeStylusMesh();

/// The unit direction of the pen from its tip, in S.
dvec3 stylusDirection_S();

}  // namespace hapticell::app
