// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/body/figure.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

// Features of a face besides its flesh, for drawing only. Our own shapes.

/// A mesh with its colour, sRGB.
struct FacePiece {
  std::array<float, 3> color{};
  geometry::TriangleMesh mesh;
};

/// Where an eye turns, head frame.
dvec3 eyeCentre(const Figure& figure, Side side);

/// White, iris and pupil of an eye that looks along +x, about its centre.
std::vector<FacePiece> eyePieces(const Figure& figure);

/// Lids, brows and lips in the head's frame. They do not move.
std::vector<FacePiece> facePieces(const Figure& figure);

/// The rotation of the head's frame into that of an eye that looks along the gaze.
dmat3 eyeRotation(const Gaze& gaze);

}  // namespace hapticell::mannequin
