// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_model_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace hapticell::collision {

namespace {

/// The arc that the turns lie on: all but their widest gap, or the whole circle where that is narrow.
void setArc(BodyCircle& circle, std::vector<double> turns) {
  std::sort(turns.begin(), turns.end());
  double widest = turns.front() + 2.0 * std::numbers::pi - turns.back();
  circle.from = turns.front();
  circle.to = turns.back();
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    if (turns[i + 1] - turns[i] <= widest) continue;
    widest = turns[i + 1] - turns[i];
    circle.from = turns[i + 1];
    circle.to = turns[i] + 2.0 * std::numbers::pi;
  }
  if (widest >= 0.7) return;
  circle.from = 0.0;
  circle.to = 2.0 * std::numbers::pi;
}

}  // namespace

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
  setArc(circle, std::move(turns));
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
  addRod(SurfaceModel::RodKind::kRound, rod);
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
  setArc(circle, std::move(turns));
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

}  // namespace hapticell::collision
