// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/region_grower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "collision/surfaces/surface_fit.h"

namespace hapticell::collision {
namespace {

// cos 0.1 deg: less is flat (a circle of 3600 facets), and also kFlatSine. Half: rounding of STL bends planes; twice:
// the finest scans are cut into facets.
constexpr double kLeastBend = 0.99999848;
// cos 40 deg: more is an edge (circles of 9 facets and fewer stay prisms). Half: coarse cylinders are facets; twice (80
// deg): octagons are taken for cylinders.
constexpr double kMostBend = 0.766;
// cos 17 deg: a facet's middle is a sixth of a step off the place of its normal (7 deg at 9 facets), more where it is
// skew. Half: coarse rounds are not grown into; twice: chamfers are.
constexpr double kNormalAgrees = 0.956;
// Of the smallest radius that a middle of an edge may stand off: the sagitta of 10 facets a turn (1 - cos 18 deg = 4.9
// %). Half: circles of under 14 facets stay prisms; twice: of 7 become round.
constexpr double kMiddleShare = 0.05;
// A flat cluster this many times the seed's area is a face of its own and no facet of a round. Half: uneven
// tessellations break up; twice: small flats beside a fillet are taken in.
constexpr double kLargerCluster = 8.0;
// Vertices that a grown surface is fitted to again: seven parameters at most. Half: noise of scans averages less;
// twice: twice the time of recognition for regions so large.
constexpr std::size_t kRefitPoints = 400;
// Growing and refitting, until nothing more is added. Half: large regions of a small seed end early; twice: only for
// those that still grow.
constexpr int kRounds = 6;

// Times the tolerance: what fits no better is not tried in the second pass, whose tolerance is ten times the first
// one's. Half: some that would fit are left out; twice: tries for nothing.
constexpr double kHopeless = 10.0;
// Neighbourhoods that fit nothing before a triangle is free form (Contacts: three times). Half: places beside a scan's
// noise are given up; twice: twice the time on free-form parts.
constexpr std::uint8_t kGivenUp = 3;
// Of the tube's radius: a fit so close needs no fourth circle to prove a ring, as three circles of a coarse one always
// fit. Half: fine rings are asked for more circles; twice: coarse false rings.
constexpr double kFineRing = 0.01;

double localRadius(const SurfaceShape& shape, const dvec3& p) {
  if (shape.type != SurfaceType::kCone) return shape.radius;
  const dvec3 v = p - shape.p_M;
  return glm::length(v - glm::dot(v, shape.axis_M) * shape.axis_M) / std::max(0.05, std::cos(shape.half_angle));
}

}  // namespace

RegionGrower::RegionGrower(const RecognisedSurface& surface, const PlanarClusters& clusters)
    : surface_(surface),
      clusters_(clusters),
      free_(surface.mesh.triangles.size(), 1),
      mark_(surface.mesh.triangles.size(), 0),
      vertex_mark_(surface.mesh.vertices.size(), 0),
      failed_(surface.mesh.triangles.size(), 0),
      hopeless_(surface.mesh.triangles.size(), 0) {
  area_.reserve(free_.size());
  for (std::uint32_t i = 0; i < free_.size(); ++i) area_.push_back(areaOf(surface.mesh, i));
}

void RegionGrower::take(const std::vector<std::uint32_t>& triangles) {
  for (const auto t : triangles) free_[t] = 0;
}

bool RegionGrower::isCurvedAt(std::uint32_t triangle) const {
  for (const auto other : surface_.neighbour[triangle]) {
    if (other == kNoIndex || !isFree(other)) continue;
    const double cosine = glm::dot(surface_.normals[triangle], surface_.normals[other]);
    if (cosine > kMostBend && cosine < kLeastBend) return true;
  }
  return false;
}

bool RegionGrower::enters(std::uint32_t from, int k, std::uint32_t seed, Neighbourhood kind) const {
  const auto to = surface_.neighbour[from][static_cast<std::size_t>(k)];
  if (to == kNoIndex || !isFree(to) || mark_[to] == search_) return false;
  if (glm::dot(surface_.normals[from], surface_.normals[to]) < kMostBend) return false;
  const double seed_area = clusters_.areas[clusters_.cluster_of[seed]];
  if (clusters_.areas[clusters_.cluster_of[to]] > kLargerCluster * seed_area) return false;
  if (kind == Neighbourhood::kLike) return area_[to] > 0.125 * area_[seed] && area_[to] < 8.0 * area_[seed];
  if (kind == Neighbourhood::kStrip) {
    double longest = 0.0, own = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double length = glm::length(surface_.mesh.corner(from, (i + 1) % 3) - surface_.mesh.corner(from, i));
      longest = std::max(longest, length);
      if (i == k) own = length;
    }
    return own > 0.6 * longest;
  }
  return true;
}

