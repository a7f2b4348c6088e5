// SPDX-License-Identifier: Apache-2.0
#include "tests/collision/surfaces/generated_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/shapes/shapes.h"

namespace hapticell::test {
namespace {

using collision::SurfaceType;
using glm::dvec2;

void addTriangle(GeneratedPart& part, const dvec3& a, const dvec3& b, const dvec3& c, SurfaceType type) {
  if (glm::length(glm::cross(b - a, c - a)) < 1e-14) return;
  const auto first = static_cast<std::uint32_t>(part.mesh.vertices.size());
  part.mesh.vertices.insert(part.mesh.vertices.end(), {a, b, c});
  part.mesh.triangles.push_back({first, first + 1, first + 2});
  part.truth.push_back(type);
}

void addQuad(GeneratedPart& part, const std::array<dvec3, 4>& q, SurfaceType type) {
  addTriangle(part, q[0], q[1], q[2], type);
  addTriangle(part, q[0], q[2], q[3], type);
}

/// An outline of points; the surface from point i to i + 1 has a type.
struct Outline {
  std::vector<dvec2> points;
  std::vector<SurfaceType> types;

  void lineTo(const dvec2& p, SurfaceType type) {
    types.push_back(type);
    points.push_back(p);
  }
  /// From the last point about `center` by `angle` (rad).
  void arc(const dvec2& center, double angle, int steps, SurfaceType type) {
    const dvec2 start = points.back() - center;
    for (int i = 1; i <= steps; ++i) {
      const double a = angle * i / steps;
      lineTo(
          center + dvec2(std::cos(a) * start.x - std::sin(a) * start.y, std::sin(a) * start.x + std::cos(a) * start.y),
          type);
    }
  }
};

/// Turned about z: x is the radius. The outline goes counter-clockwise about the material; it may end on the axis.
GeneratedPart turned(std::string name, const Outline& outline, int segments, std::vector<double> radii) {
  GeneratedPart part{std::move(name), {}, {}, std::move(radii)};
  const auto at = [&](const dvec2& p, int k) {
    const double a = 2.0 * std::numbers::pi * (k % segments) / segments;
    return dvec3(p.x * std::cos(a), p.x * std::sin(a), p.y);
  };
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i) {
    const dvec2 &p = outline.points[i], &q = outline.points[i + 1];
    for (int k = 0; k < segments; ++k)
      addQuad(part, {at(p, k), at(p, k + 1), at(q, k + 1), at(q, k)}, outline.types[i]);
  }
  return part;
}

/// Drawn up along z from a closed counter-clockwise outline.
GeneratedPart extruded(std::string name, const Outline& outline, double height, std::vector<double> radii) {
  GeneratedPart part{std::move(name), {}, {}, std::move(radii)};
  std::vector<dvec2> ring(outline.points.begin(), outline.points.end() - 1);  // closes itself
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i) {
    const dvec2 &p = outline.points[i], &q = outline.points[i + 1];
    addQuad(part, {dvec3(p, 0), dvec3(q, 0), dvec3(q, height), dvec3(p, height)}, outline.types[i]);
  }
  for (const auto& t : geometry::triangulatePolygon(ring)) {
    addTriangle(part, dvec3(ring[t[0]], height), dvec3(ring[t[1]], height), dvec3(ring[t[2]], height),
                SurfaceType::kPlane);
    addTriangle(part, dvec3(ring[t[0]], 0), dvec3(ring[t[2]], 0), dvec3(ring[t[1]], 0), SurfaceType::kPlane);
  }
  return part;
}

/// Latitudes and meridians of a sphere pulled apart at the three middle planes.
GeneratedPart roundedBox(std::string name, const dvec3& size, double radius, int quarter) {
  GeneratedPart part{std::move(name), {}, {}, {radius}};
  const dvec3 core = 0.5 * size - dvec3(radius);
  struct Place {
    double angle;
    double sign_a, sign_b;
  };
  std::vector<Place> around, up;
  for (int q = 0; q < 4; ++q) {
    for (int i = 0; i <= quarter; ++i) {
      const double sx = q == 0 || q == 3 ? 1.0 : -1.0, sy = q < 2 ? 1.0 : -1.0;
      around.push_back({0.5 * std::numbers::pi * (q + static_cast<double>(i) / quarter), sx, sy});
    }
  }
  for (int q = 0; q < 2; ++q) {
    for (int i = 0; i <= quarter; ++i)
      up.push_back({0.5 * std::numbers::pi * (q - 1 + static_cast<double>(i) / quarter), q == 0 ? -1.0 : 1.0, 0.0});
  }
  const auto at = [&](const Place& a, const Place& u) {
    const dvec3 n(std::cos(u.angle) * std::cos(a.angle), std::cos(u.angle) * std::sin(a.angle), std::sin(u.angle));
    return core * dvec3(a.sign_a, a.sign_b, u.sign_a) + radius * n;
  };
  for (std::size_t j = 0; j + 1 < up.size(); ++j) {
    const bool flat_up = up[j].angle == up[j + 1].angle;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Place &a = around[i], &b = around[(i + 1) % around.size()];
      const bool flat_around = std::abs(std::remainder(a.angle - b.angle, 2.0 * std::numbers::pi)) < 1e-9;
      SurfaceType type = flat_up || flat_around ? SurfaceType::kCylinder : SurfaceType::kSphere;
      if (flat_up && flat_around) type = SurfaceType::kPlane;
      addQuad(part, {at(a, up[j]), at(b, up[j]), at(b, up[j + 1]), at(a, up[j + 1])}, type);
    }
  }
  for (const auto& [row, turn] : {std::pair{up.front(), 1.0}, std::pair{up.back(), -1.0}}) {
    const auto q = static_cast<std::size_t>(quarter + 1);
    std::array<dvec3, 4> corners{at(around[0], row), at(around[q], row), at(around[2 * q], row),
                                 at(around[3 * q], row)};
    if (turn > 0.0) std::reverse(corners.begin(), corners.end());
    addQuad(part, corners, SurfaceType::kPlane);
  }
  return part;
}

