// SPDX-License-Identifier: Apache-2.0
#include "collision/zone_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "collision/direction_choice.h"
#include "collision/group_reduction.h"
#include "collision/mesh_search.h"
#include "collision/separating_directions.h"
#include "geometry/assertion.h"

namespace hapticell::collision {
namespace {

constexpr double kShrink = 0.65;
constexpr std::size_t kMostPairs = 600;
constexpr std::size_t kHopelessPairs = 2 * kMostPairs;
constexpr std::size_t kMostCandidates = 4000;  // pairs of pieces that are looked at more closely
constexpr std::size_t kMostTests = 20000;      // pairs of triangles
constexpr std::size_t kFewPieces = 256;        // of a part; with more its triangles are searched
constexpr std::size_t kManyPieces = 300;       // of all parts; with more the zone is grown from small
constexpr std::size_t kFewVertices = 200;      // of a pair; with more its directions are sought at once
constexpr std::size_t kFewDirections = 2000;   // with more the zone is not tried as a whole at first but grown
constexpr std::size_t kMostDirections = 20000;

/// How closely a zone is described; coarser ones are tried before it shrinks.
struct Effort {
  std::size_t supports;  // corners of one face that turning could bring up
  ReductionTolerance tolerance;
};
constexpr Effort kEfforts[] = {{8, {1e-6, 0.0, 1.0}}, {4, {3e-6, 0.02, 1.0}}, {2, {1e-5, 0.08, 1.0}}};
constexpr Effort kCrowded = {2, {1e-5, 0.08, 0.0}};  // turning is left out of what implies what
constexpr Effort kAllEfforts[] = {kEfforts[0], kEfforts[1], kEfforts[2], kCrowded};
constexpr double kLeastShare = 0.05;  // of the wanted radius, before kCrowded is tried
constexpr double kCrowdedShare = 0.25;
constexpr double kNear = 0.0005;         // m above the boundary: directions with all their corners,
constexpr std::ptrdiff_t kManyNear = 8;  // unless there are so many (a bore) that they hold the body upright together

geometry::Bounds grown(geometry::Bounds bounds, double by) {
  bounds.min -= dvec3(by);
  bounds.max += dvec3(by);
  return bounds;
}

bool overlap(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2);
  hash *= 0xff51afd7ed558ccdull;
  return hash ^ (hash >> 33);
}

/// Forgets the directions that were not chosen.
void keepChosen(PieceGroup& group) {
  std::vector<SeparatingDirection> kept;
  for (const auto i : group.chosen) kept.push_back(std::move(group.directions[i]));
  group.directions = std::move(kept);
  for (std::uint32_t i = 0; i < group.chosen.size(); ++i) group.chosen[i] = i;
}

/// Pieces of one part placed in the world, each when first asked for.
class PlacedPart {
 public:
  explicit PlacedPart(const ZonePart& part) : part_(part), placed_(part.pieces->pieces().size()) {
    bounds_W_ = geometry::transformed(part.X_W, part.pieces->bounds());
  }

  const ZonePart& part() const { return part_; }
  const geometry::Bounds& bounds() const { return bounds_W_; }

  const PlacedPiece& piece(std::uint32_t index) {
    if (!placed_[index]) placed_[index] = placed(part_.pieces->pieces()[index], part_.X_W);
    return *placed_[index];
  }

  /// Pieces whose box comes near a box in the world.
  std::vector<std::uint32_t> near(const geometry::Bounds& box_W) {
    std::vector<std::uint32_t> found;
    const geometry::Bounds box_M = geometry::transformed(part_.X_W.inverse(), box_W);
    const auto& pieces = part_.pieces->pieces();
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (overlap(pieces[i].bounds, box_M) && overlap(piece(i).bounds_W, box_W)) found.push_back(i);
    }
    return found;
  }

  bool isLarge() const { return placed_.size() > kFewPieces; }
  LabelledMesh labelled() const {
    return {*part_.pieces->surface(), part_.pieces->pieceOfEachTriangle(), static_cast<std::uint32_t>(placed_.size())};
  }

