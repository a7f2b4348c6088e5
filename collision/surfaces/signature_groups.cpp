// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/signature_groups.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "collision/queries/mesh_search.h"
#include "collision/surfaces/signature.h"
#include "collision/surfaces/signature_repair.h"
#include "collision/surfaces/surface_clusters.h"

namespace hapticell::collision {
namespace {

/// Ratio of the reaches that cells are made for, so that nearly equal zones share them. Nearer to 1: fewer cells are
/// found again; half a level more (1.5): cells of up to half as much again than needed.
constexpr double kLevel = 1.25;
/// Of the reach: a cell's edge. Half: eight times the cells; twice: each looks at 1.7 reaches, with more surfaces that
/// are not met.
constexpr double kCellShare = 0.25;
/// m: on a surface counts as behind it (Contacts): twice the accuracy of recognition (1 um). Half: noise makes false
/// signatures; twice: walls thinner than 4 um vanish.
constexpr double kBehindSurface = 2e-6;
/// Of the surface's own sagitta, more than 1 for uneven facets. Below 1: facets lie in front of their own surface;
/// twice: of coarse ones thin gaps (twice 0.1 mm) are closed.
constexpr double kSagittaShare = 1.2;
/// Cosine between two normals: 120 deg. A ball that touches both walls of a slot is freed by neither. Half (105 deg):
/// corners are taken for slots; twice (180): only parallel walls.
constexpr double kOpposite = -0.5;
/// Share of the way to the facet's middle, and m at most: samples of a corner lie on this facet, not on the edge that
/// others share. Half: nearer to rounding; twice: thin facets beside it are not sampled.
constexpr double kInwards = 0.2;
constexpr double kMostInwards = 2e-4;  // m
/// Of the reach: a smaller triangle's middle stands for it. Half: up to four times the samples on fine meshes; twice:
/// signatures beside corners may be missed.
constexpr double kSmallExtent = 0.2;
/// Of the reach: one sample for each cube of it and surface. Half: eight times at most; twice: signatures of narrow
/// places may be missed.
constexpr double kGrain = 0.05;
/// Triangles near a cell: with more the zone shrinks or facets are used. Half: fine scans do so sooner; twice: first
/// queries of up to twice the time.
constexpr std::size_t kMostTriangles = 3000;
/// Of triangles and elements: about 15 ms, as kMostNewWork. Half: crowded places shrink the zone; twice: first queries
/// of 30 ms.
constexpr std::size_t kMostPairsSeen = 150000;
/// Groups of a cell: 64 entries cannot hold more, but near ones imply many. Half: crowded cells are overfull; twice:
/// more time to thin them out.
constexpr std::size_t kMostCellGroups = 400;
/// Cells kept, each some kB, until all are forgotten. Half: long ways work places out again sooner; twice: twice the
/// memory.
constexpr std::size_t kMostCells = 30000;
/// Different signatures of a cell, compared with each other: 16 million tests at most. Half: noisy places are overfull
/// sooner; twice: four times the time.
constexpr std::size_t kMostSignatures = 4000;
/// Of a triangle and a sample, in element values (10 ns): 0.6 us and 80 ns. They make the counted work go with time.
/// Half: 15 ms of work take longer; twice: more answers are pending.
constexpr std::size_t kSamplingWork = 60, kSampleWork = 8;

/// Of the directions from n1 to n2 (unit) the one that is nearest to `way`, a little inside.
dvec3 nearestBetween(const dvec3& n1, const dvec3& n2, const dvec3& way) {
  const dvec3 middle = n1 + n2;
  const double c = glm::dot(n1, n2), to1 = glm::dot(way, n1), to2 = glm::dot(way, n2);
  const double sine2 = std::max(1.0 - c * c, 1e-12);
  const double part1 = (to1 - c * to2) / sine2, part2 = (to2 - c * to1) / sine2;
  const dvec3 within = part1 * n1 + part2 * n2;
  const bool inside = part1 >= 0.0 && part2 >= 0.0 && glm::length(within) > 1e-9;
  const dvec3 nearer_end = to1 > to2 ? n1 : n2;
  const dvec3 nearest = inside ? glm::normalize(within) : nearer_end;
  return glm::normalize(nearest + 0.02 * middle);
}

/// Keeps those that contain no other.
std::vector<Signature> minimal(std::vector<Signature> all) {
  std::sort(all.begin(), all.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.count() < b.count(); });
  std::vector<Signature> kept;
  for (const Signature& one : all) {
    const bool implied = std::any_of(kept.begin(), kept.end(), [&](const auto& k) { return one.contains(k); });
    if (!implied) kept.push_back(one);
    if (kept.size() > kMostCellGroups) break;
  }
  return kept;
}

}  // namespace

