// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"
#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

/// The figure's body in a posture, for files: one closed surface in the world that blends over the joints, and the body
/// of each vertex, for its colour. Each body blends with its neighbours; the upper arms also blend with the trunk near
/// the shoulder, and the thighs with each other near the hip. It is computed for each posture from the placed flesh, so
/// joints cannot collapse. Takes about a second at 8 mm.
struct Skin {
  geometry::TriangleMesh mesh;
  std::vector<std::uint8_t> body_of_vertex;
};
Skin skinOf(const Figure& figure, const Posture& posture, double cell = 0.008);

}  // namespace hapticell::mannequin
