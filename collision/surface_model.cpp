// SPDX-License-Identifier: Apache-2.0
#include "collision/surface_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include "collision/hollow_relief.h"
#include "collision/surface_clusters.h"
#include "collision/surface_recognition.h"

namespace hapticell::collision {

namespace {

constexpr auto kNone = RecognisedSurface::kNone;
constexpr double kPi = std::numbers::pi;
constexpr double kSmoothSine = 0.0349;   // 2 deg
constexpr double kFlatSine = 0.00175;    // 0.1 deg
constexpr double kStraight = 0.9999985;  // cos 0.1 deg

/// A convex mesh edge between two triangles, seen from `triangle`'s corner k to k + 1.
struct SharpEdge {
  std::uint32_t triangle, other;
  int k;
  std::uint32_t a, b;       // vertices
  std::uint32_t low, high;  // regions
};

bool isRound(SurfaceType type) {
  return type != SurfaceType::kPlane && type != SurfaceType::kFreeForm;
}

}  // namespace

dvec3 BodyCircle::at(double angle) const {
  return center_M + ring * (std::cos(angle) * e1_M + std::sin(angle) * e2_M);
}

double elementValue(const SurfaceElement& element, const dvec3& p, double radius) {
  double value = signedDistance(element.shape, p) - radius;
  for (const ElementTrim& trim : element.trims) {
    const double t = signedDistance(trim.surface, p) - radius * trim.per_radius;
    value = element.shape.side > 0.0 ? std::min(value, t) : std::max(value, t);
  }
  return value;
}

class ModelBuilder {
 public:
  explicit ModelBuilder(SurfaceModel& model) : model_(model), surface_(model.surface_) {}

  void run() {
    makeElements();
    findSharpEdges();
    makeStraightRods();
    makeCornerPoints();
    makeRims();
    makeRoundBodies();
  }

 private:
  const SurfaceRegion& regionOf(std::uint32_t triangle) const { return surface_.regions[surface_.region_of[triangle]]; }
  dvec3 normalAt(std::uint32_t triangle, const dvec3& p) const {
    const SurfaceRegion& region = regionOf(triangle);
    return region.shape.type == SurfaceType::kFreeForm ? surface_.normals[triangle] : viewFrom(region.shape, p).nhat_M;
  }
  void makeElements();
  void findSharpEdges();
  bool isSharp(std::uint32_t t, std::uint32_t other, int k) const;
  bool isConeFacet(const SharpEdge& edge) const {
    return edge.low == edge.high && surface_.regions[edge.low].shape.type == SurfaceType::kCone;
  }
  void makeStraightRods();
  void addEdgeElement(const SharpEdge& edge, std::uint32_t& name);
  void makeCornerPoints();
  void makeRims();
  bool addRim(std::uint32_t round_region, const std::vector<const SharpEdge*>& edges);
  void makeRoundBodies();
  void addCylinder(const SurfaceRegion& region);
  void addRing(const SurfaceRegion& region);

  SurfaceModel& model_;
  const RecognisedSurface& surface_;
  std::vector<SharpEdge> sharp_;
  std::vector<std::uint8_t> on_rim_;  // per vertex
};

void ModelBuilder::makeElements() {
  std::vector<std::uint32_t> of_region(surface_.regions.size(), kNone);
  model_.element_of_.resize(surface_.mesh.triangles.size());
  model_.edge_element_of_.assign(surface_.mesh.triangles.size(), {kNone, kNone, kNone});
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
    if (model_.element_of_[t] != kNone) continue;
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
      if (other == kNone || other < t || !isSharp(t, other, k)) continue;
      const auto& corners = surface_.mesh.triangles[t];
      const auto [low, high] = std::minmax(surface_.region_of[t], surface_.region_of[other]);
      sharp_.push_back({t, other, k, corners[static_cast<std::size_t>(k)],
                        corners[static_cast<std::size_t>((k + 1) % 3)], low, high});
    }
  }
}

