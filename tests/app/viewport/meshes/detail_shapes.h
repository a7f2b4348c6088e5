// SPDX-License-Identifier: Apache-2.0
// Parts on which simplifiers fail: holes and pockets in plates, open sheets.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/shapes/shapes.h"

namespace hapticell::test {

/// A plate of `side` m and `thickness` m, closed, with `holes` x `holes` round holes of that radius: through it, or, as
/// pockets, halfway down with floors.
inline geometry::TriangleMesh platesWithHoles(double side, double thickness, int holes, double radius, bool pockets) {
  constexpr int kRound = 32;
  geometry::TriangleMesh mesh;
  const auto vertex = [&](const dvec3& p) {
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  const auto quad = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c), l = vertex(d);
    mesh.triangles.push_back({i, j, k});
    mesh.triangles.push_back({i, k, l});
  };
  const double cell = side / holes, top = 0.5 * thickness, bottom = pockets ? 0.0 : -top;
  for (int column = 0; column < holes; ++column) {
    for (int row = 0; row < holes; ++row) {
      const dvec3 middle((column + 0.5) * cell - 0.5 * side, (row + 0.5) * cell - 0.5 * side, 0.0);
      const auto ring = [&](int i, double z) {
        const double angle = 2.0 * std::numbers::pi * i / kRound;
        return middle + dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
      };
      const auto square = [&](int i, double z) {
        const double angle = 2.0 * std::numbers::pi * i / kRound;
        const double out = 0.5 * cell / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
        return middle + dvec3(out * std::cos(angle), out * std::sin(angle), z);
      };
      for (int i = 0; i < kRound; ++i) {
        quad(ring(i, top), square(i, top), square(i + 1, top), ring(i + 1, top));
        quad(ring(i, bottom), ring(i, top), ring(i + 1, top), ring(i + 1, bottom));
        if (pockets) {
          quad(middle + dvec3(0, 0, bottom), ring(i, bottom), ring(i + 1, bottom), middle + dvec3(0, 0, bottom));
          quad(square(i + 1, -top), square(i, -top), middle - dvec3(0, 0, top), middle - dvec3(0, 0, top));
        } else {
          quad(square(i, -top), ring(i, -top), ring(i + 1, -top), square(i + 1, -top));
        }
      }
    }
  }
  const double half = 0.5 * side;
  for (int i = 0; i < holes * kRound / 4; ++i) {
    // Fine enough to meet the cells' borders somewhere: drawn parts are soups.
    const double x = half - side * i / (holes * kRound / 4), next = x - side / (holes * kRound / 4);
    quad({x, half, -top}, {next, half, -top}, {next, half, top}, {x, half, top});
    quad({next, -half, -top}, {x, -half, -top}, {x, -half, top}, {next, -half, top});
    quad({half, next, -top}, {half, x, -top}, {half, x, top}, {half, next, top});
    quad({-half, x, -top}, {-half, next, -top}, {-half, next, top}, {-half, x, top});
  }
  geometry::weld(mesh, 1e-9);
  return mesh;
}

/// Half of a tube, open at its ends and along two lines.
inline geometry::TriangleMesh openSheet() {
  geometry::TriangleMesh mesh;
  constexpr int kAround = 64, kAlong = 40;
  for (int i = 0; i <= kAround; ++i)
    for (int j = 0; j <= kAlong; ++j) {
      const double angle = std::numbers::pi * i / kAround;
      mesh.vertices.emplace_back(0.2 * std::cos(angle), 0.01 * j, 0.2 * std::sin(angle));
    }
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (std::uint32_t j = 0; j < kAlong; ++j) {
      const std::uint32_t a = i * (kAlong + 1) + j, b = a + kAlong + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace hapticell::test
