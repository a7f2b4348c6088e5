// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "mannequin/body_shape.h"
#include "mannequin/figure.h"
#include "mannequin/posture.h"

namespace hapticell::mannequin {

/// The whole figure's skin in a posture: one closed surface in the world that
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

/// The skin cut by colour along clean lines (cuffs, collar, belt), for drawing.
struct SkinPart {
  std::array<float, 3> color{};
  geometry::TriangleMesh mesh;
};
/// Which of it: hands from the cuffs on and the head from the collar on want finer cells than a body. They reach
/// some millimetres under what is worn there, so that no gap is seen.
enum class SkinRegion { kWhole, kBody, kHands, kHead };
/// `colors`: one for each body (kBodies) in place of its clothing; none: as clothed.
std::vector<SkinPart> skinParts(const Figure& figure, const Posture& posture, double cell, SkinRegion region,
                                std::span<const std::array<float, 3>> colors = {});
/// What a head has beside its skin: hair, brows, lids and lips (hair_shape.h, face_shape.h), and eyes that look where
/// the posture's gaze says. One part a colour.
std::vector<SkinPart> faceParts(const Figure& figure, const Posture& posture);

}  // namespace hapticell::mannequin
