// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/hollow_relief.h"

#include <algorithm>

namespace hapticell::collision {
namespace {

constexpr double kMostRelief = 1e-4;   // m
constexpr double kLeastRelief = 1e-7;  // m
constexpr double kWidened = 1.06;      // a wider circle's chords stand in by more: R / (R - sagitta), at 5 % of R

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