 private:
  ZonePart part_;
  geometry::Bounds bounds_W_;
  std::vector<std::optional<PlacedPiece>> placed_;
};

struct NearPair {
  std::uint32_t environment_part = 0;
  std::uint32_t moving_piece = 0;
  std::uint32_t environment_piece = 0;
  SeparatingDirection nearest;
};

PieceGroup groupOf(const PlacedPiece& a, const PlacedPiece& b, const NearPair& pair, const DirectionLimits& limits) {
  PieceGroup group{
      pair.environment_part, pair.moving_piece, pair.environment_piece, separatingDirections(a, b, limits), {}};
  if (group.directions.empty() && isInside(a, b)) {
    DirectionLimits endless = limits;  // they overlap deeper than the zone
    endless.reach = 1e9;
    group.directions = separatingDirections(a, b, endless);
  }
  const bool apart = !group.directions.empty() && group.directions.front().gap > 0.0;
  if (!apart && pair.nearest.gap > 0.0) group.directions.insert(group.directions.begin(), pair.nearest);
  return group;
}

class ZoneQuery {
 public:
  ZoneQuery(std::span<const ZonePart> moving, std::span<const ZonePart> environment, const ZoneOptions& options)
      : options_(options) {
    for (const ZonePart& part : moving) moving_.emplace_back(part);
    for (const ZonePart& part : environment) environment_.emplace_back(part);
  }

  ZoneContacts run();

 private:
  std::vector<double> levels() const;
  ZoneContacts search();
  ZoneContacts searchFromHint();
  std::optional<ZoneContacts> attemptAny(double radius, bool crowded);
  DirectionLimits limits(std::size_t moving_part, double radius) const;
  bool counts(std::size_t moving_part, std::size_t environment_part) const;
  /// False: more pairs than can be looked at; the zone must shrink.
  bool collect(std::size_t moving_part, const DirectionLimits& limits, std::vector<PieceGroup>& groups);
  /// Pairs of pieces that come within the reach, as far as that is known quickly; not all of them where they are many.
  std::vector<NearPair> nearPairs(std::size_t moving_part, const DirectionLimits& limits);
  /// False: more than can be looked at.
  bool candidates(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found);
  /// One after the other until the entries fit.
  std::optional<ZoneContacts> attempt(double radius, std::span<const Effort> efforts);
  std::optional<ZoneContacts> written(const std::vector<std::vector<PieceGroup>>& groups, double radius,
                                      const Effort& effort) const;
  ZoneContacts nearestOnly(double radius);
  void write(std::size_t moving_part, const PieceGroup& group, ZoneContacts& result) const;
  ZoneContact entry(std::size_t moving_part, const PieceGroup& group, const SeparatingDirection& direction,
                    const SupportPoint& support) const;

  ZoneOptions options_;
  std::vector<PlacedPart> moving_;
  std::vector<PlacedPart> environment_;
  std::size_t most_directions_ = kFewDirections;
  std::size_t work_ = 0;
  bool complete_ = true;  // Of the last nearPairs().
};

DirectionLimits ZoneQuery::limits(std::size_t moving_part, double radius) const {
  const double scale = radius / options_.radius;
  const double own = moving_[moving_part].part().reach;
  return {(own > 0.0 ? own : options_.radius) * scale + options_.safety_distance, options_.max_rotation * scale,
          kEfforts[0].supports};
}

bool ZoneQuery::counts(std::size_t moving_part, std::size_t environment_part) const {
  return options_.pair_mask.empty() || options_.pair_mask[moving_part * environment_.size() + environment_part] != 0;
}

