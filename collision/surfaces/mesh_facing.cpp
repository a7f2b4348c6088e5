// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/mesh_facing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "collision/surfaces/surface_clusters.h"
#include "collision/trees/shells.h"
#include "geometry/shapes/edge_uses.h"
#include "geometry/shapes/vertex_merge.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::collision {

namespace {

constexpr std::uint32_t kNone = MeshFacing::kNone;
/// Solid angles in all: some tenths of a second. What is over goes with the kind of most area. Half: fewer open
/// surfaces are looked at; twice: opening large open meshes takes longer.
constexpr std::size_t kMostAngles = 10'000'000;
/// Largest triangles of an open surface in front of which it is judged. Half: one beside a gap counts for more; twice:
/// half as many surfaces are judged (kMostAngles).
constexpr std::size_t kSamples = 8;
/// Of the winding number: less is a gap, more is the open side of a sheet. A gap of 5 % of the sphere. Half: solids
/// with small holes are sheets; twice: nearly closed boxes without a lid may be solids.
constexpr double kEnclosed = 0.05;
/// Of a triangle's size, at which its front is looked at: far above rounding, far below any neighbour. Half and twice
/// as well.
constexpr double kInFront = 1e-3;

/// A connected surface.
struct Surface {
  std::vector<std::uint32_t> triangles;
  geometry::Bounds bounds;
  double area = 0.0, flipped_area = 0.0;
  double volume = 0.0;  ///< m3, six times.
  bool closed = true;
  bool two_sided = true;  ///< False: a Moebius strip or the like.
};

class FacingFinder {
 public:
  explicit FacingFinder(MeshFacing& facing) : facing_(facing), mesh_(facing.mesh) {}

  void run() {
    findNeighbours();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (surface_of_[t] == kNone) flood(t);
    }
    for (Surface& surface : surfaces_) makeUniform(surface);
    turnClosed();
    judgeOpen();
    count();
  }

 private:
  void findNeighbours();
  void flood(std::uint32_t first);
  void makeUniform(Surface& surface);
  void turnClosed();
  bool contains(const Surface& outer, const Surface& inner) const;
  void judgeOpen();
  double angleOf(const std::vector<std::uint32_t>& triangles, const dvec3& p) const;
  double inFrontOf(const Surface& surface, const std::vector<std::uint32_t>& open) const;
  void count();
  void turn(const Surface& surface) {
    for (const auto t : surface.triangles) turn(t);
  }
  void turn(std::uint32_t t) {
    std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
    turned_[t] = !turned_[t];
  }
  double areaAt(std::uint32_t t) const { return areaOf(mesh_, t); }

  struct Neighbour {
    std::uint32_t triangle = kNone;
    bool same_way = true;  ///< As the file has them.
  };
  MeshFacing& facing_;
  geometry::TriangleMesh& mesh_;
  std::vector<std::array<Neighbour, 3>> neighbours_;
  std::vector<bool> border_;  ///< Triangles with an edge that is not shared by two.
  std::vector<std::uint32_t> surface_of_;
  std::vector<bool> turned_;
  std::vector<Surface> surfaces_;
};

void FacingFinder::findNeighbours() {
  const std::size_t count = mesh_.triangles.size();
  neighbours_.resize(count);
  border_.assign(count, false);
  turned_.assign(count, false);
  surface_of_.assign(count, kNone);
  const auto stands_for = geometry::mergedVertices(mesh_.vertices, geometry::weldTolerance(mesh_));
  std::vector<geometry::Triangle> merged = mesh_.triangles;
  for (geometry::Triangle& t : merged) {
    for (std::uint32_t& v : t) v = stands_for[v];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) t = {};  // Without edges.
  }
  const geometry::EdgeUses edges(merged, mesh_.vertices.size());
  edges.each(0, edges.vertices(), [this](std::span<const geometry::EdgeUses::Use> uses) {
    const geometry::EdgeUses::Use &a = uses.front(), &b = uses.back();
    if (uses.size() == 2) {
      neighbours_[a.triangle()][a.corner() % 3] = {b.triangle(), a.up() != b.up()};
      neighbours_[b.triangle()][b.corner() % 3] = {a.triangle(), a.up() != b.up()};
    } else {
      for (const geometry::EdgeUses::Use& use : uses) border_[use.triangle()] = true;
    }
  });
}

