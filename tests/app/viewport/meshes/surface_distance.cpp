// SPDX-License-Identifier: Apache-2.0
#include "tests/app/viewport/meshes/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::test {
namespace {

dvec3 nearestOfSide(const dvec3& p, const dvec3& a, const dvec3& b) {
  const double length2 = glm::dot(b - a, b - a);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
  return a + s * (b - a);
}

dvec3 nearestOf(const dvec3& p, const Corners& t) {
  const dvec3 n = glm::cross(t.b - t.a, t.c - t.a);
  const double n2 = glm::dot(n, n);
  if (n2 > 0.0) {
    const dvec3 foot = p - glm::dot(p - t.a, n) / n2 * n;
    const bool inside = glm::dot(glm::cross(t.b - t.a, foot - t.a), n) >= 0.0 &&
                        glm::dot(glm::cross(t.c - t.b, foot - t.b), n) >= 0.0 &&
                        glm::dot(glm::cross(t.a - t.c, foot - t.c), n) >= 0.0;
    if (inside) return foot;
  }
  dvec3 best = nearestOfSide(p, t.a, t.b);
  for (const dvec3& other : {nearestOfSide(p, t.b, t.c), nearestOfSide(p, t.c, t.a)})
    if (glm::distance(p, other) < glm::distance(p, best)) best = other;
  return best;
}

}  // namespace

std::vector<Corners> cornersOf(const app::DisplayMesh& mesh, std::size_t step) {
  std::vector<Corners> result;
  const auto at = [&](std::size_t i) { return dvec3(mesh.vertices[mesh.indices[i]].position); };
  const app::DetailStep& drawn = mesh.steps[step];
  for (std::size_t i = drawn.first; i < drawn.first + drawn.count; i += 3) {
    Corners t{at(i), at(i + 1), at(i + 2), {}, 0.0};
    t.middle = (t.a + t.b + t.c) / 3.0;
    t.radius = std::max({glm::distance(t.middle, t.a), glm::distance(t.middle, t.b), glm::distance(t.middle, t.c)});
    result.push_back(t);
  }
  return result;
}

dvec3 nearestOf(const dvec3& p, const std::vector<Corners>& surface) {
  dvec3 best(std::numeric_limits<double>::infinity());
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& t : surface) {
    if (glm::distance(p, t.middle) > least + t.radius) continue;
    const dvec3 q = nearestOf(p, t);
    const double distance = glm::distance(p, q);
    if (distance < least) least = distance, best = q;
  }
  return best;
}

std::vector<dvec3> pointsOf(const std::vector<Corners>& surface, std::size_t count) {
  double area = 0.0;
  const auto areaOf = [](const Corners& t) { return 0.5 * glm::length(glm::cross(t.b - t.a, t.c - t.a)); };
  for (const Corners& t : surface) area += areaOf(t);
  std::vector<dvec3> points;
  double due = 0.0;
  std::size_t number = 0;
  for (const Corners& t : surface) {
    points.push_back(t.middle);
    for (due += areaOf(t) / area * static_cast<double>(count); due >= 1.0; due -= 1.0, ++number) {
      double u = std::fmod(0.5 + 0.7548776662 * static_cast<double>(number), 1.0);
      double v = std::fmod(0.5 + 0.5698402910 * static_cast<double>(number), 1.0);
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      points.push_back(t.a + u * (t.b - t.a) + v * (t.c - t.a));
    }
  }
  return points;
}

}  // namespace hapticell::test
