// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::collision {

bool meetsBox(const Ray& ray, const OrientedBox& box, double farthest, double& entry) {
  const dvec3 apart = ray.origin - box.center;
  double near = 0.0, far = farthest;
  for (int i = 0; i < 3; ++i) {
    const double start = glm::dot(box.R[i], apart), speed = glm::dot(box.R[i], ray.direction);
    if (std::abs(speed) < 1e-300) {
      if (std::abs(start) > box.half[i]) return false;
      continue;
    }
    const double t0 = (-box.half[i] - start) / speed, t1 = (box.half[i] - start) / speed;
    // Widened a little: rounding must not lose a flat box that the ray just meets.
    near = std::max(near, std::min(t0, t1) - 1e-12 * std::abs(t0));
    far = std::min(far, std::max(t0, t1) + 1e-12 * std::abs(t1));
  }
  entry = near;
  return near <= far;
}

RayCrossing meetTriangle(const Ray& ray, const Corners& corners) {
  const dvec3 a = corners[0] - ray.origin, b = corners[1] - ray.origin, c = corners[2] - ray.origin;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double u = glm::dot(ray.direction, glm::cross(b, c));
  const double v = glm::dot(ray.direction, glm::cross(c, a));
  const double w = glm::dot(ray.direction, glm::cross(a, b));
  const double whole = u + v + w;
  const double longest = std::sqrt(std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)}));
  const double noise = 1e-14 * longest * longest * glm::length(ray.direction);
  RayCrossing crossing;
  const bool all_positive = u > noise && v > noise && w > noise;
  const bool all_negative = u < -noise && v < -noise && w < -noise;
  if (!all_positive && !all_negative) {
    const bool clearly_outside = (u < -noise || v < -noise || w < -noise) && (u > noise || v > noise || w > noise);
    crossing.grazes = !clearly_outside;
    // On the line of an edge, but with the whole triangle behind the origin, nothing is met.
    if (crossing.grazes) {
      const double foremost =
          std::max({glm::dot(a, ray.direction), glm::dot(b, ray.direction), glm::dot(c, ray.direction)});
      crossing.grazes = foremost >= 0.0;
    }
    const bool is_edge_on = std::abs(whole) <= 3.0 * noise;
    const double along = is_edge_on ? -1.0 : glm::dot(a, normal) / whole;
    crossing.along = crossing.grazes && along >= 0.0 ? along : std::numeric_limits<double>::infinity();
    return crossing;
  }
  crossing.along = glm::dot(a, normal) / whole;
  crossing.meets = crossing.along >= 0.0;
  crossing.leaving = whole > 0.0;
  return crossing;
}

}  // namespace hapticell::collision