/// One square cell of a plate, a bore in its middle; a countersink where `sink` > radius.
void addCell(GeneratedPart& part, const dvec2& middle, double half, double height, double radius, double sink) {
  constexpr int kSteps = 40;
  const double depth = sink > radius ? sink - radius : 0.0;
  const auto corner = [&](int k) { return middle + half * dvec2(k == 0 || k == 3 ? 1 : -1, k < 2 ? 1 : -1); };
  for (int k = 0; k < kSteps; ++k) {
    const double a0 = 2 * std::numbers::pi * k / kSteps, a1 = 2 * std::numbers::pi * ((k + 1) % kSteps) / kSteps;
    const dvec2 d0(std::cos(a0), std::sin(a0)), d1(std::cos(a1), std::sin(a1));
    const auto at = [&](const dvec2& d, double r, double z) { return dvec3(middle + r * d, z); };
    addQuad(part,
            {at(d1, radius, 0), at(d0, radius, 0), at(d0, radius, height - depth), at(d1, radius, height - depth)},
            SurfaceType::kCylinder);
    if (depth > 0.0) {
      addQuad(
          part,
          {at(d1, radius, height - depth), at(d0, radius, height - depth), at(d0, sink, height), at(d1, sink, height)},
          SurfaceType::kCone);
    }
    const double top = depth > 0.0 ? sink : radius;
    const int quarter = k / (kSteps / 4);
    const dvec3 c(corner(quarter), height), b(corner(quarter), 0);
    addTriangle(part, at(d0, top, height), c, at(d1, top, height), SurfaceType::kPlane);
    addTriangle(part, at(d0, radius, 0), at(d1, radius, 0), b, SurfaceType::kPlane);
    if (k % (kSteps / 4) == 0) {
      const dvec3 c0(corner((quarter + 3) % 4), height), b0(corner((quarter + 3) % 4), 0);
      addTriangle(part, at(d0, top, height), c0, c, SurfaceType::kPlane);
      addTriangle(part, at(d0, radius, 0), b, b0, SurfaceType::kPlane);
    }
  }
}

GeneratedPart plateWithBores() {
  GeneratedPart part{"plate", {}, {}, {0.004, 0.003}};
  constexpr double kHalf = 0.01, kHeight = 0.01;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      const bool small = (i + j) % 2 == 0;
      addCell(part, dvec2(0.02 * i, 0.02 * j), kHalf, kHeight, small ? 0.003 : 0.004, i == 1 ? 0.006 : 0.0);
    }
  }
  const auto wall = [&](const dvec2& a, const dvec2& b) {
    addQuad(part, {dvec3(a, 0), dvec3(b, 0), dvec3(b, kHeight), dvec3(a, kHeight)}, SurfaceType::kPlane);
  };
  for (int i = 0; i < 4; ++i) {
    wall({0.02 * i - kHalf, -kHalf}, {0.02 * i + kHalf, -kHalf});
    wall({0.02 * i + kHalf, 0.05}, {0.02 * i - kHalf, 0.05});
  }
  for (int j = 0; j < 3; ++j) {
    wall({0.07, 0.02 * j - kHalf}, {0.07, 0.02 * j + kHalf});
    wall({-kHalf, 0.02 * j + kHalf}, {-kHalf, 0.02 * j - kHalf});
  }
  return part;
}