void ModelBuilder::addEdgeElement(const SharpEdge& edge, std::uint32_t& name) {
  if (name == kNone) {
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
    std::uint32_t element = kNone;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Line> lines;
  for (const SharpEdge& edge : sharp_) {
    const dvec3 a = surface_.mesh.vertices[edge.a], b = surface_.mesh.vertices[edge.b];
    const bool planes = surface_.regions[edge.low].shape.type == SurfaceType::kPlane &&
                        surface_.regions[edge.high].shape.type == SurfaceType::kPlane;
    if (!planes) {
      model_.rods_.push_back({a, b, 0.0, surface_.normals[edge.triangle], surface_.normals[edge.other], -1.0,
                              edge.low != edge.high || isConeFacet(edge)});
      std::uint32_t own = kNone;
      addEdgeElement(edge, own);
      continue;
    }
    auto [found, is_new] = lines.try_emplace({edge.low, edge.high}, Line{a, glm::normalize(b - a), {}, &edge, kNone});
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
      model_.rods_.push_back({line.origin + line.pieces[i].first * line.way, line.origin + end * line.way, 0.0,
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

bool ModelBuilder::addRim(std::uint32_t name, const std::vector<const SharpEdge*>& edges) {
  const SurfaceShape& shape = surface_.regions[name].shape;
  if (shape.type == SurfaceType::kSphere) return false;
  const dvec3 n = shape.axis_M;
  BodyCircle circle;
  circle.e1_M = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  circle.e2_M = glm::cross(n, circle.e1_M);
  double height = 0.0;
  std::vector<double> turns;
  double allowed = 0.0;
  for (const SharpEdge* edge : edges) {
    for (const auto v : {edge->a, edge->b}) {
      const dvec3 w = surface_.mesh.vertices[v] - shape.p_M;
      const double h = glm::dot(w, n), ring = glm::length(w - h * n);
      if (turns.empty()) {
        height = h;
        circle.ring = ring;
        allowed = 1e-4 * ring + 2.0 * surface_.regions[name].residual;
      }
      if (std::abs(h - height) > allowed || std::abs(ring - circle.ring) > allowed) return false;
      turns.push_back(std::atan2(glm::dot(w, circle.e2_M), glm::dot(w, circle.e1_M)));
    }
  }
  circle.center_M = shape.p_M + height * n;
  std::sort(turns.begin(), turns.end());
  double widest = turns.front() + 2.0 * kPi - turns.back();
  circle.from = turns.front();
  circle.to = turns.back();
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    if (turns[i + 1] - turns[i] <= widest) continue;
    widest = turns[i + 1] - turns[i];
    circle.from = turns[i + 1];
    circle.to = turns[i] + 2.0 * kPi;
  }
  if (widest < 0.7) {
    circle.from = 0.0;
    circle.to = 2.0 * kPi;
  }
  model_.circles_.push_back(circle);
  return true;
}

/// Circular borders become circles; the corners of all others stay points.
void ModelBuilder::makeRims() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<const SharpEdge*>> borders;
  for (const SharpEdge& edge : sharp_) {
    if (edge.low != edge.high && (on_rim_[edge.a] != 0 || on_rim_[edge.b] != 0))
      borders[{edge.low, edge.high}].push_back(&edge);
  }
  for (const auto& [regions, edges] : borders) {
    // A border may have several loops (both ends of a bore in a bent plate): they differ in height.
    const auto round = isRound(surface_.regions[regions.first].shape.type) ? regions.first : regions.second;
    const SurfaceShape& shape = surface_.regions[round].shape;
    std::vector<std::pair<double, const SharpEdge*>> by_height;
    for (const SharpEdge* edge : edges)
      by_height.push_back({glm::dot(surface_.mesh.vertices[edge->a] - shape.p_M, shape.axis_M), edge});
    std::sort(by_height.begin(), by_height.end());
    std::vector<std::vector<const SharpEdge*>> loops(1);
    for (std::size_t i = 0; i < by_height.size(); ++i) {
      if (i > 0 && by_height[i].first - by_height[i - 1].first > 1e-3 * shape.radius + 1e-7) loops.emplace_back();
      loops.back().push_back(by_height[i].second);
    }
    bool circles = shape.type != SurfaceType::kSphere;
    const std::size_t before = model_.circles_.size();
    for (const auto& loop : loops) circles = circles && addRim(round, loop);
    if (circles) continue;
    model_.circles_.resize(before);
    for (const SharpEdge* edge : edges) {
      for (const auto v : {edge->a, edge->b}) {
        if (on_rim_[v] == 1) model_.points_.push_back({surface_.mesh.vertices[v], 0.0, dvec3(0.0), -1.0});
        if (on_rim_[v] == 1) on_rim_[v] = 2;
      }
    }
  }
}

void ModelBuilder::addCylinder(const SurfaceRegion& region) {
  const SurfaceShape& s = region.shape;
  double low = 1e300, high = -1e300;
  dvec3 middle = region.mean_nhat_M - glm::dot(region.mean_nhat_M, s.axis_M) * s.axis_M;
  BodyRod rod;
  rod.radius = s.radius;
  const bool part = glm::length(middle) > 0.05;
  if (part) rod.n1_M = glm::normalize(middle), rod.cosine = 1.0;
  for (const auto t : region.triangles) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 p = surface_.mesh.corner(t, k);
      const double h = glm::dot(p - s.p_M, s.axis_M);
      low = std::min(low, h);
      high = std::max(high, h);
      if (part) rod.cosine = std::min(rod.cosine, glm::dot(rod.n1_M, viewFrom(s, p).nhat_M));
    }
  }
  rod.a_M = s.p_M + low * s.axis_M;
  rod.b_M = s.p_M + high * s.axis_M;
  model_.rods_.push_back(rod);
}

void ModelBuilder::addRing(const SurfaceRegion& region) {
  const SurfaceShape& s = region.shape;
  BodyCircle circle;
  circle.center_M = s.p_M;
  circle.e1_M = glm::normalize(glm::cross(s.axis_M, std::abs(s.axis_M.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  circle.e2_M = glm::cross(s.axis_M, circle.e1_M);
  circle.ring = s.major_radius;
  circle.radius = s.radius;
  std::vector<double> turns;
  for (const auto t : region.triangles) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 w = surface_.mesh.corner(t, k) - s.p_M;
      turns.push_back(std::atan2(glm::dot(w, circle.e2_M), glm::dot(w, circle.e1_M)));
    }
  }
  std::sort(turns.begin(), turns.end());
  double widest = turns.front() + 2.0 * kPi - turns.back();
  circle.from = turns.front();
  circle.to = turns.back();
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    if (turns[i + 1] - turns[i] <= widest) continue;
    widest = turns[i + 1] - turns[i];
    circle.from = turns[i + 1];
    circle.to = turns[i] + 2.0 * kPi;
  }
  if (widest < 0.7) circle.from = 0.0, circle.to = 2.0 * kPi;
  model_.circles_.push_back(circle);
}

void ModelBuilder::makeRoundBodies() {
  for (const SurfaceRegion& region : surface_.regions) {
    if (region.shape.side < 0.0) continue;
    if (region.shape.type == SurfaceType::kCylinder) addCylinder(region);
    if (region.shape.type == SurfaceType::kTorus) addRing(region);
    if (region.shape.type == SurfaceType::kSphere) {
      BodyPoint ball{region.shape.p_M, region.shape.radius, region.mean_nhat_M, -1.0};
      if (region.mean_nhat_M != dvec3(0.0)) {
        ball.cosine = 1.0;
        for (const auto t : region.triangles) {
          for (int k = 0; k < 3; ++k) {
            const dvec3 n = viewFrom(region.shape, surface_.mesh.corner(t, k)).nhat_M;
            ball.cosine = std::min(ball.cosine, glm::dot(n, region.mean_nhat_M));
          }
        }
      }
      model_.points_.push_back(ball);
    }
  }
}

namespace {

std::shared_ptr<const MeshCollider> linesOf(std::span<const BodyRod> rods) {
  if (rods.empty()) return nullptr;
  geometry::TriangleMesh lines;
  for (const BodyRod& rod : rods) {
    const auto first = static_cast<std::uint32_t>(lines.vertices.size());
    lines.vertices.insert(lines.vertices.end(), {rod.a_M, rod.b_M});
    lines.triangles.push_back({first, first + 1, first + 1});
  }
  return MeshCollider::build(lines);
}

}  // namespace

std::shared_ptr<const SurfaceModel> SurfaceModel::build(const geometry::TriangleMesh& mesh) {
  return build(recogniseSurfaces(mesh));
}

std::shared_ptr<const SurfaceModel> SurfaceModel::build(RecognisedSurface surface) {
  std::shared_ptr<SurfaceModel> model(new SurfaceModel);
  model->surface_ = std::move(surface);
  model->collider_ = MeshCollider::build(relievedMesh(model->surface_));
  ModelBuilder(*model).run();
  auto& rods = model->rods_;
  const auto rims = std::stable_partition(rods.begin(), rods.end(), [](const BodyRod& rod) { return !rod.rim; });
  model->plain_rod_count_ = static_cast<std::size_t>(rims - rods.begin());
  model->plain_rods_ = linesOf({rods.begin(), rims});
  model->rim_rods_ = linesOf({rims, rods.end()});
  for (const BodyRod& rod : rods) model->thickest_rod_ = std::max(model->thickest_rod_, rod.radius);
  return model;
}

}  // namespace hapticell::collision
