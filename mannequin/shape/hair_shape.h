// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/body/figure.h"

namespace hapticell::mannequin {

inline constexpr std::array<float, 3> kHairColor{0.21f, 0.16f, 0.13f};

/// Hair in the head's frame, a closed mesh of 5 to 13 mm around the skull, for drawing only: it shows the direction
/// that a figure faces. Short on men, down to the neck on women; our choice.
geometry::TriangleMesh hairMesh(const Figure& figure, double cell);

}  // namespace hapticell::mannequin
