// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/placed_bounds.h"

#include <cmath>

namespace hapticell::collision {

PlacedBounds placedBounds(const MeshCollider& mesh, const Pose& X_WM) {
  PlacedBounds at;
  const dmat3 R = X_WM.R();
  at.center_W = X_WM.p + R * mesh.center();
  at.radius = mesh.radius();
  if (mesh.isEmpty()) return at;
  at.root_W = moved(R, X_WM.p, mesh.tree().box(BoxTree::kRoot));
  for (int i = 0; i < 3; ++i) at.reach_W += at.root_W.half[i] * glm::abs(at.root_W.R[i]);
  return at;
}

double sphereGap(const PlacedBounds& a, const PlacedBounds& b) {
  return glm::distance(a.center_W, b.center_W) - a.radius - b.radius;
}

double boxGap(const PlacedBounds& a, const PlacedBounds& b) {
  return std::sqrt(lowerBoundSquared(a.root_W, b.root_W));
}

double sweptSphereGap(const PlacedBounds& a, const PlacedBounds& b, const dvec3& sweep_W) {
  const dvec3 apart = b.center_W - a.center_W;
  const double square = glm::dot(sweep_W, sweep_W);
  const double share = square > 0.0 ? glm::clamp(glm::dot(apart, sweep_W) / square, -1.0, 1.0) : 0.0;
  return glm::length(apart - share * sweep_W) - a.radius - b.radius;
}

double sweptBoxGap(const PlacedBounds& a, const PlacedBounds& b, const dvec3& sweep_W) {
  OrientedBox swept = a.root_W;
  for (int i = 0; i < 3; ++i) swept.half[i] += std::abs(glm::dot(swept.R[i], sweep_W));
  return std::sqrt(lowerBoundSquared(swept, b.root_W));
}

}  // namespace hapticell::collision
