// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// The parts of the drawn stylus in its own frame S: tip at the origin, the pen rises to the right and towards the
/// user, as a right hand holds it. The unit is the length of the pen.
struct StylusMesh {
  std::shared_ptr<const geometry::TriangleMesh> body;
  std::shared_ptr<const geometry::TriangleMesh> band;  ///< In the selection colour.
};

StylusMesh makeStylusMesh();

/// The unit direction of the pen, away from its tip, in S.
dvec3 stylusDirection_S();

}  // namespace hapticell::app