bool ZoneQuery::candidates(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found) {
  if (a.isLarge() || b.isLarge()) {
    SearchBudget budget{kMostCandidates, kMostTests};
    const bool all =
        labelPairsWithin(a.labelled(), b.labelled(), a.part().X_W.inverse() * b.part().X_W, reach, budget, found);
    work_ += (kMostTests - budget.tests) / 2;
    return all;
  }
  found.clear();
  const auto pieces_a = a.near(grown(b.bounds(), reach));
  const auto pieces_b = b.near(grown(a.bounds(), reach));
  for (const auto i : pieces_a) {
    const geometry::Bounds box = grown(a.piece(i).bounds_W, reach);
    for (const auto j : pieces_b) {
      if (overlap(box, b.piece(j).bounds_W)) found.push_back({i, j});
    }
  }
  return true;
}

std::vector<NearPair> ZoneQuery::nearPairs(std::size_t moving_part, const DirectionLimits& limits) {
  std::vector<NearPair> pairs;
  std::vector<LabelPair> found;
  complete_ = true;
  PlacedPart& a = moving_[moving_part];
  for (std::uint32_t e = 0; e < environment_.size(); ++e) {
    PlacedPart& b = environment_[e];
    if (!counts(moving_part, e) || !overlap(grown(a.bounds(), limits.reach), b.bounds())) continue;
    const bool all = candidates(a, b, limits.reach, found);
    for (const auto& [i, j] : found) {
      const geometry::Bounds box = grown(a.piece(i).bounds_W, limits.reach);
      if (!overlap(box, b.piece(j).bounds_W) || !mayMeet(a.piece(i), b.piece(j), limits.reach)) continue;
      NearPair pair{e, i, j, {}};
      if (a.piece(i).vertices_W.size() + b.piece(j).vertices_W.size() <= kFewVertices) {
        pair.nearest = nearestDirection(a.piece(i), b.piece(j), limits.reach);
        work_ += 2;
      }
      if (pair.nearest.gap > limits.reach) continue;
      pairs.push_back(std::move(pair));
      if (pairs.size() > kHopelessPairs) break;
    }
    complete_ = complete_ && all && pairs.size() <= kHopelessPairs;
    if (!complete_) return pairs;
  }
  return pairs;
}

bool ZoneQuery::collect(std::size_t moving_part, const DirectionLimits& limits, std::vector<PieceGroup>& groups) {
  const std::vector<NearPair> pairs = nearPairs(moving_part, limits);
  if (!complete_) return false;
  std::size_t directions = 0;
  for (const NearPair& pair : pairs) {
    PieceGroup group = groupOf(moving_[moving_part].piece(pair.moving_piece),
                               environment_[pair.environment_part].piece(pair.environment_piece), pair, limits);
    if (group.directions.empty() || group.directions.front().gap > limits.reach) continue;
    directions += group.directions.size();
    work_ += 1 + group.directions.size();
    groups.push_back(std::move(group));
    if (directions > most_directions_ || groups.size() > kMostPairs) return false;
  }
  return true;
}

ZoneContact ZoneQuery::entry(std::size_t moving_part, const PieceGroup& group, const SeparatingDirection& direction,
                             const SupportPoint& support) const {
  ZoneContact contact;
  contact.moving_part = static_cast<std::uint32_t>(moving_part);
  contact.environment_part = group.environment_part;
  contact.p_W = support.p_W;
  contact.q_W = support.q_W;
  contact.nhat_W = direction.nhat_W;
  contact.gap = support.gap - direction.tightened;
  contact.normal_moves = support.normal_moves;
  std::uint64_t id = mixed(moving_[moving_part].part().key, environment_[group.environment_part].part().key);
  // Which corner of a face is the nearest changes easily; the face does not.
  const std::uint32_t feature_a = direction.on_obstacle_face ? 0 : direction.feature_A;
  const std::uint32_t feature_b = !direction.on_obstacle_face && direction.on_moving_face ? 0 : direction.feature_B;
  for (const std::uint32_t part :
       {group.moving_piece, group.environment_piece, feature_a, feature_b, support.feature}) {
    id = mixed(id, part);
  }
  contact.id = id;
  return contact;
}

