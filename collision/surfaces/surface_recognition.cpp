// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_recognition.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "collision/surfaces/region_grower.h"
#include "collision/surfaces/region_properties.h"
#include "collision/surfaces/surface_cache.h"
#include "collision/surfaces/surface_clusters.h"
#include "collision/trees/tree_cache.h"

namespace hapticell::collision {
namespace {

// Times each of its smooth neighbours: then it is a plane beside fillets, else one facet of free form (Contacts, 6).
// Half: large facets of free form become planes; twice: small flats stay facets.
constexpr double kPlaneIsLarger = 5.0;
// Seeds in a row that fit nothing, and a share (a fortieth) of all clusters, until a pass ends (Contacts). Half: rounds
// among free form are missed; twice: twice the time on free-form parts.
constexpr std::size_t kFewFailures = 60, kFailureShare = 40;
// Where nothing curved was found at all, as on a convex hull of a casting. Half: a small round among flats is missed;
// twice: hulls take twice as long.
constexpr std::size_t kFailuresAtFirst = 20;
// Clusters: with more, 20 seeds say too little of a part. Half: middle-sized hulls take longer; twice: rounds of large
// parts are missed.
constexpr std::size_t kSmall = 5000;
// Failures in all, and triangles for each more: they bound the time of a part by its size. Half: mixed parts are given
// up; twice: up to twice the time.
constexpr std::size_t kFewFailuresInAll = 100, kTrianglesAFailure = 30;

class Recogniser {
 public:
  Recogniser(RecognisedSurface& surface, double tolerance, const std::atomic<bool>* cancelled)
      : surface_(surface),
        tolerance_(tolerance),
        cancelled_(cancelled),
        clusters_(planarClusters(surface, tolerance)),
        grower_(surface, clusters_) {
    surface_.region_of.assign(surface_.mesh.triangles.size(), kNoIndex);
  }

  void run() {
    findCurved(0.1 * tolerance_);
    findCurved(tolerance_);
    absorb();
    findPlanes();
    mergeEqual();
    gatherFreeForm();
  }

 private:
  bool isCancelled() const { return cancelled_ != nullptr && *cancelled_; }
  void findCurved(double tolerance);
  void absorb();
  void findPlanes();
  void mergeEqual();
  void gatherFreeForm();
  void add(const SurfaceShape& shape, std::vector<std::uint32_t> triangles);
  bool isPlane(std::uint32_t cluster) const;

  RecognisedSurface& surface_;
  double tolerance_;
  const std::atomic<bool>* cancelled_;
  PlanarClusters clusters_;
  RegionGrower grower_;
};

void Recogniser::add(const SurfaceShape& shape, std::vector<std::uint32_t> triangles) {
  const auto name = static_cast<std::uint32_t>(surface_.regions.size());
  for (const auto t : triangles) surface_.region_of[t] = name;
  grower_.take(triangles);
  SurfaceRegion region;
  region.shape = shape;
  region.triangles = std::move(triangles);
  surface_.regions.push_back(std::move(region));
}

void Recogniser::findCurved(double tolerance) {
  std::vector<std::uint32_t> order;  // clusters, largest first
  for (std::uint32_t c = 0; c < clusters_.triangles.size(); ++c) order.push_back(c);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return clusters_.areas[a] > clusters_.areas[b]; });
  // Where so many seeds in a row fit nothing the rest is free form.
  const std::size_t most_failures = kFewFailures + order.size() / kFailureShare;
  const std::size_t most_in_all = kFewFailuresInAll + surface_.mesh.triangles.size() / kTrianglesAFailure;
  std::size_t failures = 0, failures_in_all = 0;
  for (const auto cluster : order) {
    const bool none_yet = surface_.regions.empty() && order.size() < kSmall;
    if (failures > (none_yet ? kFailuresAtFirst : most_failures) || failures_in_all > most_in_all) break;
    if (isCancelled()) break;
    const auto seed = clusters_.triangles[cluster].front();
    if (!grower_.isFree(seed)) continue;
    const auto& members = clusters_.triangles[cluster];
    const bool curved = std::any_of(members.begin(), members.end(), [&](auto t) { return grower_.isCurvedAt(t); });
    if (!curved) continue;
    auto region = grower_.regionFrom(seed, tolerance);
    failures = region ? 0 : failures + 1;
    failures_in_all += region ? 0 : 1;
    if (region) add(region->shape, std::move(region->triangles));
  }
}

/// Slivers whose vertices all lie on the region beside them.
void Recogniser::absorb() {
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    if (surface_.region_of[t] != kNoIndex) open.push_back(t);
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto name = surface_.region_of[open[i]];
    for (const auto other : surface_.neighbour[open[i]]) {
      if (other == kNoIndex || surface_.region_of[other] != kNoIndex) continue;
      if (!grower_.belongs(other, surface_.regions[name].shape, tolerance_)) continue;
      surface_.region_of[other] = name;
      surface_.regions[name].triangles.push_back(other);
      grower_.take({other});
      open.push_back(other);
    }
  }
}