void RegionGrower::gather(std::uint32_t seed, Neighbourhood kind, std::vector<std::uint32_t>& found) {
  // Triangles of the four neighbourhoods (Contacts, 3): wide, narrow, of similar area, across long edges. Half: fits of
  // seven numbers to few vertices; twice: neighbourhoods reach over small features.
  constexpr std::array<std::size_t, 4> kSizes{60, 28, 12, 10};
  const std::size_t most = kSizes[static_cast<std::size_t>(kind)];
  ++search_;
  found.assign(1, seed);
  mark_[seed] = search_;
  for (std::size_t i = 0; i < found.size() && found.size() < most; ++i) {
    for (int k = 0; k < 3 && found.size() < most; ++k) {
      if (!enters(found[i], k, seed, kind)) continue;
      const auto to = surface_.neighbour[found[i]][static_cast<std::size_t>(k)];
      mark_[to] = search_;
      found.push_back(to);
    }
  }
}

bool RegionGrower::spansThreeClusters(const std::vector<std::uint32_t>& triangles) const {
  std::uint32_t first = kNoIndex, second = kNoIndex;
  for (const auto t : triangles) {
    const auto c = clusters_.cluster_of[t];
    if (first == kNoIndex || c == first) {
      first = c;
    } else if (second == kNoIndex || c == second) {
      second = c;
    } else {
      return true;
    }
  }
  return false;
}

std::vector<dvec3> RegionGrower::verticesOf(const std::vector<std::uint32_t>& triangles, std::size_t most) {
  ++search_;
  std::vector<dvec3> points;
  for (const auto t : triangles) {
    for (const auto v : surface_.mesh.triangles[t]) {
      if (vertex_mark_[v] == search_) continue;
      vertex_mark_[v] = search_;
      points.push_back(surface_.mesh.vertices[v]);
    }
  }
  if (points.size() <= most) return points;
  std::vector<dvec3> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * points.size() / most]);
  return some;
}

double RegionGrower::middleDeviation(const SurfaceShape& shape, const std::vector<std::uint32_t>& triangles) const {
  double sum = 0.0;
  for (const auto t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 middle = 0.5 * (surface_.mesh.corner(t, k) + surface_.mesh.corner(t, (k + 1) % 3));
      const double f = signedDistance(shape, middle);
      sum += f * f;
    }
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(triangles.size())));
}

bool RegionGrower::belongs(std::uint32_t t, const SurfaceShape& shape, double tolerance) const {
  const auto& mesh = surface_.mesh;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(signedDistance(shape, mesh.corner(t, k))) > tolerance) return false;
  }
  const dvec3 middle = middleOf(mesh, t);
  const double allowed = std::max(tolerance, kMiddleShare * localRadius(shape, middle));
  for (int k = 0; k < 3; ++k) {
    const dvec3 half = 0.5 * (mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3));
    if (std::abs(signedDistance(shape, half)) > allowed) return false;
  }
  return glm::dot(viewFrom(shape, middle).nhat_M, surface_.normals[t]) > kNormalAgrees;
}

/// Three circles about one axis always lie on a torus, so a coarse ring needs four.
bool RegionGrower::isRing(const SurfaceShape& shape, const std::vector<dvec3>& points, double deviation) const {
  if (deviation < kFineRing * shape.radius) return true;
  std::vector<double> angles;
  for (const dvec3& p : points) {
    const dvec3 v = p - shape.p_M;
    const double h = glm::dot(v, shape.axis_M);
    angles.push_back(std::atan2(h, glm::length(v - h * shape.axis_M) - shape.major_radius));
  }
  std::sort(angles.begin(), angles.end());
  int levels = 1;
  for (std::size_t i = 1; i < angles.size(); ++i) levels += angles[i] - angles[i - 1] > 0.01 ? 1 : 0;
  return levels >= 4;
}

