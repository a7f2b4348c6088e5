// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/polygon_soup.h"

#include <cmath>
#include <span>
#include <string>

#include "geometry/shapes/shapes.h"
#include "workcell/meshes/color_channels.h"

namespace hapticell::workcell {

namespace {

using geometry::Triangle;
using Corners = std::span<const std::uint32_t>;

/// Twice the polygon's area vector (M. E. Newell's method): its normal even where it is not quite plane.
dvec3 areaVector(const std::vector<dvec3>& vertices, Corners polygon) {
  dvec3 sum(0.0);
  const dvec3& origin = vertices[polygon[0]];
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += glm::cross(vertices[polygon[k]] - origin, vertices[polygon[k + 1]] - origin);
  }
  return sum;
}

bool isConvex(std::span<const glm::dvec2> outline) {
  double turned = 0.0;
  const std::size_t n = outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 in = outline[(k + 1) % n] - outline[k], out = outline[(k + 2) % n] - outline[(k + 1) % n];
    const double sine = in.x * out.y - in.y * out.x;
    if (sine < 0.0) return false;
    turned += std::atan2(sine, glm::dot(in, out));
  }
  // rad: a little over 2 pi, below 4 pi: a polygon that winds once is convex. Half: none is; twice (over 12.6): stars
  // are.
  constexpr double kMoreThanOneTurn = 7.0;
  return turned < kMoreThanOneTurn;
}

std::vector<glm::dvec2> flattened(const std::vector<dvec3>& vertices, Corners polygon, const dvec3& normal) {
  const dvec3 away = std::abs(normal.x) < 0.6 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0);
  const dvec3 u = glm::normalize(glm::cross(away, normal)), v = glm::cross(normal, u);
  std::vector<glm::dvec2> outline;
  outline.reserve(polygon.size());
  for (std::uint32_t index : polygon) {
    const dvec3 p = vertices[index] - vertices[polygon[0]];
    outline.emplace_back(glm::dot(p, u), glm::dot(p, v));
  }
  return outline;
}

class Triangulator {
 public:
  explicit Triangulator(geometry::TriangleMesh& mesh) : mesh_(mesh) {}

  void add(Corners polygon) {
    if (polygon.size() < 3) {
      ++dropped_;
    } else if (polygon.size() == 3 || !addByEars(polygon)) {
      for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        mesh_.triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
      }
    }
  }

  void report(Diagnostics& diagnostics) const {
    if (dropped_ > 0) diagnostics.warn(Text("%1 faces with fewer than three corners were removed", dropped_));
    if (crossed_ > 0) {
      diagnostics.warn(
          Text("%1 faces are self-intersecting or not planar; they were split into triangle fans", crossed_));
    }
  }

 private:
  /// False where a fan is right (convex) or all that is left to do.
  bool addByEars(Corners polygon) {
    const dvec3 area = areaVector(mesh_.vertices, polygon);
    const double length = glm::length(area);
    if (!(length > 0.0)) return false;
    const std::vector<glm::dvec2> outline = flattened(mesh_.vertices, polygon, area / length);
    if (isConvex(outline)) return false;
    const std::vector<Triangle> ears = geometry::triangulatePolygon(outline, &work_);
    if (ears.empty()) ++crossed_;
    for (const Triangle& t : ears) mesh_.triangles.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    return !ears.empty();
  }

  geometry::TriangleMesh& mesh_;
  std::uint64_t work_ = 500'000'000;  // Corner tests for the whole file: a second, so that no file can hang us.
  std::uint64_t dropped_ = 0;
  std::uint64_t crossed_ = 0;
};

}  // namespace

Expected<RawMesh> triangulate(PolygonSoup soup, Diagnostics& diagnostics) {
  RawMesh raw;
  geometry::TriangleMesh& mesh = raw.mesh;
  mesh.vertices = std::move(soup.vertices);
  mesh.triangles.reserve(soup.ends.size());
  Triangulator triangulator(mesh);
  std::vector<Color> corner_colors;
  std::uint64_t begin = 0;
  for (std::size_t face = 0; face < soup.ends.size(); ++face) {
    const Corners polygon(soup.corners.data() + begin, soup.ends[face] - begin);
    begin = soup.ends[face];
    for (std::uint32_t index : polygon) {
      if (index < mesh.vertices.size()) continue;
      return makeError({.place = Text("face %1 of %2", face + 1, soup.ends.size()),
                        .found = Text("vertex index %1", index),
                        .expected = Text("a number below %1, the number of vertices", mesh.vertices.size())});
    }
    triangulator.add(polygon);
    if (!soup.labels.empty()) raw.label.resize(mesh.triangles.size(), soup.labels[face]);
    if (!soup.face_colors.empty() || !soup.vertex_colors.empty()) {
      Color color = soup.face_colors.empty() ? kNoColor : soup.face_colors[face];
      if (!isColor(color) && !soup.vertex_colors.empty() && !polygon.empty()) {
        corner_colors.clear();
        for (std::uint32_t index : polygon) corner_colors.push_back(soup.vertex_colors[index]);
        color = meanColor(corner_colors);
      }
      raw.color.resize(mesh.triangles.size(), color);
    }
  }
  triangulator.report(diagnostics);
  return raw;
}

}  // namespace hapticell::workcell