void ZoneQuery::write(std::size_t moving_part, const PieceGroup& group, ZoneContacts& result) const {
  // Group 0 holds every direction's own support; one more group for each further corner that turning could bring up.
  std::vector<std::uint32_t> features;
  for (const auto i : group.chosen) {
    const auto& supports = group.directions[i].supports;
    for (std::size_t k = 1; k < supports.size(); ++k) features.push_back(supports[k].feature);
  }
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  features.insert(features.begin(), 0xFFFFFFFFu);
  for (const auto feature : features) {
    for (const auto i : group.chosen) {
      const SeparatingDirection& direction = group.directions[i];
      const auto found = std::find_if(direction.supports.begin(), direction.supports.end(),
                                      [&](const SupportPoint& s) { return s.feature == feature; });
      const SupportPoint& support = found == direction.supports.end() ? direction.supports.front() : *found;
      result.contacts.push_back(entry(moving_part, group, direction, support));
      result.contacts.back().group = result.groups;
    }
    ++result.groups;
  }
}

std::optional<ZoneContacts> ZoneQuery::written(const std::vector<std::vector<PieceGroup>>& groups, double radius,
                                               const Effort& effort) const {
  ZoneContacts result;
  result.radius = radius;
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    std::vector<PieceGroup> reduced = groups[m];
    const auto isNear = [this](const SeparatingDirection& d) { return d.gap < options_.safety_distance + kNear; };
    std::ptrdiff_t near = 0;
    for (const PieceGroup& group : reduced)
      near += std::count_if(group.directions.begin(), group.directions.end(), isNear);
    for (PieceGroup& group : reduced) {
      for (SeparatingDirection& direction : group.directions) {
        // What is about to touch keeps its corners: over a missing one the body would tilt into the obstacle.
        const bool whole = near <= kManyNear && isNear(direction);
        thinOut(direction.supports, whole ? kEfforts[0].supports : effort.supports);
      }
    }
    ReductionTolerance tolerance = effort.tolerance;
    tolerance.boundary = options_.safety_distance;
    reduceGroups(reduced, limits(m, radius), moving_[m].bounds().center(), tolerance);
    for (const PieceGroup& group : reduced) write(m, group, result);
    if (result.contacts.size() > options_.max_entries) return std::nullopt;
  }
  return result;
}

std::optional<ZoneContacts> ZoneQuery::attempt(double radius, std::span<const Effort> efforts) {
  std::vector<std::vector<PieceGroup>> groups(moving_.size());
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    if (!collect(m, limits(m, radius), groups[m])) return std::nullopt;
  }
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    const DirectionLimits part_limits = limits(m, radius);
    chooseDirections(groups[m], part_limits);
    for (PieceGroup& group : groups[m]) {
      for (const auto i : group.chosen) {
        completeSupports(group.directions[i], moving_[m].piece(group.moving_piece),
                         environment_[group.environment_part].piece(group.environment_piece), part_limits);
      }
      keepChosen(group);
    }
  }
  for (const Effort& effort : efforts) {
    if (auto result = written(groups, radius, effort)) return result;
  }
  return std::nullopt;
}

ZoneContacts ZoneQuery::nearestOnly(double radius) {
  ZoneContacts result;
  result.radius = radius;
  result.complete = false;
  if (options_.only_complete) return result;
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    const DirectionLimits part_limits = limits(m, radius);
    std::vector<NearPair> pairs = nearPairs(m, part_limits);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& a, const auto& b) { return a.nearest.gap < b.nearest.gap; });
    if (pairs.size() > kMostPairs) pairs.resize(kMostPairs);
    for (const NearPair& pair : pairs) {
      const PieceGroup group =
          groupOf(moving_[m].piece(pair.moving_piece),
                  environment_[pair.environment_part].piece(pair.environment_piece), pair, part_limits);
      if (group.directions.empty()) continue;
      result.contacts.push_back(entry(m, group, group.directions.front(), group.directions.front().support));
    }
  }
  std::stable_sort(result.contacts.begin(), result.contacts.end(),
                   [](const auto& a, const auto& b) { return a.gap < b.gap; });
  if (result.contacts.size() > options_.max_entries) result.contacts.resize(options_.max_entries);
  for (ZoneContact& contact : result.contacts) contact.group = result.groups++;
  return result;
}