GeneratedPart shaft() {
  Outline o{{{0, 0}}, {}};
  o.lineTo({0.010, 0}, SurfaceType::kPlane);
  o.lineTo({0.010, 0.04}, SurfaceType::kCylinder);
  o.lineTo({0.015, 0.04}, SurfaceType::kPlane);
  o.lineTo({0.015, 0.07}, SurfaceType::kCylinder);
  o.lineTo({0.008, 0.085}, SurfaceType::kCone);
  o.lineTo({0.008, 0.1}, SurfaceType::kCylinder);
  o.lineTo({0, 0.1}, SurfaceType::kPlane);
  return turned("shaft", o, 42, {0.010, 0.015, 0.008});
}

GeneratedPart roundedBore() {
  Outline o{{{0.010, 0}}, {}};
  o.lineTo({0.03, 0}, SurfaceType::kPlane);
  o.lineTo({0.03, 0.03}, SurfaceType::kCylinder);
  o.lineTo({0.014, 0.03}, SurfaceType::kPlane);
  o.arc({0.014, 0.026}, 0.5 * std::numbers::pi, 6, SurfaceType::kTorus);
  o.lineTo({0.010, 0}, SurfaceType::kCylinder);
  return turned("rounded bore", o, 44, {0.010, 0.03, 0.004});
}

GeneratedPart torus() {
  Outline o{{{0.06, 0}}, {}};
  o.arc({0.05, 0}, 2.0 * std::numbers::pi, 30, SurfaceType::kTorus);
  o.points.back() = o.points.front();
  return turned("torus", o, 110, {0.010});
}

GeneratedPart ball() {
  Outline o{{{0, -0.005}}, {}};
  o.arc({0, 0}, std::numbers::pi, 14, SurfaceType::kSphere);
  o.points.back() = {0, 0.005};
  return turned("sphere", o, 28, {0.005});
}

GeneratedPart bracket(double fillet) {
  Outline o{{{0, 0}}, {}};
  o.lineTo({0.06, 0}, SurfaceType::kPlane);
  o.lineTo({0.06, 0.01}, SurfaceType::kPlane);
  o.lineTo({0.01 + fillet, 0.01}, SurfaceType::kPlane);
  if (fillet > 0.0) o.arc({0.01 + fillet, 0.01 + fillet}, -0.5 * std::numbers::pi, 10, SurfaceType::kCylinder);
  o.lineTo({0.01, 0.05}, SurfaceType::kPlane);
  o.lineTo({0, 0.05}, SurfaceType::kPlane);
  o.lineTo({0, 0}, SurfaceType::kPlane);
  return extruded(fillet > 0.0 ? "bracket with fillet" : "bracket", o, 0.04,
                  fillet > 0.0 ? std::vector<double>{fillet} : std::vector<double>{});
}

/// A boss on a disc with a blind hole: rounded at its foot and at the hole's floor, rings that are hollow.
GeneratedPart boss() {
  Outline o{{{0, 0}}, {}};
  o.lineTo({0.03, 0}, SurfaceType::kPlane);
  o.lineTo({0.03, 0.010}, SurfaceType::kCylinder);
  o.lineTo({0.016, 0.010}, SurfaceType::kPlane);
  o.arc({0.016, 0.014}, -0.5 * std::numbers::pi, 10, SurfaceType::kTorus);
  o.lineTo({0.012, 0.03}, SurfaceType::kCylinder);
  o.lineTo({0.008, 0.03}, SurfaceType::kPlane);
  o.lineTo({0.008, 0.018}, SurfaceType::kCylinder);
  o.arc({0.005, 0.018}, -0.5 * std::numbers::pi, 10, SurfaceType::kTorus);
  o.lineTo({0, 0.015}, SurfaceType::kPlane);
  return turned("boss", o, 44, {0.03, 0.012, 0.008, 0.004, 0.003});
}

GeneratedPart groove() {
  Outline o{{{-0.02, 0}}, {}};
  for (const dvec2& p : {dvec2(0.02, 0), dvec2(0.02, 0.012), dvec2(0.003, 0.012), dvec2(0.003, 0.008),
                         dvec2(-0.003, 0.008), dvec2(-0.003, 0.012), dvec2(-0.02, 0.012), dvec2(-0.02, 0)})
    o.lineTo(p, SurfaceType::kPlane);
  return extruded("groove", o, 0.06, {});
}

}  // namespace

std::vector<GeneratedPart> generatedParts() {
  std::vector<GeneratedPart> parts{roundedBox("box R 3", {0.06, 0.04, 0.03}, 0.003, 6),
                                   roundedBox("box R 10", {0.06, 0.05, 0.04}, 0.010, 11),
                                   plateWithBores(),
                                   shaft(),
                                   roundedBore(),
                                   torus(),
                                   ball(),
                                   bracket(0.0),
                                   bracket(0.008),
                                   boss(),
                                   groove()};
  return parts;
}

GeneratedPart generatedPart(const std::string& name) {
  auto parts = generatedParts();
  return *std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
}

}  // namespace hapticell::test
