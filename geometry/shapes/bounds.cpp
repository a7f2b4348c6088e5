// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/bounds.h"

#include <vector>

#include "geometry/system/in_parallel.h"

namespace hapticell::geometry {

void Bounds::add(const dvec3& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

void Bounds::add(const Bounds& other) {
  min = glm::min(min, other.min);
  max = glm::max(max, other.max);
}

Bounds boundsOf(std::span<const dvec3> points) {
  // Points for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 500'000;
  std::vector<Bounds> of_ranges(rangesOf(points.size(), kLeast));
  inRanges(points.size(), of_ranges.size(), [&](std::size_t range, std::size_t first, std::size_t last) {
    Bounds bounds;
    for (std::size_t k = first; k < last; ++k) bounds.add(points[k]);
    of_ranges[range] = bounds;
  });
  Bounds whole;
  for (const Bounds& bounds : of_ranges) whole.add(bounds);
  return whole;
}

Bounds transformed(const Pose& X_AB, const Bounds& bounds_B) {
  if (bounds_B.isEmpty()) return {};
  const dmat3 R = X_AB.R();
  const dvec3 half = 0.5 * bounds_B.size();
  const dvec3 center = X_AB * bounds_B.center();
  const dvec3 extent = glm::abs(R[0]) * half.x + glm::abs(R[1]) * half.y + glm::abs(R[2]) * half.z;
  return {center - extent, center + extent};
}

}  // namespace hapticell::geometry
