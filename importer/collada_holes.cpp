// SPDX-License-Identifier: Apache-2.0
#include "importer/collada_holes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

namespace hapticell::importer {

namespace {

using glm::dvec2;

double areaOf(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool crosses(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
  if (a == c || a == d || b == c || b == d) return false;
  return areaOf(a, b, c) * areaOf(a, b, d) <= 0.0 && areaOf(c, d, a) * areaOf(c, d, b) <= 0.0;
}

/// The points in the plane of the outline, so that the outline turns left.
std::vector<dvec2> flattened(const std::vector<std::vector<dvec3>>& loops) {
  const std::vector<dvec3>& outline = loops.front();
  dvec3 normal(0.0);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    normal += glm::cross(outline[k] - outline[0], outline[(k + 1) % outline.size()] - outline[0]);
  }
  const double length = glm::length(normal);
  if (!(length > 0.0)) return {};
  normal /= length;
  const dvec3 other = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(other - glm::dot(other, normal) * normal), v = glm::cross(normal, u);
  std::vector<dvec2> points;
  for (const auto& loop : loops) {
    for (const dvec3& p : loop) points.emplace_back(glm::dot(p, u), glm::dot(p, v));
  }
  return points;
}

/// Joins a hole to the outline by the shortest bridge that crosses nothing; false if there is no such bridge.
bool bridge(std::vector<int>& outline, const std::vector<int>& hole, const std::vector<std::vector<int>>& others,
            const std::vector<dvec2>& points) {
  const auto at = [&](int index) { return points[static_cast<std::size_t>(index)]; };
  const auto blocked = [&](const dvec2& a, const dvec2& b, const std::vector<int>& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (crosses(a, b, at(loop[k]), at(loop[(k + 1) % loop.size()]))) return true;
    }
    return false;
  };
  double best = std::numeric_limits<double>::infinity();
  std::size_t from = 0, to = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const dvec2 a = at(outline[i]), b = at(hole[j]);
      const double squared = glm::dot(b - a, b - a);
      if (squared >= best || blocked(a, b, outline) || blocked(a, b, hole)) continue;
      if (std::any_of(others.begin(), others.end(), [&](const auto& loop) { return blocked(a, b, loop); })) continue;
      best = squared;
      from = i;
      to = j;
    }
  }
  if (std::isinf(best)) return false;
  std::vector<int> joined(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(from) + 1);
  for (std::size_t k = 0; k <= hole.size(); ++k) joined.push_back(hole[(to + k) % hole.size()]);
  joined.insert(joined.end(), outline.begin() + static_cast<std::ptrdiff_t>(from), outline.end());
  outline = std::move(joined);
  return true;
}

bool isEarOf(const std::vector<int>& left, std::size_t at, const std::vector<dvec2>& points) {
  const std::size_t n = left.size();
  const auto point = [&](std::size_t k) { return points[static_cast<std::size_t>(left[k % n])]; };
  const dvec2 a = point(at + n - 1), b = point(at), c = point(at + 1);
  if (areaOf(a, b, c) <= 0.0) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const dvec2 p = point(at + k);
    if (p == a || p == b || p == c) continue;
    if (areaOf(a, b, p) >= 0.0 && areaOf(b, c, p) >= 0.0 && areaOf(c, a, p) >= 0.0) return false;
  }
  return true;
}

std::vector<double> floatsOf(const pugi::xml_node& array) {
  std::vector<double> numbers;
  std::istringstream words(array.text().get());
  words.imbue(std::locale::classic());
  for (double number = 0.0; words >> number;) numbers.push_back(number);
  return numbers;
}

std::vector<long> indicesOf(const pugi::xml_node& list) {
  std::vector<long> numbers;
  std::istringstream words(list.text().get());
  for (long number = 0; words >> number;) numbers.push_back(number);
  return numbers;
}

pugi::xml_node byId(const pugi::xml_node& mesh, const std::string& reference) {
  for (pugi::xml_node child : mesh.children()) {
    if ("#" + std::string(child.attribute("id").value()) == reference) return child;
  }
  return {};
}

pugi::xml_node inputOf(const pugi::xml_node& parent, const char* semantic) {
  return parent.find_child_by_attribute("input", "semantic", semantic);
}

