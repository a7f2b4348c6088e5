// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/stylus_mesh.h"

#include <cmath>
#include <utility>
#include <vector>

namespace hapticell::app {
namespace {

constexpr int kAround = 28;

/// Turns a profile of (radius, height) about z; rises from the first to the last.
geometry::TriangleMesh lathe(const std::vector<std::pair<double, double>>& profile) {
  geometry::TriangleMesh mesh;
  for (const auto& [radius, height] : profile)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / kAround;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  const auto index = [](std::size_t ring, int i) {
    return static_cast<std::uint32_t>(ring * kAround + static_cast<std::size_t>(i % kAround));
  };
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
    for (int i = 0; i < kAround; ++i) {
      mesh.triangles.push_back({index(ring, i), index(ring, i + 1), index(ring + 1, i + 1)});
      mesh.triangles.push_back({index(ring, i), index(ring + 1, i + 1), index(ring + 1, i)});
    }
  return mesh;
}

std::shared_ptr<const geometry::TriangleMesh> leaning(geometry::TriangleMesh upright) {
  const dvec3 d = stylusDirection_S();
  const dquat q = quaternionFromRotationVector(std::acos(d.z) * glm::normalize(glm::cross(dvec3(0, 0, 1), d)));
  auto result = std::make_shared<geometry::TriangleMesh>();
  geometry::append(*result, upright, Pose::rotation(q));
  return result;
}

}  // namespace

dvec3 stylusDirection_S() {
  return glm::normalize(dvec3(0.62, -0.38, 0.68));
}

StylusMesh makeStylusMesh() {
  const std::vector<std::pair<double, double>> lower{{0.0005, 0.0}, {0.012, 0.004}, {0.018, 0.02},
                                                     {0.058, 0.20}, {0.066, 0.26},  {0.068, 0.44}};
  const std::vector<std::pair<double, double>> band{{0.0695, 0.44}, {0.0695, 0.56}};
  const std::vector<std::pair<double, double>> upper{
      {0.068, 0.56}, {0.062, 0.90}, {0.055, 0.96}, {0.036, 0.99}, {0.001, 1.0}};
  geometry::TriangleMesh body = lathe(lower);
  geometry::append(body, lathe(upper), Pose::identity());
  return {leaning(std::move(body)), leaning(lathe(band))};
}

}  // namespace hapticell::app