void FacingFinder::flood(std::uint32_t first) {
  const auto name = static_cast<std::uint32_t>(surfaces_.size());
  Surface surface;
  surface.triangles = {first};
  surface_of_[first] = name;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::uint32_t t = surface.triangles[i];
    const double area = areaAt(t);
    surface.area += area;
    if (turned_[t]) surface.flipped_area += area;
    surface.closed = surface.closed && !border_[t];
    for (const dvec3& p : mesh_.corners(t)) surface.bounds.add(p);
    for (const Neighbour& next : neighbours_[t]) {
      if (next.triangle == kNone) continue;
      const bool turned = next.same_way ? turned_[t] : !turned_[t];
      if (surface_of_[next.triangle] == kNone) {
        surface_of_[next.triangle] = name;
        turned_[next.triangle] = turned;
        surface.triangles.push_back(next.triangle);
      } else if (turned_[next.triangle] != turned) {
        surface.two_sided = false;
      }
    }
  }
  surfaces_.push_back(std::move(surface));
}

/// The greater part of the area keeps its turn. `turned_` said what flood() wished; from here on it says what is done.
void FacingFinder::makeUniform(Surface& surface) {
  const bool other_way = surface.flipped_area > 0.5 * surface.area;
  const dvec3 origin = surface.bounds.center();
  for (const auto t : surface.triangles) {
    const bool wanted = surface.two_sided && turned_[t] != other_way;
    turned_[t] = false;
    if (wanted) turn(t);
    const auto [a, b, c] = mesh_.corners(t);
    surface.volume += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
}

bool FacingFinder::contains(const Surface& outer, const Surface& inner) const {
  const geometry::Bounds &o = outer.bounds, &i = inner.bounds;
  if (glm::any(glm::lessThan(i.min, o.min)) || glm::any(glm::greaterThan(i.max, o.max))) return false;
  const dvec3 p = middleOf(mesh_, inner.triangles.front());
  double angle = 0.0;
  for (const auto t : outer.triangles) {
    const double one = solidAngle(mesh_.corners(t), p);
    if (std::isfinite(one)) angle += one;
  }
  return std::abs(angle) > 2.0 * std::numbers::pi;
}

void FacingFinder::turnClosed() {
  std::vector<std::uint32_t> closed;
  for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_[i].closed && surfaces_[i].two_sided) closed.push_back(i);
  }
  if (std::none_of(closed.begin(), closed.end(), [&](auto i) { return surfaces_[i].volume < 0.0; })) return;
  // What holds another comes before it.
  std::stable_sort(closed.begin(), closed.end(), [&](auto a, auto b) {
    return glm::length(surfaces_[a].bounds.size()) > glm::length(surfaces_[b].bounds.size());
  });
  std::vector<bool> is_turned(surfaces_.size(), false);
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const Surface& own = surfaces_[closed[k]];
    std::uint32_t holder = kNone;
    for (std::size_t j = k; j-- > 0 && holder == kNone;) {
      if (contains(surfaces_[closed[j]], own)) holder = closed[j];
    }
    const bool inward = own.volume < 0.0;
    bool turns = inward;
    if (holder != kNone) {
      const bool in_a_cavity = (surfaces_[holder].volume < 0.0) != is_turned[holder];
      turns = is_turned[holder] || (inward && in_a_cavity);
    }
    if (!turns) continue;
    is_turned[closed[k]] = true;
    turn(own);
  }
}

