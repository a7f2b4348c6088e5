// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/signature_repair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "collision/queries/mesh_search.h"

namespace hapticell::collision {
namespace {

/// m above the surface at which a sample must be free (Contacts: 0.1 mm): what points are tested at in
/// surface_contacts_test. Half: more false walls are found than are felt; twice: narrow ones stay.
constexpr double kOff = 1e-4;
/// m that the new plane stands below the place it frees, a fifth of kOff. Half: rounding may leave it blocked; twice:
/// nearer to the surface, so more of it must be ended.
constexpr double kClear = 2e-5;
/// m: on a plane counts as behind it, as kBehindSurface. Half: noise of recognition blocks; twice: holes of 4 um.
constexpr double kBehindPlane = 2e-6;
/// m between a place that is freed and what stays blocked, a fifth of kOff. Half: ends so close that rounding decides;
/// twice: fewer false walls are freed.
constexpr double kLeastRoom = 2e-5;
/// Element values, 1.2 ms: of more samples only every n-th is repaired. Half: more false walls stay in crowded cells;
/// twice: slower first queries.
constexpr std::size_t kMostValues = 120000;
/// Of a place being free, 3 us each: 1.2 ms. Half: more false walls stay; twice: slower first queries.
constexpr std::size_t kMostFreeTests = 400;
/// Of one, in element values (10 ns). It makes the counted work go with time. Half: 15 ms of work take longer; twice:
/// more answers are pending.
constexpr std::size_t kTestWork = 300;
/// New elements of a cell, twice a set. Half: more false walls stay; twice: only in cells that no set holds.
constexpr std::size_t kMostOwn = 128;
/// Planes that end a new element (Contacts: at most three). Half: more false walls stay; twice: sets of many copies.
constexpr std::size_t kMostEnds = 3;
/// Steps of Gilbert's method, each nearer; it ends by itself at 1e-6. Half: a worse end of some elements; twice: hardly
/// used.
constexpr int kHullSteps = 40;

/// From the point of the convex hull of `points` that is nearest to q, towards q: across it stands the plane that holds
/// them farthest apart (Gilbert, "An iterative procedure for computing the minimum of a quadratic form on a convex
/// set", 1966). `across`: unit, nothing along it counts; zero: everything does. Zero where q is in the hull.
dvec3 awayFromHull(const std::vector<dvec3>& points, const dvec3& q, const dvec3& across) {
  const auto seen = [&](const dvec3& p) { return (p - q) - glm::dot(p - q, across) * across; };
  dvec3 v = seen(points.front());
  for (int i = 0; i < kHullSteps; ++i) {
    dvec3 support = v;
    double least = glm::dot(v, v) * (1.0 - 1e-6);
    for (const dvec3& p : points) {
      const dvec3 s = seen(p);
      if (glm::dot(v, s) < least) least = glm::dot(v, s), support = s;
    }
    const dvec3 way = support - v;
    const double length = glm::dot(way, way);
    if (length < 1e-24) break;
    v += std::clamp(-glm::dot(v, way) / length, 0.0, 1.0) * way;
  }
  return -v;
}

/// A plane with q in front and all of `freed` behind it, if one of some likely directions gives one.
std::optional<ElementTrim> oneEnd(const std::vector<dvec3>& freed, const dvec3& nhat, const dvec3& q) {
  if (freed.empty()) return std::nullopt;
  dvec3 mean(0.0), near_mean(0.0), nearest = freed.front();
  for (const dvec3& p : freed) {
    const dvec3 way = q - p;
    const double length = std::max(1e-9, glm::length(way));
    mean += way / length;
    near_mean += way / (length * length * length);
    if (length < glm::length(q - nearest)) nearest = p;
  }
  std::optional<ElementTrim> best;
  double widest = kLeastRoom;
  for (const dvec3& way :
       {q - nearest, mean, near_mean, nhat, awayFromHull(freed, q, dvec3(0.0)), awayFromHull(freed, q, nhat)}) {
    for (const dvec3& d : {way, way - glm::dot(way, nhat) * nhat}) {
      if (glm::length(d) < 1e-12) continue;
      const dvec3 n = glm::normalize(d);
      double highest = -1e300;
      for (const dvec3& p : freed) highest = std::max(highest, glm::dot(n, p));
      const double room = glm::dot(n, q) - highest;
      if (room <= widest) continue;
      widest = room;
      best.emplace();
      best->surface.axis_M = n;
      best->surface.p_M = q - 0.3 * room * n;
    }
  }
  return best;
}

class Repair {
 public:
  Repair(const RepairTask& task, SignatureCell& cell) : task_(task), cell_(cell) {}
  std::size_t run();

