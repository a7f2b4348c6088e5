// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/solid_kit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/shapes/shapes.h"

namespace hapticell::workcell {

namespace solid {

namespace {

/// Moves every edge of a counter-clockwise outline inwards; the distance is small against its features.
Outline inset(const Outline& outline, double distance) {
  Outline result;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 &a = outline[(i + n - 1) % n], &b = outline[i], &c = outline[(i + 1) % n];
    const glm::dvec2 e0 = glm::normalize(b - a), e1 = glm::normalize(c - b);
    const glm::dvec2 bisector(-e0.y - e1.y, e0.x + e1.x);
    result.push_back(b + bisector * (2.0 * distance / std::max(0.2, glm::dot(bisector, bisector))));
  }
  return result;
}

struct Section {
  Outline outline;
  double z;
};

void addCap(geometry::TriangleMesh& mesh, const std::vector<geometry::Triangle>& ears, std::uint32_t first, bool top) {
  for (const geometry::Triangle& ear : ears) {
    mesh.triangles.push_back(top ? geometry::Triangle{first + ear[0], first + ear[1], first + ear[2]}
                                 : geometry::Triangle{first + ear[0], first + ear[2], first + ear[1]});
  }
}

}  // namespace

geometry::TriangleMesh lathe(const Outline& profile, int segments) {
  geometry::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(segments);
  std::vector<std::uint32_t> first;
  for (const glm::dvec2& point : profile) {
    first.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    const bool on_axis = point.x <= 0.0;
    for (std::uint32_t i = 0; i < (on_axis ? 1u : n); ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n;
      mesh.vertices.emplace_back(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
    }
  }
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const bool low = profile[k].x <= 0.0, high = profile[k + 1].x <= 0.0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      const std::uint32_t a = first[k] + (low ? 0 : i), b = first[k] + (low ? 0 : j);
      const std::uint32_t c = first[k + 1] + (high ? 0 : j), d = first[k + 1] + (high ? 0 : i);
      if (!low) mesh.triangles.push_back({a, b, c});
      if (!high) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

geometry::TriangleMesh cylinder(double r, double z0, double z1, double chamfer, int segments) {
  const double c = std::min({chamfer, 0.45 * r, 0.45 * (z1 - z0)});
  if (c <= 0.0) return lathe({{0, z0}, {r, z0}, {r, z1}, {0, z1}}, segments);
  return lathe({{0, z0}, {r - c, z0}, {r, z0 + c}, {r, z1 - c}, {r - c, z1}, {0, z1}}, segments);
}

geometry::TriangleMesh capsule(double radius0, double radius1, double z0, double z1, int segments) {
  Outline profile;
  const int steps = std::max(2, segments / 6);
  for (int k = 0; k <= steps; ++k) {
    const double angle = -std::numbers::pi / 2 + std::numbers::pi / 2 * k / steps;
    profile.emplace_back(k == 0 ? 0.0 : radius0 * std::cos(angle), z0 + radius0 * std::sin(angle));
  }
  for (int k = 0; k <= steps; ++k) {
    const double angle = std::numbers::pi / 2 * k / steps;
    profile.emplace_back(k == steps ? 0.0 : radius1 * std::cos(angle), z1 + radius1 * std::sin(angle));
  }
  return lathe(profile, segments);
}

geometry::TriangleMesh prism(const Outline& outline, double z0, double z1, double chamfer) {
  const double c = std::min(chamfer, 0.4 * (z1 - z0));
  std::vector<Section> sections;
  if (c > 0.0) {
    const Outline inner = inset(outline, c);
    sections = {{inner, z0}, {outline, z0 + c}, {outline, z1 - c}, {inner, z1}};
  } else {
    sections = {{outline, z0}, {outline, z1}};
  }
  geometry::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const Section& section : sections) {
    for (const glm::dvec2& p : section.outline) mesh.vertices.emplace_back(p.x, p.y, section.z);
  }
  for (std::uint32_t k = 0; k + 1 < sections.size(); ++k) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n, a = k * n + i, b = k * n + j;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  }
  const auto ears = geometry::triangulatePolygon(sections.front().outline);
  addCap(mesh, ears, 0, false);
  addCap(mesh, ears, static_cast<std::uint32_t>(sections.size() - 1) * n, true);
  return mesh;
}

geometry::TriangleMesh box(const dvec3& least, const dvec3& most, double chamfer) {
  return prism({{least.x, least.y}, {most.x, least.y}, {most.x, most.y}, {least.x, most.y}}, least.z, most.z, chamfer);
}

Outline belt(const glm::dvec2& p0, double r0, const glm::dvec2& p1, double r1, int steps) {
  const glm::dvec2 d = p1 - p0;
  const double length = std::max(1e-9, glm::length(d)), direction = std::atan2(d.y, d.x);
  Outline points;
  const auto arc = [&](const glm::dvec2& center, double r, double from, double to, int count) {
    for (int k = 0; k <= count; ++k) {
      const double angle = from + (to - from) * k / count;
      points.push_back(center + r * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
  };
  if (length <= std::abs(r0 - r1) + 1e-6) {
    arc(r0 > r1 ? p0 : p1, std::max(r0, r1), 0.0, 2.0 * std::numbers::pi * (1.0 - 0.5 / steps), 2 * steps - 1);
    return points;
  }
  const double lean = std::acos(std::clamp((r0 - r1) / length, -1.0, 1.0));
  arc(p1, r1, direction - lean, direction + lean, steps);
  arc(p0, r0, direction + lean, direction - lean + 2.0 * std::numbers::pi, steps);
  return points;
}

Outline roundedRectangle(double width, double depth, double radius, int steps) {
  const double x = width / 2 - radius, y = depth / 2 - radius;
  const glm::dvec2 corners[] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  Outline points;
  for (int c = 0; c < 4; ++c) {
    for (int k = 0; k <= steps; ++k) {
      const double angle = std::numbers::pi / 2 * (c + static_cast<double>(k) / steps);
      points.push_back(corners[c] + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
  }
  return points;
}

Pose alongX(const dvec3& p) {
  return {p, glm::angleAxis(std::numbers::pi / 2, dvec3(0, 1, 0))};
}
Pose alongY(const dvec3& p) {
  return {p, glm::angleAxis(-std::numbers::pi / 2, dvec3(1, 0, 0))};
}
Pose upright(const dvec3& p) {
  return {p, glm::angleAxis(std::numbers::pi / 2, dvec3(1, 0, 0))};
}
Pose along(const dvec3& p, const dvec3& direction) {
  const dvec3 d = glm::normalize(direction), z(0, 0, 1), axis = glm::cross(z, d);
  const double s = glm::length(axis);
  if (s < 1e-9) return {p, d.z > 0 ? dquat(1, 0, 0, 0) : dquat(0, 1, 0, 0)};
  return {p, glm::angleAxis(std::atan2(s, d.z), axis / s)};
}

}  // namespace solid

void BodyMaker::link(int index) {
  flush();
  link_ = index;
}

void BodyMaker::append(const PaintColor& color, const geometry::TriangleMesh& mesh, const Pose& placed) {
  for (auto& [known, whole] : visual_) {
    if (known != color) continue;
    geometry::append(whole, mesh, placed);
    return;
  }
  visual_.emplace_back(color, geometry::TriangleMesh{});
  geometry::append(visual_.back().second, mesh, placed);
}

void BodyMaker::flush() {
  if (link_ >= 0 && static_cast<std::size_t>(link_) < model_.links.size()) {
    kinematics::Link& link = model_.links[static_cast<std::size_t>(link_)];
    for (auto& [color, mesh] : visual_) {
      link.visuals.push_back({std::make_shared<geometry::TriangleMesh>(std::move(mesh)), {}, color, "generated"});
    }
    if (!collision_.triangles.empty()) {
      link.collisions.push_back({std::make_shared<geometry::TriangleMesh>(std::move(collision_)),
                                 {},
                                 visual_.empty() ? PaintColor{0.7f, 0.7f, 0.7f, 1.0f} : link.visuals.front().color,
                                 "generated"});
    }
  }
  visual_.clear();
  collision_ = {};
}

}  // namespace hapticell::workcell
