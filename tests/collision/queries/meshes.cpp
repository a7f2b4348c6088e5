// SPDX-License-Identifier: Apache-2.0
#include "tests/collision/queries/meshes.h"

#include <cmath>
#include <numbers>

namespace hapticell::test {

using geometry::TriangleMesh;

TriangleMesh boxMesh(const dvec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(0.5 * size * dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh sphereMesh(double radius, int bands, int sectors) {
  TriangleMesh mesh;
  mesh.vertices.push_back({0, 0, radius});
  for (int i = 1; i < bands; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const double polar = std::numbers::pi * i / bands, around = 2 * std::numbers::pi * j / sectors;
      mesh.vertices.push_back(
          radius * dvec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
    }
  }
  mesh.vertices.push_back({0, 0, -radius});
  const auto at = [&](int band, int sector) {
    return static_cast<std::uint32_t>(1 + (band - 1) * sectors + sector % sectors);
  };
  const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (int j = 0; j < sectors; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < bands; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.push_back({at(bands - 1, j + 1), at(bands - 1, j), south});
  }
  return mesh;
}

TriangleMesh sheetMesh(double size, int cells, double height) {
  TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double x = size * (static_cast<double>(i) / cells - 0.5), y = size * (static_cast<double>(j) / cells - 0.5);
      mesh.vertices.push_back({x, y, height * std::sin(7.0 * x / size) * std::cos(5.0 * y / size)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TriangleMesh soupMesh(std::mt19937& random, int triangles, double radius) {
  std::uniform_real_distribution<double> anywhere(-radius, radius);
  std::uniform_real_distribution<double> nearby(-0.2 * radius, 0.2 * radius);
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const dvec3 a(anywhere(random), anywhere(random), anywhere(random));
    const dvec3 b = a + dvec3(nearby(random), nearby(random), nearby(random));
    const double needle = i % 7 == 0 ? 1e-7 : 1.0;
    const dvec3 c = 0.5 * (a + b) + needle * dvec3(nearby(random), nearby(random), nearby(random));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh flipped(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

Pose randomPose(std::mt19937& random, double reach) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> anywhere(-reach, reach);
  const dquat q = glm::normalize(dquat(normal(random), normal(random), normal(random), normal(random)));
  return {{anywhere(random), anywhere(random), anywhere(random)}, q};
}

}  // namespace hapticell::test