std::size_t SignatureCache::KeyHash::operator()(const Key& key) const {
  std::uint64_t h = std::bit_cast<std::uint64_t>(key.radius);
  for (const std::int32_t i : {key.x, key.y, key.z, key.level}) {
    h ^= static_cast<std::uint32_t>(i) + 0x9e3779b97f4a7c15ull + (h << 6) + (h >> 2);
    h *= 0xff51afd7ed558ccdull;
    h ^= h >> 33;
  }
  return h;
}

std::size_t SignatureCache::takeWork() {
  return std::exchange(work_, 0);
}

SignatureCache::Key SignatureCache::keyOf(const dvec3& p, double radius, double reach) {
  const int level = static_cast<int>(std::ceil(std::log(std::max(reach, 1e-5)) / std::log(kLevel) - 1e-9));
  const dvec3 place = glm::floor(p / (kCellShare * std::pow(kLevel, level)));
  return {static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y), static_cast<std::int32_t>(place.z),
          level, radius};
}

const SignatureCell& SignatureCache::cell(const dvec3& p, double radius, double reach) {
  const Key key = keyOf(p, radius, reach);
  if (const auto found = cells_.find(key); found != cells_.end()) return found->second;
  if (cells_.size() >= kMostCells) cells_.clear();
  const double rounded = std::pow(kLevel, key.level), edge = kCellShare * rounded;
  return cells_.emplace(key, made(edge * (dvec3(key.x, key.y, key.z) + 0.5), 0.5 * edge, radius, rounded))
      .first->second;
}

void SignatureCache::addSample(std::uint32_t t, const dvec3& on_facet, double radius) {
  const RecognisedSurface& surface = model_->surface();
  const SurfaceElement& element = model_->elements()[model_->elementOf(t)];
  const SurfaceView view = viewFrom(element.shape, on_facet);
  // A ball as large as a bore does not get in: its rim's edges stand in the way, not its wall.
  if (std::min(view.k1, view.k2) * radius <= -1.0) return;
  const auto component = surface.closed ? surface.component[t] : 0u;
  samples_.push_back({on_facet + (radius - view.value) * view.nhat_M, view.nhat_M, component});
}

void SignatureCache::sample(std::uint32_t t, const geometry::Bounds& box, double radius, double reach) {
  const auto& mesh = model_->surface().mesh;
  const Corners corners = mesh.corners(t);
  const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto add = [&](const dvec3& p) {
    const dvec3 way = middle - p;
    const double length = glm::length(way);
    if (length < 1e-12) return addSample(t, p, radius);
    addSample(t, p + way * std::min(kInwards, kMostInwards / length), radius);
  };
  // Beyond the reach not all elements are known, so what a sample there is behind is not either. The sample is where a
  // ball's middle would be: of a ball larger than the reach every facet is farther off than that.
  const dvec3 off_facet = radius * model_->surface().normals[t];
  const auto isKnown = [&](const dvec3& p) {
    const dvec3 off = glm::max(glm::abs(p + off_facet - box.center()) - 0.5 * box.size(), dvec3(0.0));
    return glm::length(off) <= reach;
  };
  const double extent = std::max({glm::length(corners[1] - corners[0]), glm::length(corners[2] - corners[1]),
                                  glm::length(corners[0] - corners[2])});
  if (extent < kSmallExtent * reach) {
    // One for each small cube and surface is enough.
    const dvec3 place = glm::floor((middle - box.min) / (kGrain * reach));
    const Grain grain{static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z),
                      model_->elementOf(t)};
    if (isKnown(middle) && grains_.insert(grain).second) addSample(t, middle, radius);
    return;
  }
  const dvec3 nearest = closestPointOnTriangle(corners, box.center() - off_facet);
  if (!isKnown(nearest)) return;
  add(nearest);
  const auto towards = [&](const dvec3& goal) {
    const dvec3 way = goal - nearest;
    const double length = glm::length(way);
    if (length < 1e-9) return;
    double share = std::min(1.0, 2.0 * reach / length);
    while (share > 1e-3 && !isKnown(nearest + share * way)) share *= 0.9;
    add(nearest + share * way);
    if (share * length > 0.4 * reach) add(nearest + 0.5 * share * way);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    towards(corners[k]);
    towards(0.5 * (corners[k] + corners[(k + 1) % 3]));
  }
  towards(middle);
}

