// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/facet_query.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/contacts/contact_rows.h"
#include "collision/contacts/direction_choice.h"
#include "collision/contacts/group_reduction.h"
#include "collision/contacts/placed_part.h"

namespace hapticell::collision {
namespace {

/// Pairs of pieces for one zone; ten times a set (64), as most of them are implied by others. Half: zones of toothed
/// parts shrink a level more; twice: up to twice the time of a query.
constexpr std::size_t kMostPairs = 600;
/// Pairs after which the zone is given up: up to there the farther ones may turn out implied. Half: zones that would
/// fit are given up; twice: longer until it is.
constexpr std::size_t kHopelessPairs = 2 * kMostPairs;
/// Pairs of pieces that are looked at more closely, some us each (work 2): under 10 ms. Half: crowds shrink the zone
/// sooner; twice: queries of 20 ms.
constexpr std::size_t kMostCandidates = 4000;
/// Pairs of blocks, where a mesh is cut on demand: a new block takes some ms (Performance), once. Half: zones over
/// scans are smaller; twice: a first query of up to a second.
constexpr std::size_t kMostBlocks = 200;
/// Pairs of triangles, half a work each: 10 ms. Half: crowds shrink the zone sooner; twice: queries of 20 ms.
constexpr std::size_t kMostTests = 20000;
/// Vertices of a pair; with more its directions are sought at once, as their nearest costs as much. Half: more pairs
/// are sought in full; twice: more are sought twice.
constexpr std::size_t kFewVertices = 200;
/// Directions of all groups, a us each: 20 ms, or 30 a pair. Half: round pieces shrink the zone sooner; twice: 40 ms
/// before it shrinks.
constexpr std::size_t kMostDirections = 20000;
/// m above the boundary: directions with all their corners, so that a body set down does not tilt through a missing
/// one. Half: it may tilt before the next set; twice: more of the 64 entries go to corners.
constexpr double kNear = 0.0005;
/// Unless there are so many near ones (a bore) that they hold the body upright together (commit b72f4840). Half: boxes
/// on two faces lose corners; twice: a peg in a bore fills its set.
constexpr std::ptrdiff_t kManyNear = 8;

/// Forgets the directions that were not chosen.
void keepChosen(PieceGroup& group) {
  std::vector<SeparatingDirection> kept;
  for (const auto i : group.chosen) kept.push_back(std::move(group.directions[i]));
  group.directions = std::move(kept);
  for (std::uint32_t i = 0; i < group.chosen.size(); ++i) group.chosen[i] = i;
}

}  // namespace

struct NearPair {
  std::uint32_t environment_part = 0;
  std::uint32_t moving_piece = 0;
  std::uint32_t environment_piece = 0;
  SeparatingDirection nearest;
};

/// How closely a zone is described; coarser ones are tried before it shrinks.
struct FacetQuery::Effort {
  std::size_t supports;  // corners of one face that turning could bring up
  ReductionTolerance tolerance;
};
const FacetQuery::Effort FacetQuery::kEfforts[4] = {
    {8, {1e-6, 0.0, 1.0}}, {4, {3e-6, 0.02, 1.0}}, {2, {1e-5, 0.08, 1.0}}, {2, {1e-5, 0.08, 0.0}}};

namespace {

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

}  // namespace

FacetQuery::FacetQuery(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                       const ZoneOptions& options)
    : options_(options), most_directions_(kMostDirections) {
  for (const ZonePart& part : moving) moving_.emplace_back(part);
  for (const ZonePart& part : environment) environment_.emplace_back(part);
}

FacetQuery::~FacetQuery() = default;

DirectionLimits FacetQuery::limits(std::size_t moving_part, double radius) const {
  const double scale = radius / options_.radius;
  const double own = moving_[moving_part].part().reach;
  return {(own > 0.0 ? own : options_.radius) * scale + options_.safety_distance, options_.max_rotation * scale,
          kEfforts[0].supports};
}

bool FacetQuery::counts(std::size_t moving_part, std::size_t environment_part) const {
  return options_.pair_mask.empty() || options_.pair_mask[moving_part * environment_.size() + environment_part] != 0;
}

bool FacetQuery::labelsWithin(const PlacedPart& a, const PlacedPart& b, double reach, std::size_t most,
                              std::vector<LabelPair>& found) {
  SearchBudget budget{most, kMostTests};
  const bool all =
      labelPairsWithin(a.labelled(), b.labelled(), a.part().X_W.inverse() * b.part().X_W, reach, budget, found);
  work_ += (kMostTests - budget.tests) / 2;
  return all;
}

/// Blocks that come near each other, then the pieces in them.
bool FacetQuery::candidatesOnDemand(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found) {
  std::vector<LabelPair> blocks;
  if (!labelsWithin(a, b, reach, kMostBlocks, blocks)) return false;
  std::vector<std::uint32_t> pieces_a, pieces_b;
  for (const LabelPair& pair : blocks) {
    pieces_a.clear();
    pieces_b.clear();
    a.appendPieces(pair.label_a, pieces_a);
    b.appendPieces(pair.label_b, pieces_b);
    work_ += (pieces_a.size() + pieces_b.size()) / 4;
    for (const auto i : pieces_a) {
      const geometry::Bounds box = grown(a.piece(i).bounds_W, reach);
      for (const auto j : pieces_b) {
        if (overlap(box, b.piece(j).bounds_W)) found.push_back({i, j});
      }
    }
    if (found.size() > kMostCandidates) return false;
  }
  return true;
}

bool FacetQuery::candidates(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found) {
  found.clear();
  if (a.isOnDemand() || b.isOnDemand()) return candidatesOnDemand(a, b, reach, found);
  if (a.isLarge() || b.isLarge()) return labelsWithin(a, b, reach, kMostCandidates, found);
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

std::vector<NearPair> FacetQuery::nearPairs(std::size_t moving_part, const DirectionLimits& limits) {
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

bool FacetQuery::collect(std::size_t moving_part, const DirectionLimits& limits, std::vector<PieceGroup>& groups) {
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

ZoneContact FacetQuery::entry(std::size_t moving_part, const PieceGroup& group, const SeparatingDirection& direction,
                              const SupportPoint& support) const {
  ZoneContact contact;
  contact.moving_part = static_cast<std::uint32_t>(moving_part);
  contact.environment_part = group.environment_part;
  contact.p_W = support.p_W;
  contact.q_W = support.q_W;
  contact.nhat_W = direction.nhat_W;
  contact.gap = support.gap - direction.tightened;
  contact.normal_moves = support.normal_moves;
  std::uint64_t id = mixedId(moving_[moving_part].part().key, environment_[group.environment_part].part().key);
  // Which corner of a face is the nearest changes easily; the face does not.
  const std::uint32_t feature_a = direction.on_obstacle_face ? 0 : direction.feature_A;
  const std::uint32_t feature_b = !direction.on_obstacle_face && direction.on_moving_face ? 0 : direction.feature_B;
  for (const std::uint32_t part :
       {group.moving_piece, group.environment_piece, feature_a, feature_b, support.feature}) {
    id = mixedId(id, part);
  }
  contact.id = id;
  return contact;
}

void FacetQuery::write(std::size_t moving_part, const PieceGroup& group, ZoneContacts& result) const {
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

std::optional<ZoneContacts> FacetQuery::written(const std::vector<std::vector<PieceGroup>>& groups, double radius,
                                                const Effort& effort, std::size_t max_entries) const {
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
    if (result.contacts.size() > max_entries) return std::nullopt;
  }
  return result;
}

std::optional<ZoneContacts> FacetQuery::attempt(double radius, Detail detail, std::size_t max_entries) {
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
  for (const Effort& effort : kEfforts) {
    const bool crowded = &effort == &kEfforts[3];
    if (crowded ? detail == Detail::kTurning : detail == Detail::kCrowded) continue;
    auto result = written(groups, radius, effort, max_entries);
    if (!result) continue;
    result->crowded = detail != Detail::kTurning;
    return result;
  }
  return std::nullopt;
}

ZoneContacts FacetQuery::nearestOnly(double radius, std::size_t max_entries) {
  ZoneContacts result;
  result.radius = radius;
  result.complete = false;
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
  if (result.contacts.size() > max_entries) result.contacts.resize(max_entries);
  for (ZoneContact& contact : result.contacts) contact.group = result.groups++;
  return result;
}

}  // namespace hapticell::collision
