// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/stylus_mesh.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/viewport/scene/pen_look.h"

namespace hapticell::app {
namespace {

constexpr int kAround = 28;

/// Turns a profile of (radius, height) about z; rises from the first to the last.
geometry::TriangleMesh lathe(const std::vector<std::pair<double, double>>& profile) {
  geometry::TriangleMesh mesh;
  for (const auto& [radius, height] : profile)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kAround;
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

/// A pen with so many bands in its middle.
StylusMesh withBands(int bands) {
  constexpr double kBody = 0.068, kBand = 0.0695, kFirst = 0.44, kLast = 0.56;
  const std::vector<std::pair<double, double>> lower{{0.0005, 0.0}, {0.012, 0.004}, {0.018, 0.02},
                                                     {0.058, 0.20}, {0.066, 0.26},  {kBody, kFirst}};
  const std::vector<std::pair<double, double>> upper{
      {kBody, kLast}, {0.062, 0.90}, {0.055, 0.96}, {0.036, 0.99}, {0.001, 1.0}};
  geometry::TriangleMesh body = lathe(lower), rings;
  geometry::append(body, lathe(upper), Pose::identity());
  const int pieces = 2 * bands - 1;
  const double height = (kLast - kFirst) / pieces;
  for (int i = 0; i < pieces; ++i) {
    const bool is_band = i % 2 == 0;
    const double radius = is_band ? kBand : kBody, from = kFirst + i * height;
    geometry::append(is_band ? rings : body, lathe({{radius, from}, {radius, from + height}}), Pose::identity());
  }
  return {leaning(std::move(body)), leaning(std::move(rings))};
}

}  // namespace

dvec3 stylusDirection_S() {
  return glm::normalize(dvec3(0.62, -0.38, 0.68));
}

StylusMesh makeStylusMesh() {
  return withBands(1);
}

StylusMesh makeSecondStylusMesh() {
  return withBands(2);
}

std::array<float, 3> penColor(bool second, bool dark_theme) {
  if (second) return dark_theme ? std::array{0.86f, 0.66f, 0.38f} : std::array{0.63f, 0.40f, 0.16f};
  return dark_theme ? std::array{0.96f, 0.96f, 0.96f} : std::array{0.16f, 0.18f, 0.21f};
}

}  // namespace hapticell::app
