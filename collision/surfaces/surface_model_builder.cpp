// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_model_builder.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "collision/surfaces/hollow_relief.h"
#include "collision/surfaces/surface_clusters.h"

namespace hapticell::collision {

namespace {

// Sine of 2 deg, as kSmooth of region_properties.cpp: tangent surfaces have no edge between them.
constexpr double kSmoothSine = 0.0349;
// Sine of 0.1 deg, as kLeastBend: facets that agree so are one plane. Half: STL's rounding makes edges; twice: fine
// scans lose theirs.
constexpr double kFlatSine = 0.00175;
// cos 0.1 deg: an edge goes straight on through such a corner. Half: rounding makes corners; twice: corners of fine
// polygons (900 sides) are left out.
constexpr double kStraight = 0.9999985;

}  // namespace

void ModelBuilder::makeElements() {
  std::vector<std::uint32_t> of_region(surface_.regions.size(), kNoIndex);
  model_.element_of_.resize(surface_.mesh.triangles.size());
  model_.edge_element_of_.assign(surface_.mesh.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  for (std::uint32_t i = 0; i < surface_.regions.size(); ++i) {
    const SurfaceRegion& region = surface_.regions[i];
    const SurfaceShape& shape = region.shape;
    if (shape.type == SurfaceType::kFreeForm) continue;
    of_region[i] = static_cast<std::uint32_t>(model_.elements_.size());
    SurfaceElement element;
    element.shape = shape;
    element.sagitta = region.sagitta;
    if (shape.side < 0.0) element.raised = std::max(0.0, region.sagitta - reliefOf(region));
    for (const SurfaceShape& trim : region.trims) {
      dvec3 center = shape.p_M;
      if (shape.type == SurfaceType::kTorus) {
        const dvec3 n = shape.axis_M;
        center +=
            shape.major_radius * glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
      }
      const bool ball = shape.type != SurfaceType::kCone;
      const double share = ball ? signedDistance(trim, center) / shape.radius : -1.0;
      element.trims.push_back({trim, -shape.side * share});
    }
    model_.elements_.push_back(std::move(element));
  }
  for (std::uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    model_.element_of_[t] = of_region[surface_.region_of[t]];
    if (model_.element_of_[t] != kNoIndex) continue;
    model_.element_of_[t] = static_cast<std::uint32_t>(model_.elements_.size());
    SurfaceElement facet;
    facet.facet = true;
    facet.shape.axis_M = surface_.normals[t];
    facet.shape.p_M = middleOf(surface_.mesh, t);
    model_.elements_.push_back(std::move(facet));
  }
}

bool ModelBuilder::isSharp(std::uint32_t t, std::uint32_t other, int k) const {
  const dvec3 p = surface_.mesh.corner(t, k);
  const bool same = surface_.region_of[t] == surface_.region_of[other];
  const SurfaceType type = regionOf(t).shape.type;
  // Inside cones no line stands for the whole, so their facets' edges do.
  const bool facets =
      same && (type == SurfaceType::kFreeForm || (type == SurfaceType::kCone && regionOf(t).shape.side > 0.0));
  if (same && !facets) return false;
  const dvec3 n1 = facets ? surface_.normals[t] : normalAt(t, p);
  const dvec3 n2 = facets ? surface_.normals[other] : normalAt(other, p);
  const double limit = facets ? kFlatSine : kSmoothSine;
  if (glm::length(glm::cross(n1, n2)) < limit && glm::dot(n1, n2) > 0.0) return false;
  return glm::dot(surface_.normals[t], middleOf(surface_.mesh, other) - p) < 0.0;
}

void ModelBuilder::findSharpEdges() {
  for (std::uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto other = surface_.neighbour[t][static_cast<std::size_t>(k)];
      if (other == kNoIndex || other < t || !isSharp(t, other, k)) continue;
      const auto& corners = surface_.mesh.triangles[t];
      const auto [low, high] = std::minmax(surface_.region_of[t], surface_.region_of[other]);
      sharp_.push_back({t, other, k, corners[static_cast<std::size_t>(k)],
                        corners[static_cast<std::size_t>((k + 1) % 3)], low, high});
    }
  }
}

void ModelBuilder::addEdgeElement(const SharpEdge& edge, std::uint32_t& name) {
  if (name == kNoIndex) {
    const dvec3 a = surface_.mesh.vertices[edge.a], b = surface_.mesh.vertices[edge.b];
    const dvec3 n1 = surface_.normals[edge.triangle], n2 = surface_.normals[edge.other];
    name = static_cast<std::uint32_t>(model_.elements_.size());
    SurfaceElement element;
    element.edge = true;
    element.shape.type = SurfaceType::kCylinder;
    element.shape.p_M = a;
    element.shape.axis_M = glm::normalize(b - a);
    ElementTrim chord;
    chord.surface.axis_M = glm::normalize(n1 + n2);
    chord.surface.p_M = a;
    chord.per_radius = glm::dot(chord.surface.axis_M, n1);
    element.trims.push_back(chord);
    model_.elements_.push_back(std::move(element));
  }
  model_.edge_element_of_[edge.triangle][static_cast<std::size_t>(edge.k)] = name;
  for (int k = 0; k < 3; ++k) {
    if (surface_.neighbour[edge.other][static_cast<std::size_t>(k)] == edge.triangle)
      model_.edge_element_of_[edge.other][static_cast<std::size_t>(k)] = name;
  }
}

/// Two planes meet in one line, whose edges are joined; other edges stand for themselves.
void ModelBuilder::makeStraightRods() {
  struct Line {
    dvec3 origin, way;
    std::vector<std::pair<double, double>> pieces;
    const SharpEdge* first;
    std::uint32_t element = kNoIndex;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Line> lines;
  for (const SharpEdge& edge : sharp_) {
    const dvec3 a = surface_.mesh.vertices[edge.a], b = surface_.mesh.vertices[edge.b];
    const bool planes = surface_.regions[edge.low].shape.type == SurfaceType::kPlane &&
                        surface_.regions[edge.high].shape.type == SurfaceType::kPlane;
    if (!planes) {
      const bool rim = edge.low != edge.high || isConeFacet(edge);
      addRod(rim ? SurfaceModel::RodKind::kRim : SurfaceModel::RodKind::kEdge,
             {a, b, 0.0, surface_.normals[edge.triangle], surface_.normals[edge.other], -1.0});
      std::uint32_t own = kNoIndex;
      addEdgeElement(edge, own);
      continue;
    }
    auto [found, is_new] =
        lines.try_emplace({edge.low, edge.high}, Line{a, glm::normalize(b - a), {}, &edge, kNoIndex});
    Line& line = found->second;
    addEdgeElement(edge, line.element);
    line.pieces.push_back(std::minmax({glm::dot(a - line.origin, line.way), glm::dot(b - line.origin, line.way)}));
  }
  for (auto& [regions, line] : lines) {
    std::sort(line.pieces.begin(), line.pieces.end());
    for (std::size_t i = 0; i < line.pieces.size();) {
      double end = line.pieces[i].second;
      std::size_t next = i + 1;
      while (next < line.pieces.size() && line.pieces[next].first <= end + 1e-9)
        end = std::max(end, line.pieces[next++].second);
      addRod(SurfaceModel::RodKind::kEdge,
             {line.origin + line.pieces[i].first * line.way, line.origin + end * line.way, 0.0,
              surface_.normals[line.first->triangle], surface_.normals[line.first->other], -1.0});
      i = next;
    }
  }
}

/// Corners: where sharp edges end or turn. Turns along a rim are left to makeRims().
void ModelBuilder::makeCornerPoints() {
  struct Corner {
    int edges = 0;
    int cone_edges = 0;
    dvec3 first{0.0};
    std::pair<std::uint32_t, std::uint32_t> regions;
    bool straight = false;
    bool one_border = true;
  };
  std::vector<Corner> corners(surface_.mesh.vertices.size());
  for (const SharpEdge& edge : sharp_) {
    for (const auto& [v, w] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
      Corner& corner = corners[v];
      if (isConeFacet(edge)) {
        ++corner.cone_edges;
        continue;
      }
      const dvec3 way = glm::normalize(surface_.mesh.vertices[w] - surface_.mesh.vertices[v]);
      if (corner.edges == 0) {
        corner.first = way;
        corner.regions = {edge.low, edge.high};
      } else {
        corner.straight = glm::dot(corner.first, way) < -kStraight;
        corner.one_border = corner.one_border && corner.regions == std::pair{edge.low, edge.high};
      }
      ++corner.edges;
    }
  }
  on_rim_.assign(corners.size(), 0);
  for (std::uint32_t v = 0; v < corners.size(); ++v) {
    const Corner& corner = corners[v];
    const bool apex = corner.edges == 0 && corner.cone_edges >= 3;
    if (!apex && (corner.edges == 0 || (corner.edges == 2 && corner.straight))) continue;
    const bool rim = corner.edges == 2 && corner.one_border && corner.regions.first != corner.regions.second &&
                     (isRound(surface_.regions[corner.regions.first].shape.type) ||
                      isRound(surface_.regions[corner.regions.second].shape.type));
    if (rim) {
      on_rim_[v] = 1;
    } else {
      model_.points_.push_back({surface_.mesh.vertices[v], 0.0, dvec3(0.0), -1.0});
    }
  }
}

}  // namespace hapticell::collision