 private:
  bool isBehind(std::size_t group, const dvec3& q) const;
  bool isFree(const dvec3& q) const;
  bool needs(const SignedSample& sample, std::size_t group) const;
  void free(std::size_t group, const SignedSample& from, const dvec3& q);

  const RepairTask& task_;
  SignatureCell& cell_;
  std::size_t work_ = 0;
};

bool Repair::isBehind(std::size_t group, const dvec3& q) const {
  const auto& names = cell_.groups[group];
  return std::none_of(names.begin(), names.end(),
                      [&](auto name) { return elementValue(cell_.element(task_.model, name), q, task_.radius) > 0.0; });
}

bool Repair::isFree(const dvec3& q) const {
  const MeshCollider& collider = task_.model.collider();
  if (collider.contains(q)) return false;
  return task_.radius <= 0.0 || !nearestPoint(collider, q, task_.radius).found;
}

/// The group alone keeps this sample blocked.
bool Repair::needs(const SignedSample& sample, std::size_t group) const {
  const Signature& own = task_.signatures[sample.signature];
  if (!own.contains(task_.groups[group])) return false;
  for (std::size_t i = 0; i < task_.groups.size(); ++i) {
    if (i != group && own.contains(task_.groups[i])) return false;
  }
  return true;
}

void Repair::free(std::size_t group, const SignedSample& from, const dvec3& q) {
  SurfaceElement plane;
  plane.shape.axis_M = from.nhat_M;
  plane.shape.p_M = q - kClear * from.nhat_M - task_.radius * from.nhat_M;
  std::vector<dvec3> freed;  // what must stay blocked
  for (const SignedSample& sample : task_.samples) {
    if (elementValue(plane, sample.p_M, task_.radius) > -kBehindPlane && needs(sample, group))
      freed.push_back(sample.p_M);
  }
  work_ += task_.samples.size();
  if (const auto end = oneEnd(freed, from.nhat_M, q)) {
    plane.trims.push_back(*end);
    freed.clear();
  }
  while (!freed.empty()) {
    if (plane.trims.size() == kMostEnds) return;
    const auto nearest = std::min_element(freed.begin(), freed.end(), [&](const dvec3& a, const dvec3& b) {
      return glm::length(a - q) < glm::length(b - q);
    });
    const dvec3 way = q - *nearest;
    if (glm::length(way) < 4.0 * kBehindPlane) return;
    ElementTrim end;
    end.surface.axis_M = glm::normalize(way);
    end.surface.p_M = *nearest + 0.7 * way;
    std::erase_if(freed, [&](const dvec3& p) { return signedDistance(end.surface, p) <= -kBehindPlane; });
    plane.trims.push_back(end);
  }
  cell_.groups[group].push_back(SignatureCell::kOwn + static_cast<std::uint32_t>(cell_.own.size()));
  cell_.own.push_back(std::move(plane));
}

std::size_t Repair::run() {
  std::size_t values = 0, tests = 0;
  for (const auto& group : cell_.groups) values += group.size();
  if (values == 0) return 0;
  const std::size_t most = std::max<std::size_t>(1, kMostValues / values);
  const std::size_t stride = std::max<std::size_t>(1, (task_.samples.size() + most - 1) / most);
  for (std::size_t i = 0; i < task_.samples.size(); i += stride) {
    const SignedSample& sample = task_.samples[i];
    const dvec3 q = sample.p_M + kOff * sample.nhat_M;
    bool known_free = false;
    for (std::size_t group = 0; group < cell_.groups.size(); ++group) {
      if (!isBehind(group, q)) continue;
      if (!known_free && (++tests > kMostFreeTests || !isFree(q))) break;
      known_free = true;
      if (cell_.own.size() < kMostOwn) free(group, sample, q);
    }
    if (tests > kMostFreeTests || cell_.own.size() >= kMostOwn) break;
  }
  return work_ + values * std::min(most, task_.samples.size()) + tests * kTestWork;
}

}  // namespace

std::size_t repairGroups(const RepairTask& task, SignatureCell& cell) {
  return Repair(task, cell).run();
}

}  // namespace hapticell::collision