std::vector<dvec3> positionsOf(const pugi::xml_node& mesh, const pugi::xml_node& polygons) {
  const pugi::xml_node vertices = byId(mesh, inputOf(polygons, "VERTEX").attribute("source").value());
  const pugi::xml_node source = byId(mesh, inputOf(vertices, "POSITION").attribute("source").value());
  const pugi::xml_node accessor = source.child("technique_common").child("accessor");
  const std::vector<double> numbers = floatsOf(source.child("float_array"));
  const std::size_t stride = std::max(accessor.attribute("stride").as_uint(3), 3u);
  std::vector<dvec3> points;
  for (std::size_t k = accessor.attribute("offset").as_uint(0); k + 3 <= numbers.size(); k += stride) {
    points.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
  }
  return points;
}

}  // namespace

std::vector<int> cutPolygon(const std::vector<std::vector<dvec3>>& loops) {
  if (loops.empty() || loops.front().size() < 3) return {};
  const std::vector<dvec2> points = flattened(loops);
  if (points.empty()) return {};
  std::vector<std::vector<int>> turned;
  int next = 0;
  for (const auto& loop : loops) {
    std::vector<int> own;
    double area = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k) own.push_back(next++);
    for (std::size_t k = 1; k + 1 < own.size(); ++k) {
      area += areaOf(points[static_cast<std::size_t>(own[0])], points[static_cast<std::size_t>(own[k])],
                     points[static_cast<std::size_t>(own[k + 1])]);
    }
    const bool hole = !turned.empty();
    if (hole == (area > 0.0)) std::reverse(own.begin(), own.end());  // Holes turn the other way.
    if (own.size() >= 3) turned.push_back(std::move(own));
  }
  std::vector<int> left = turned.front();
  for (std::size_t k = 1; k < turned.size(); ++k) {
    const std::vector<std::vector<int>> others(turned.begin() + static_cast<std::ptrdiff_t>(k) + 1, turned.end());
    if (!bridge(left, turned[k], others, points)) return {};
  }
  std::vector<int> triangles;
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !isEarOf(left, ear, points)) ++ear;
    if (ear == left.size()) return {};
    const std::size_t n = left.size();
    for (const std::size_t k : {(ear + n - 1) % n, ear, (ear + 1) % n}) triangles.push_back(left[k]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.insert(triangles.end(), left.begin(), left.end());
  return triangles;
}

int cutPolygonsWithHoles(pugi::xml_node mesh, pugi::xml_node polygons) {
  const std::vector<dvec3> positions = positionsOf(mesh, polygons);
  std::size_t stride = 1;
  for (const pugi::xml_node input : polygons.children("input")) {
    stride = std::max<std::size_t>(stride, input.attribute("offset").as_uint(0) + 1);
  }
  const std::size_t vertex = inputOf(polygons, "VERTEX").attribute("offset").as_uint(0);
  std::string text;
  std::size_t count = 0;
  int lost = 0;
  for (const pugi::xml_node polygon : polygons.children()) {
    const bool holed = std::string_view(polygon.name()) == "ph";
    if (!holed && std::string_view(polygon.name()) != "p") continue;
    std::vector<std::vector<long>> lists = {indicesOf(holed ? polygon.child("p") : polygon)};
    for (const pugi::xml_node hole : polygon.children("h")) lists.push_back(indicesOf(hole));
    std::vector<std::vector<dvec3>> loops;
    std::vector<long> corners;  // The indices of all points, `stride` each.
    for (const std::vector<long>& list : lists) {
      loops.emplace_back();
      for (std::size_t k = 0; k + stride <= list.size(); k += stride) {
        const auto at = static_cast<std::size_t>(list[k + vertex]);
        if (at >= positions.size()) continue;
        loops.back().push_back(positions[at]);
        corners.insert(corners.end(), list.begin() + static_cast<std::ptrdiff_t>(k),
                       list.begin() + static_cast<std::ptrdiff_t>(k + stride));
      }
    }
    const std::vector<int> triangles = cutPolygon(loops);
    lost += triangles.empty() ? 1 : 0;
    count += triangles.size() / 3;
    for (const int corner : triangles) {
      for (std::size_t k = 0; k < stride; ++k) {
        text += std::to_string(corners[static_cast<std::size_t>(corner) * stride + k]) + " ";
      }
    }
  }
  pugi::xml_node made = mesh.insert_child_after("triangles", polygons);
  for (const pugi::xml_attribute attribute : polygons.attributes()) made.append_copy(attribute);
  made.remove_attribute("count");
  made.append_attribute("count").set_value(static_cast<unsigned>(count));
  for (const pugi::xml_node input : polygons.children("input")) made.append_copy(input);
  made.append_child("p").text().set(text.c_str());
  mesh.remove_child(polygons);
  return lost;
}

}  // namespace hapticell::importer
