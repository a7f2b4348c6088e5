// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// The whole figure's body in a posture as files have it: one closed surface in the world that
/// flows over the joints (each body blends with those it is jointed to, upper
/// arms by the shoulder with the trunk and thighs by the hip with each other too), and the body that each vertex
/// belongs to, for its colour.
/// Made anew for each posture from the placed flesh, so nothing can collapse at
/// a joint. Takes about a second at 8 mm.
struct Skin {
  geometry::TriangleMesh mesh;
  std::vector<std::uint8_t> body_of_vertex;
};
Skin skinOf(const Figure& figure, const Posture& posture, double cell = 0.008);

}  // namespace hapticell::mannequin
