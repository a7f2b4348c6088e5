// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/system/assertion.h"

namespace hapticell::geometry {

namespace {

using glm::dvec2;

/// A closed profile (radius, z) turned about the z axis. Profile points with radius 0 become one vertex.
/// The profile runs so that outward lies on its right, looking along it in the (radius, z) half plane.
TriangleMesh revolve(std::span<const dvec2> profile, bool closed, int segments) {
  HAPTICELL_DEMAND(segments >= 3);
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(segments);
  std::vector<std::uint32_t> first;
  for (const dvec2& point : profile) {
    first.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    for (std::uint32_t k = 0; k < (point.x == 0.0 ? 1u : count); ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      mesh.vertices.emplace_back(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
    }
  }
  const std::size_t bands = closed ? profile.size() : profile.size() - 1;
  for (std::size_t band = 0; band < bands; ++band) {
    const std::size_t next = (band + 1) % profile.size();
    const bool pole_a = profile[band].x == 0.0, pole_b = profile[next].x == 0.0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t l = (k + 1) % count;
      const std::uint32_t a0 = first[band] + (pole_a ? 0 : k), a1 = first[band] + (pole_a ? 0 : l);
      const std::uint32_t b0 = first[next] + (pole_b ? 0 : k), b1 = first[next] + (pole_b ? 0 : l);
      if (!pole_a) mesh.triangles.push_back({a0, a1, b1});
      if (!pole_b) mesh.triangles.push_back({a0, b1, b0});
    }
  }
  return mesh;
}

double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool inTriangle(const dvec2& p, const dvec2& a, const dvec2& b, const dvec2& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

/// True when the corner `at` of what is left can be cut off: convex, and no other corner inside the ear.
bool isEar(std::span<const dvec2> outline, const std::vector<std::uint32_t>& left, std::size_t at) {
  const std::size_t n = left.size();
  const dvec2 &a = outline[left[(at + n - 1) % n]], &b = outline[left[at]], &c = outline[left[(at + 1) % n]];
  if (turn(a, b, c) <= 0.0) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const dvec2& p = outline[left[(at + k) % n]];
    if (p == a || p == b || p == c) continue;
    if (inTriangle(p, a, b, c)) return false;
  }
  return true;
}

}  // namespace

TriangleMesh makeBox(const dvec3& size) {
  HAPTICELL_DEMAND(size.x > 0.0 && size.y > 0.0 && size.z > 0.0);
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.push_back(0.5 * size * dvec3(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh makeCylinder(double radius, double height, int segments) {
  return makeFrustum(radius, radius, height, segments);
}

TriangleMesh makeCone(double radius, double height, int segments) {
  HAPTICELL_DEMAND(radius > 0.0 && height > 0.0);
  const dvec2 profile[] = {{0.0, -0.5 * height}, {radius, -0.5 * height}, {0.0, 0.5 * height}};
  return revolve(profile, false, segments);
}

TriangleMesh makeFrustum(double bottom, double top, double height, int segments) {
  HAPTICELL_DEMAND(bottom > 0.0 && top > 0.0 && height > 0.0);
  const dvec2 profile[] = {{0.0, -0.5 * height}, {bottom, -0.5 * height}, {top, 0.5 * height}, {0.0, 0.5 * height}};
  return revolve(profile, false, segments);
}

TriangleMesh makePipe(double outer_radius, double inner_radius, double height, int segments) {
  HAPTICELL_DEMAND(inner_radius > 0.0 && outer_radius > inner_radius && height > 0.0);
  const double z = 0.5 * height;
  const dvec2 profile[] = {{inner_radius, -z}, {outer_radius, -z}, {outer_radius, z}, {inner_radius, z}};
  return revolve(profile, true, segments);
}

TriangleMesh makeSphere(double radius, int segments) {
  HAPTICELL_DEMAND(radius > 0.0 && segments >= 4);
  const int bands = segments / 2;
  std::vector<dvec2> profile{{0.0, -radius}};
  for (int k = 1; k < bands; ++k) {
    const double angle = std::numbers::pi * k / bands;
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  profile.emplace_back(0.0, radius);
  return revolve(profile, false, segments);
}

TriangleMesh makeCapsule(double radius, double length, int segments) {
  HAPTICELL_DEMAND(radius > 0.0 && length > 0.0 && segments >= 4);
  const int quarter = std::max(segments / 4, 2);
  std::vector<dvec2> profile{{0.0, -radius - 0.5 * length}};
  for (const double end : {-1.0, 1.0}) {
    for (int k = end < 0.0 ? 1 : 0; k < quarter + (end < 0.0 ? 1 : 0); ++k) {
      const double angle = 0.5 * std::numbers::pi * k / quarter - (end < 0.0 ? 0.5 * std::numbers::pi : 0.0);
      profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle) + 0.5 * end * length);
    }
  }
  profile.emplace_back(0.0, radius + 0.5 * length);
  return revolve(profile, false, segments);
}

TriangleMesh makeTorus(double major_radius, double minor_radius, int major_segments, int minor_segments) {
  HAPTICELL_DEMAND(minor_radius > 0.0 && major_radius > minor_radius && minor_segments >= 3);
  std::vector<dvec2> profile;
  for (int k = 0; k < minor_segments; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / minor_segments;
    profile.emplace_back(major_radius + minor_radius * std::cos(angle), minor_radius * std::sin(angle));
  }
  return revolve(profile, true, major_segments);
}

std::vector<Triangle> triangulatePolygon(std::span<const dvec2> outline, std::uint64_t* work) {
  std::vector<std::uint32_t> left(outline.size());
  std::iota(left.begin(), left.end(), 0u);
  std::vector<Triangle> triangles;
  std::size_t tried = 0, at = 0;
  while (left.size() > 3 && tried < left.size()) {
    const std::size_t n = left.size();
    at %= n;
    if (work && *work < n) return {};
    if (work) *work -= n;
    if (!isEar(outline, left, at)) {
      ++at;
      ++tried;
      continue;
    }
    triangles.push_back({left[(at + n - 1) % n], left[at], left[(at + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    tried = 0;
  }
  if (left.size() != 3 || turn(outline[left[0]], outline[left[1]], outline[left[2]]) <= 0.0) return {};
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

TriangleMesh makePrism(std::span<const dvec2> outline, double height) {
  HAPTICELL_DEMAND(height > 0.0);
  const std::vector<Triangle> lid = triangulatePolygon(outline);
  TriangleMesh mesh;
  if (lid.empty()) return mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const dvec2& point : outline) mesh.vertices.emplace_back(point, 0.0);
  for (const dvec2& point : outline) mesh.vertices.emplace_back(point, height);
  for (const Triangle& t : lid) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t l = (k + 1) % n;
    mesh.triangles.push_back({k, l, l + n});
    mesh.triangles.push_back({k, l + n, k + n});
  }
  return mesh;
}

}  // namespace hapticell::geometry