ZoneContacts ZoneQuery::run() {
  ZoneContacts result = search();
  result.work = work_;
  result.hint.radius = result.radius;
  return result;
}

std::vector<double> ZoneQuery::levels() const {
  std::vector<double> radii{options_.radius};
  while (radii.back() * kShrink >= options_.min_radius) radii.push_back(radii.back() * kShrink);
  return radii;
}

std::optional<ZoneContacts> ZoneQuery::attemptAny(double radius, bool crowded) {
  if (!crowded || radius > kCrowdedShare * options_.radius) return attempt(radius, kEfforts);
  auto result = attempt(radius, kAllEfforts);
  if (result) result->hint.crowded = true;
  return result;
}

ZoneContacts ZoneQuery::searchFromHint() {
  most_directions_ = kMostDirections;
  const std::vector<double> radii = levels();
  std::size_t level = 0;
  while (level + 1 < radii.size() && radii[level] > options_.hint.radius * 1.001) ++level;
  const auto crowdedAt = [&](std::size_t i) {
    return options_.hint.crowded || radii[i] < kLeastShare * options_.radius;
  };
  if (auto result = attemptAny(radii[level], crowdedAt(level))) {
    if (level == 0 || !options_.hint.try_larger) return std::move(*result);
    // A zone that has room again for turning says so.
    auto larger = attemptAny(radii[level - 1], crowdedAt(level - 1));
    return larger ? std::move(*larger) : std::move(*result);
  }
  while (++level < radii.size()) {
    if (auto result = attemptAny(radii[level], crowdedAt(level))) return std::move(*result);
  }
  return nearestOnly(options_.min_radius);
}

ZoneContacts ZoneQuery::search() {
  if (options_.hint.radius > 0.0) return searchFromHint();
  const std::vector<double> radii = levels();
  std::size_t pieces = 0;
  for (const PlacedPart& part : moving_) pieces += part.part().pieces->pieces().size();
  for (const PlacedPart& part : environment_) pieces += part.part().pieces->pieces().size();
  if (pieces <= kManyPieces) {
    if (auto result = attempt(radii.front(), kEfforts)) return std::move(*result);
  }
  most_directions_ = kMostDirections;
  // Small zones are quick to try, so the largest that fits is sought from below.
  const auto grow = [&](std::span<const Effort> efforts, double least, double most) {
    std::optional<ZoneContacts> best;
    for (auto radius = radii.rbegin(); radius != radii.rend() && *radius <= most; ++radius) {
      if (*radius < least) continue;
      auto larger = attempt(*radius, efforts);
      if (!larger) break;
      best = std::move(larger);
    }
    return best;
  };
  if (auto result = grow(kEfforts, kLeastShare * options_.radius, radii.front())) return std::move(*result);
  if (auto result = grow({&kCrowded, 1}, 0.0, kCrowdedShare * options_.radius)) {
    result->hint.crowded = true;
    return std::move(*result);
  }
  return nearestOnly(options_.min_radius);
}

}  // namespace

ZoneContacts zoneContacts(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                          const ZoneOptions& options) {
  for (const ZonePart& part : moving) HAPTICELL_DEMAND(part.pieces != nullptr);
  for (const ZonePart& part : environment) HAPTICELL_DEMAND(part.pieces != nullptr);
  HAPTICELL_DEMAND(options.pair_mask.empty() || options.pair_mask.size() == moving.size() * environment.size());
  HAPTICELL_DEMAND(options.radius > 0.0 && options.max_entries > 0);
  return ZoneQuery(moving, environment, options).run();
}

}  // namespace hapticell::collision