bool Recogniser::isPlane(std::uint32_t cluster) const {
  for (const auto t : clusters_.triangles[cluster]) {
    for (const auto other : surface_.neighbour[t]) {
      if (other == kNoIndex || surface_.region_of[other] != kNoIndex || clusters_.cluster_of[other] == cluster)
        continue;
      const double cosine = glm::dot(surface_.normals[t], surface_.normals[other]);
      if (cosine < 0.766 || cosine > 0.99999848) continue;
      if (clusters_.areas[cluster] < kPlaneIsLarger * clusters_.areas[clusters_.cluster_of[other]]) return false;
    }
  }
  return true;
}

void Recogniser::findPlanes() {
  std::vector<std::uint32_t> planes;
  for (std::uint32_t c = 0; c < clusters_.triangles.size(); ++c) {
    std::vector<std::uint32_t> left;
    for (const auto t : clusters_.triangles[c]) {
      if (surface_.region_of[t] == kNoIndex) left.push_back(t);
    }
    if (left.empty()) continue;
    clusters_.triangles[c] = std::move(left);
    if (isPlane(c)) planes.push_back(c);
  }
  for (const auto c : planes) {
    SurfaceShape plane;
    plane.axis_M = surface_.normals[clusters_.triangles[c].front()];
    plane.p_M = middleOf(surface_.mesh, clusters_.triangles[c].front());
    add(plane, clusters_.triangles[c]);
  }
}

/// Neighbours on the same surface become one region.
void Recogniser::mergeEqual() {
  std::vector<std::uint32_t> into(surface_.regions.size());
  std::iota(into.begin(), into.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (into[i] != i) i = into[i] = into[into[i]];
    return i;
  };
  const auto lies = [&](std::uint32_t a, std::uint32_t b) {
    return std::all_of(surface_.regions[a].triangles.begin(), surface_.regions[a].triangles.end(),
                       [&](auto t) { return grower_.belongs(t, surface_.regions[b].shape, tolerance_); });
  };
  for (std::uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    for (const auto other : surface_.neighbour[t]) {
      if (other == kNoIndex || surface_.region_of[t] == kNoIndex || surface_.region_of[other] == kNoIndex) continue;
      auto a = root(surface_.region_of[t]), b = root(surface_.region_of[other]);
      if (a == b || surface_.regions[a].shape.type != surface_.regions[b].shape.type) continue;
      if (surface_.regions[a].shape.type == SurfaceType::kPlane) continue;
      if (surface_.regions[a].triangles.size() > surface_.regions[b].triangles.size()) std::swap(a, b);
      if (glm::dot(surface_.normals[t], surface_.normals[other]) < 0.766 || !lies(a, b)) continue;
      auto& from = surface_.regions[a].triangles;
      auto& to = surface_.regions[b].triangles;
      to.insert(to.end(), from.begin(), from.end());
      from.clear();
      into[a] = b;
    }
  }
  std::vector<SurfaceRegion> kept;
  for (SurfaceRegion& region : surface_.regions) {
    if (region.triangles.empty()) continue;
    for (const auto t : region.triangles) surface_.region_of[t] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(std::move(region));
  }
  surface_.regions = std::move(kept);
}

void Recogniser::gatherFreeForm() {
  SurfaceShape none;
  none.type = SurfaceType::kFreeForm;
  for (std::uint32_t first = 0; first < surface_.mesh.triangles.size(); ++first) {
    if (surface_.region_of[first] != kNoIndex) continue;
    const auto name = static_cast<std::uint32_t>(surface_.regions.size());
    std::vector<std::uint32_t> triangles{first};
    surface_.region_of[first] = name;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (const auto other : surface_.neighbour[triangles[i]]) {
        if (other == kNoIndex || surface_.region_of[other] != kNoIndex) continue;
        surface_.region_of[other] = name;
        triangles.push_back(other);
      }
    }
    add(none, std::move(triangles));
  }
}

}  // namespace

RecognisedSurface recogniseSurfaces(const geometry::TriangleMesh& mesh, const RecognitionOptions& options) {
  RecognisedSurface surface = connectedSurface(mesh);
  if (surface.mesh.triangles.empty()) return surface;
  const double size = glm::length(surface.mesh.bounds().size());
  const double tolerance = options.tolerance > 0.0 ? options.tolerance : std::max(1e-6, 2e-6 * size);
  const SurfaceCache cache(options.tolerance > 0.0 ? std::filesystem::path() : options.cache_folder);
  const ContentHash hash = options.cache_folder.empty() ? ContentHash{} : contentHash(mesh);
  if (!cache.load(hash, surface)) {
    Recogniser(surface, tolerance, options.cancelled).run();
    // As they are when they come from the disk, so that all that is measured is equal to the last bit.
    for (SurfaceRegion& region : surface.regions) std::sort(region.triangles.begin(), region.triangles.end());
    if (options.cancelled == nullptr || !*options.cancelled) cache.store(hash, surface);
  }
  measureRegions(surface);
  return surface;
}

}  // namespace hapticell::collision