/// The solid angle of these triangles from p. Cut into as many pieces on every machine, so that the sum is the same.
double FacingFinder::angleOf(const std::vector<std::uint32_t>& triangles, const dvec3& p) const {
  // Pieces, and triangles from which on they are worth their threads. Half, twice: no effect.
  constexpr std::size_t kPieces = 4, kMany = 100'000;
  std::array<double, kPieces> sums{};
  const auto add = [&](std::size_t piece, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const double one = solidAngle(mesh_.corners(triangles[k]), p);
      if (std::isfinite(one)) sum += one;
    }
    sums[piece] = sum;
  };
  geometry::inRanges(triangles.size(), triangles.size() < kMany ? 1 : kPieces, add);
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The mean winding number of the open surfaces just in front of this one's largest triangles.
double FacingFinder::inFrontOf(const Surface& surface, const std::vector<std::uint32_t>& open) const {
  std::vector<std::uint32_t> largest = surface.triangles;
  const std::size_t count = std::min(kSamples, largest.size());
  std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(count), largest.end(),
                    [&](auto a, auto b) { return areaAt(a) > areaAt(b); });
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = mesh_.corners(largest[i]);
    const dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    if (area <= 0.0) continue;
    const dvec3 p = middleOf(mesh_, largest[i]) + kInFront * std::sqrt(area) / area * normal;
    sum += angleOf(open, p) / (4.0 * std::numbers::pi);
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

void FacingFinder::judgeOpen() {
  facing_.sheet_of.assign(mesh_.triangles.size(), kNone);
  std::vector<std::uint32_t> surfaces, triangles;
  for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_[i].closed || surfaces_[i].area <= 0.0) continue;
    surfaces.push_back(i);
    triangles.insert(triangles.end(), surfaces_[i].triangles.begin(), surfaces_[i].triangles.end());
  }
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [&](auto a, auto b) { return surfaces_[a].area > surfaces_[b].area; });
  std::size_t angles = 0;
  std::array<double, 3> areas{};  // Of solids, of inverted ones, of sheets; those that are not looked at go with them.
  std::vector<std::pair<std::uint32_t, int>> judged;
  for (const auto i : surfaces) {
    int kind = static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    angles += kSamples * triangles.size();
    if (angles <= kMostAngles || judged.empty()) {
      const double winding = inFrontOf(surfaces_[i], triangles);
      if (std::abs(winding) < kEnclosed)
        kind = 0;
      else
        kind = std::abs(winding + 1.0) < kEnclosed ? 1 : 2;
      areas[static_cast<std::size_t>(kind)] += surfaces_[i].area;
    }
    judged.emplace_back(i, kind);
  }
  for (const auto& [i, kind] : judged) {
    if (!surfaces_[i].two_sided) continue;
    if (kind == 1) turn(surfaces_[i]);
    if (kind != 2) continue;
    for (const auto t : surfaces_[i].triangles) facing_.sheet_of[t] = facing_.sheets;
    ++facing_.sheets;
  }
}

void FacingFinder::count() {
  for (const Surface& surface : surfaces_) {
    double area = 0.0;
    for (const auto t : surface.triangles) {
      if (!turned_[t]) continue;
      ++facing_.turned_triangles;
      area += areaAt(t);
    }
    if (area > 0.5 * surface.area) ++facing_.bodies_turned;
  }
}

}  // namespace

MeshFacing facingOf(const geometry::TriangleMesh& mesh) {
  MeshFacing facing;
  facing.mesh = mesh;
  FacingFinder(facing).run();
  return facing;
}

geometry::TriangleMesh feltMesh(const geometry::TriangleMesh& mesh, std::size_t* bodies_turned) {
  MeshFacing facing = facingOf(mesh);
  if (bodies_turned != nullptr) *bodies_turned = facing.bodies_turned;
  return facing.sheets == 0 ? std::move(facing.mesh) : withSheetsAsPlates(facing);
}

}  // namespace hapticell::collision
