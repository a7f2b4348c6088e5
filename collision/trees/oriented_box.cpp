// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::collision {

OrientedBox moved(const dmat3& R_AF, const dvec3& p_AF, const OrientedBox& box_F) {
  return {R_AF * box_F.R, p_AF + R_AF * box_F.center, box_F.half};
}

double lowerBoundSquared(const OrientedBox& a, const OrientedBox& b) {
  const dvec3 apart = b.center - a.center;
  double squared_a = 0.0;
  dvec3 reach(0.0);
  for (int i = 0; i < 3; ++i) {
    const dvec3 row(std::abs(glm::dot(a.R[i], b.R[0])), std::abs(glm::dot(a.R[i], b.R[1])),
                    std::abs(glm::dot(a.R[i], b.R[2])));
    reach += a.half[i] * row;
    const double gap = std::abs(glm::dot(a.R[i], apart)) - a.half[i] - glm::dot(row, b.half);
    if (gap > 0.0) squared_a += gap * gap;
  }
  double squared_b = 0.0;
  for (int j = 0; j < 3; ++j) {
    const double gap = std::abs(glm::dot(b.R[j], apart)) - b.half[j] - reach[j];
    if (gap > 0.0) squared_b += gap * gap;
  }
  return std::max(squared_a, squared_b);
}

double lowerBoundSquared(const OrientedBox& box, const dvec3& point) {
  const dvec3 apart = point - box.center;
  double squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double gap = std::abs(glm::dot(box.R[i], apart)) - box.half[i];
    if (gap > 0.0) squared += gap * gap;
  }
  return squared;
}

double lowerBoundSquared(const OrientedBox& box, const Corners& triangle) {
  const dvec3 apart = box.center - closestPointOnTriangle(triangle, box.center);
  double gap = std::numeric_limits<double>::infinity();
  for (const dvec3& corner : triangle) gap = std::min(gap, glm::dot(apart, box.center - corner));
  for (int i = 0; i < 3; ++i) gap -= box.half[i] * std::abs(glm::dot(box.R[i], apart));
  return gap > 0.0 ? gap * gap / glm::dot(apart, apart) : 0.0;
}

}  // namespace hapticell::collision