/// The roof over a sharp edge, where a ball rolls from one side to the other, at the place nearest to the cell.
void SignatureCache::sampleEdge(std::uint32_t t, int k, const geometry::Bounds& box, double radius, double reach) {
  const auto edge = model_->edgeElementOf(t, k);
  const auto other = model_->surface().neighbour[t][static_cast<std::size_t>(k)];
  if (edge == kNoIndex || other == kNoIndex || other < t) return;
  const auto& mesh = model_->surface().mesh;
  const dvec3 a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3), way = b - a;
  const double s = std::clamp(glm::dot(box.center() - a, way) / std::max(glm::dot(way, way), 1e-24), 0.0, 1.0);
  const dvec3 p = a + s * way;
  const auto normal = [&](std::uint32_t triangle) {
    return viewFrom(model_->elements()[model_->elementOf(triangle)].shape, p).nhat_M;
  };
  const dvec3 n1 = normal(t), n2 = normal(other);
  if (glm::length(n1 + n2) < 1e-6) return;
  const dvec3 place = glm::floor((p - box.min) / (kGrain * reach));
  const Grain grain{static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z), edge};
  if (grains_.count(grain) != 0) return;
  const auto component = model_->surface().closed ? model_->surface().component[t] : 0u;
  const auto add = [&](const dvec3& nhat_M) {
    const dvec3 rolling = p + radius * nhat_M;
    if (glm::length(glm::max(glm::abs(rolling - box.center()) - 0.5 * box.size(), dvec3(0.0))) > reach) return;
    grains_.insert(grain);
    samples_.push_back({rolling, nhat_M, component});
  };
  const dvec3 middle = glm::normalize(n1 + n2);
  add(middle);
  // A large ball is far from the roof's ridge and yet near its sides.
  const dvec3 nearest = nearestBetween(n1, n2, box.center() - p);
  if (glm::dot(nearest, middle) < 0.9999) add(nearest);
}

SignatureCell SignatureCache::made(const dvec3& center, double half, double radius, double reach) {
  SignatureCell cell;
  const geometry::Bounds box{center - dvec3(half), center + dvec3(half)};
  near_.clear();
  // About the middle: a little more than about the cube, and much quicker to find.
  trianglesWithin(model_->collider(), center, reach + radius + std::sqrt(3.0) * half, near_);
  work_ += near_.size();
  if (near_.empty()) return cell;
  if (near_.size() > kMostTriangles) {
    cell.overfull = true;
    return cell;
  }
  std::sort(near_.begin(), near_.end());
  const RecognisedSurface& surface = model_->surface();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> list;  // component, element
  for (const auto t : near_) {
    const auto component = surface.closed ? surface.component[t] : 0u;
    list.push_back({component, model_->elementOf(t)});
    if (radius <= 0.0) continue;
    for (int k = 0; k < 3; ++k) {
      if (const auto edge = model_->edgeElementOf(t, k); edge != kNoIndex) list.push_back({component, edge});
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  cell.facets = !surface.closed;
  for (const auto& [component, element] : list) cell.free_form = cell.free_form || model_->elements()[element].facet;
  cell.facets = cell.facets || cell.free_form;
  if (list.size() > Signature::kMostElements || near_.size() * list.size() > kMostPairsSeen) {
    cell.overfull = true;
    return cell;
  }
  samples_.clear();
  grains_.clear();
  for (const auto t : near_) {
    sample(t, box, radius, reach);
    for (int k = 0; radius > 0.0 && k < 3; ++k) sampleEdge(t, k, box, radius, reach);
  }
  std::vector<Signature> signatures;  // Few are different.
  std::vector<SignedSample> signed_samples;
  std::unordered_map<Signature, std::uint32_t, SignatureHash> names;
  work_ += near_.size() * kSamplingWork + samples_.size() * (kSampleWork + list.size());
  for (const Sample& s : samples_) {
    Signature signature;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].first != s.component) continue;
      const SurfaceElement& element = model_->elements()[list[i].second];
      const double tolerance = kBehindSurface + kSagittaShare * element.sagitta;
      const double value = elementValue(element, s.p_M, radius);
      if (value > tolerance) continue;
      // A ball that just fits between two walls touches both: neither frees it of the other.
      const bool touches = radius > 0.0 && value >= -tolerance;
      if (touches && glm::dot(viewFrom(element.shape, s.p_M).nhat_M, s.nhat_M) < kOpposite) continue;
      signature.add(i);
    }
    if (signature.count() == 0) continue;
    const auto [name, is_new] = names.try_emplace(signature, static_cast<std::uint32_t>(signatures.size()));
    if (is_new) signatures.push_back(signature);
    signed_samples.push_back({s.p_M, s.nhat_M, name->second});
    if (signatures.size() > kMostSignatures) break;
  }
  const bool too_many = signatures.size() > kMostSignatures;
  const std::vector<Signature> kept = too_many ? std::vector<Signature>() : minimal(signatures);
  if (too_many || kept.size() > kMostCellGroups) {
    cell.overfull = true;
    return cell;
  }
  for (const Signature& one : kept) {
    std::vector<std::uint32_t> group;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (one.has(i)) group.push_back(list[i].second);
    }
    cell.groups.push_back(std::move(group));
  }
  if (surface.closed) work_ += repairGroups({*model_, radius, signed_samples, signatures, kept}, cell);
  return cell;
}

}  // namespace hapticell::collision