std::optional<SurfaceShape> RegionGrower::bestFit(const std::vector<std::uint32_t>& triangles, Neighbourhood kind,
                                                  double tolerance) {
  const std::vector<dvec3> points = verticesOf(triangles, 1000);
  std::vector<dvec3> middles, normals;
  for (const auto t : triangles) {
    middles.push_back(middleOf(surface_.mesh, t));
    normals.push_back(surface_.normals[t]);
  }
  const FitSample sample{points, middles, normals};
  std::optional<SurfaceShape> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto type : {SurfaceType::kCylinder, SurfaceType::kSphere, SurfaceType::kCone, SurfaceType::kTorus}) {
    if (type == SurfaceType::kTorus && kind == Neighbourhood::kStrip) continue;
    const auto shape = fitSurface(type, sample, tolerance);
    if (!shape) continue;
    const bool agrees =
        std::all_of(triangles.begin(), triangles.end(), [&](auto t) { return belongs(t, *shape, tolerance); });
    if (!agrees) continue;
    // A later type has more freedom: it must be clearly better.
    const double deviation = middleDeviation(*shape, triangles);
    if (type == SurfaceType::kTorus && !isRing(*shape, points, deviation)) continue;
    if (deviation < 0.9 * least) {
      least = deviation;
      best = shape;
    }
  }
  return best;
}

void RegionGrower::grow(GrownRegion& region, double tolerance) {
  std::size_t before = 0;
  for (int round = 0; round < kRounds && region.triangles.size() != before; ++round) {
    before = region.triangles.size();
    ++search_;
    for (const auto t : region.triangles) mark_[t] = search_;
    for (std::size_t i = 0; i < region.triangles.size(); ++i) {
      for (const auto to : surface_.neighbour[region.triangles[i]]) {
        if (to == kNoIndex || !isFree(to) || mark_[to] == search_) continue;
        if (glm::dot(surface_.normals[region.triangles[i]], surface_.normals[to]) < kMostBend) continue;
        if (!belongs(to, region.shape, tolerance)) continue;
        mark_[to] = search_;
        region.triangles.push_back(to);
      }
    }
    SurfaceShape refined = region.shape;
    const std::vector<dvec3> points = verticesOf(region.triangles, kRefitPoints);
    if (refineSurface(refined, points, tolerance) <= tolerance) region.shape = refined;
  }
}

std::optional<GrownRegion> RegionGrower::regionFrom(std::uint32_t seed, double tolerance) {
  std::vector<std::uint32_t> triangles, before;
  std::uint64_t name = 0;
  bool hopeless = true;
  if (hopeless_[seed] >= kGivenUp) return std::nullopt;
  for (const auto kind : {Neighbourhood::kWide, Neighbourhood::kNarrow, Neighbourhood::kLike, Neighbourhood::kStrip}) {
    gather(seed, kind, triangles);
    if (kind == Neighbourhood::kWide) {
      for (const auto t : triangles) name = 31 * name + t + 1;
      if (failed_[seed] == name) return std::nullopt;
    }
    if (triangles == before || !spansThreeClusters(triangles)) continue;
    before = triangles;
    const auto shape = bestFit(triangles, kind, kHopeless * tolerance);
    if (!shape) continue;
    hopeless = false;
    GrownRegion region{*shape, triangles};
    const double worst = greatestDistance(*shape, verticesOf(triangles, 1000));
    if (worst > tolerance) continue;
    grow(region, tolerance);
    return region;
  }
  if (hopeless) {
    failed_[seed] = name;
    gather(seed, Neighbourhood::kLike, triangles);
    for (const auto t : triangles) hopeless_[t] = static_cast<std::uint8_t>(std::min(200, hopeless_[t] + 1));
  }
  return std::nullopt;
}

}  // namespace hapticell::collision
