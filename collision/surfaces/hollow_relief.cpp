// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/hollow_relief.h"

#include <algorithm>

namespace hapticell::collision {
namespace {

// m that a hollow of the check's mesh is sunk at most (Contacts), as an importer's chords are off by 0.1 mm; the rest
// is taken off the gap. Half: pegs stay 0.05 mm freer; twice: coarse hollows are drawn entered by 0.2 mm.
constexpr double kMostRelief = 1e-4;
// m: a smaller sagitta is within kLeastClearance and not worth a second mesh. Half and twice differ by less than a
// check sees.
constexpr double kLeastRelief = 1e-7;
// A wider circle's chords stand in by more: R / (R - sagitta), at 5 % of R (kMiddleShare), and rounding. Half of the 6
// %: the coarsest hollows lock a peg; twice: hollows are wider by 6 % of their sagitta.
constexpr double kWidened = 1.06;

}  // namespace

double reliefOf(const SurfaceRegion& region) {
  const bool hollow = region.shape.type != SurfaceType::kFreeForm && region.shape.side < 0.0;
  return hollow && region.sagitta > kLeastRelief ? std::min(kWidened * region.sagitta, kMostRelief) : 0.0;
}

bool hasHollows(const RecognisedSurface& surface) {
  return std::any_of(surface.regions.begin(), surface.regions.end(),
                     [](const SurfaceRegion& region) { return reliefOf(region) > 0.0; });
}

geometry::TriangleMesh relievedMesh(const RecognisedSurface& surface) {
  geometry::TriangleMesh mesh = surface.mesh;
  for (const SurfaceRegion& region : surface.regions) {
    const double relief = reliefOf(region);
    if (relief <= 0.0) continue;
    for (const auto t : region.triangles) {
      for (const auto v : surface.mesh.triangles[t]) {
        const dvec3 n = viewFrom(region.shape, surface.mesh.vertices[v]).nhat_M;
        const double sunk = -glm::dot(n, mesh.vertices[v] - surface.mesh.vertices[v]);
        if (sunk < relief) mesh.vertices[v] -= (relief - sunk) * n;
      }
    }
  }
  return mesh;
}

}  // namespace hapticell::collision
