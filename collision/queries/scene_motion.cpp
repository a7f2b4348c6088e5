// SPDX-License-Identifier: Apache-2.0
// Scene::advance() and Scene::findNearer().
#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/queries/motion_bound.h"
#include "collision/queries/scene.h"

namespace hapticell::collision {

namespace {

/// m of motion: shorter stretches are not halved but followed by the exact check. Half: more halvings near contact;
/// twice: longer stretches to follow there.
constexpr double kShortStretch = 5e-3;
/// Halvings: of 80 m down to the above. Half: 128 times longer stretches are followed; twice: none is so long.
constexpr int kMostHalvings = 14;
/// Share of a clearance: findNearer() halves until a stretch is no longer than this, so it asks for at most half of it
/// more. Half: one halving more near contact; twice: passages a fifth wider than the clearance are not passed.
constexpr double kProofShare = 0.2;
/// m: the shortest stretch of findNearer(). Half: one halving more with small clearances; twice: 0.2 mm more are kept.
constexpr double kShortestProof = 2e-4;
/// Of a stretch that findNearer() searches, against the radius of the smaller part: longer ones are halved at once, as
/// nearly all of those searches prove nothing. By `planning_bench`: half: as fast; twice: a tenth slower.
constexpr double kProvenSize = 1.0;

/// The numbers of the whole motion and of the last stretch that is searched with little effort before it is halved (the
/// halves). Half: wholes are searched long; twice: quarters are searched again in their halves.
constexpr std::size_t kWhole = 1, kSoonHalved = 3;
/// Boxes that such a search opens (a search that proves something opens 30 mostly). Half: fewer are proven; twice:
/// longer searches that prove nothing.
constexpr int kEffortBeforeHalving = 100;
constexpr int kAnyEffort = std::numeric_limits<int>::max();

/// The number of the stretch whose middle is at numerator / 2^level: neither end of the motion.
std::size_t nodeOfMiddle(std::size_t numerator, int level) {
  const int halved = std::countr_zero(numerator);
  return (std::size_t{1} << (level - halved - 1)) + (numerator >> (halved + 1));
}

/// A piece of a motion.
struct Cut {
  Cut(const PartMotion& of, double from, double to) : whole(of), begin(from), length(to - from) {
    motion.X_WStart = of.at(from);
    motion.X_WEnd = of.at(to);
    motion.path_bound = of.path_bound * length;
    motion.bend_bound = of.bend_bound * length * length;
    if (of.along) motion.along = [this](double s) { return whole.at(begin + s * length); };
  }
  Cut(const Cut&) = delete;
  Cut& operator=(const Cut&) = delete;

  const PartMotion& whole;
  double begin, length;
  PartMotion motion;
};

}  // namespace

/// Around all places of the part on its way.
geometry::Bounds Scene::sweptBox(const Swept& swept) {
  const geometry::Bounds box = swept.stations[kWhole].at.box_W();
  const Spread& spread = swept.spread[kWhole];
  const dvec3 beside = glm::abs(spread.sweep.d_W) + spread.rest;
  return {box.min - beside, box.max + beside};
}

void Scene::addMotionPair(Swept& swept, PartIndex other, double clearance, bool standing) {
  if (parts_[other].empty) return;
  const std::uint32_t listed = swept_of_[other];
  Swept* met = listed == 0 ? nullptr : &swept_[listed - 1];
  if (!standing && swept.motion->path_bound + (met == nullptr ? 0.0 : met->motion->path_bound) == 0.0) return;
  const PlacedBounds &at = swept.stations[kWhole].at,
                     &other_at = met == nullptr ? boundsOf(other) : met->stations[kWhole].at;
  const Spread still{}, &spread = swept.spread[kWhole], &other_spread = met == nullptr ? still : met->spread[kWhole];
  const dvec3 sweep_W = spread.sweep.d_W - other_spread.sweep.d_W;
  const double margin = spread.rest + other_spread.rest + clearance;
  if (sweptSphereGap(at, other_at, sweep_W) > margin) return;
  const PairIndex index = pairs_.find(swept.part, other);
  if (index == ScenePairs::kNone) return;
  ScenePairs::Pair& pair = pairs_[index];
  if (!pair.enabled || pair.seen == pass_) return;
  pair.seen = pass_;
  if (sweptBoxGap(at, other_at, sweep_W) > margin) return;
  const PlacedBounds &begin = beginOf(swept), &other_begin = met == nullptr ? other_at : beginOf(*met);
  candidates_.push_back({std::max(sphereGap(begin, other_begin), boxGap(begin, other_begin)), index});
}

/// The bounds are of the beginning, wherever the scene has its parts now. Most parts pass nothing and need none.
const PlacedBounds& Scene::beginOf(Swept& swept) const {
  if (!swept.knows_begin) swept.begin = placedBounds(*parts_[swept.part].collider, swept.X_WBegin);
  swept.knows_begin = true;
  return swept.begin;
}

void Scene::prepareMotion(std::span<const MovedPart> moved, double clearance, bool standing) {
  ++pass_;
  swept_count_ = 0;
  candidates_.clear();
  if (swept_.size() < moved.size()) swept_.resize(moved.size());
  for (const MovedPart& part : moved) {
    if (parts_[part.part].empty) continue;
    Swept& now = swept_[swept_count_++];
    now.part = part.part;
    now.motion = &part.motion;
    now.X_WBegin = part.motion.at(0.0);
    now.X_WEnd = part.motion.at(1.0);
    now.knows_begin = false;
    now.known_stations = now.known_spreads = 0;
    swept_of_[part.part] = static_cast<std::uint32_t>(swept_count_);
    const Mover mover = moverOf(part.part);
    Station scratch;
    spreadOf(mover, {0.0, 1.0, kWhole}, placeOf(mover, kWhole, 0.5, scratch));
  }
  for (Swept& swept : this->swept()) {
    tree_.visitNear(sweptBox(swept), clearance, [&](PartIndex other) {
      if (swept_of_[other] == 0) addMotionPair(swept, other, clearance, standing);
    });
    for (const Swept& other : this->swept()) {
      if (pairs_.mayBePair(swept.part, other.part)) addMotionPair(swept, other.part, clearance, standing);
    }
    if (!pairs_.isSought(swept.part)) continue;
    for (const PartIndex other : pairs_.seekers()) {  // Those that the tree does not hold.
      if (swept_of_[other] == 0 && !pairs_.isSought(other)) addMotionPair(swept, other, clearance, standing);
    }
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.lower_bound != b.lower_bound ? a.lower_bound < b.lower_bound : a.pair < b.pair;
  });
}

Scene::Mover Scene::moverOf(PartIndex part) {
  if (swept_of_[part] == 0) return {part, nullptr, &parts_[part].X_WP};
  return {part, &swept_[swept_of_[part] - 1], nullptr};
}

/// Where it is at s. The first middles are kept, as many pairs ask for them; `node` is their number, 0: none of them.
Scene::Place Scene::placeOf(const Mover& mover, std::size_t node, double s, Station& scratch) {
  if (mover.swept == nullptr) return {*mover.X_WStanding, boundsOf(mover.part)};
  const bool is_kept = node == kEndNode || (node > 0 && node < kStations);
  const std::size_t place = node == kEndNode ? 0 : node;
  const std::uint32_t bit = is_kept ? 1u << place : 0u;
  Station& station = is_kept ? mover.swept->stations[place] : scratch;
  if ((mover.swept->known_stations & bit) != 0) return {station.X_WP, station.at};
  station.X_WP = node == kEndNode ? mover.swept->X_WEnd : mover.at(s);
  station.at = placedBounds(*parts_[mover.part].collider, station.X_WP);
  mover.swept->known_stations |= bit;
  return {station.X_WP, station.at};
}

/// Towards each end a point is no farther from its chord than its path bends, and its chord is that of the sphere's
/// centre but for the turn.
Scene::Spread Scene::spreadOf(const Mover& mover, const Stretch& stretch, const Place& middle) const {
  if (mover.swept == nullptr) return {};
  Swept& swept = *mover.swept;
  const std::uint32_t bit = stretch.isKept() ? 1u << stretch.node : 0u;
  if ((swept.known_spreads & bit) != 0) return swept.spread[stretch.node];
  const PartMotion& motion = *swept.motion;
  const double half = 0.5 * (stretch.to - stretch.from);
  Spread spread{{}, motion.path_bound * half, motion.path_bound * half};
  const double beside = motion.bend_bound * half * half / 8.0;
  if (beside < spread.rest) {
    const MeshCollider& mesh = *parts_[mover.part].collider;
    Pose X_WFrom, X_WTo;
    if (stretch.isKept()) {  // Both ends are ends of the whole, or middles that were asked for.
      const int level = std::bit_width(stretch.node) - 1;
      const std::size_t whole = std::size_t{1} << level, from = stretch.node - whole, to = from + 1;
      X_WFrom = from == 0 ? swept.X_WBegin : swept.stations[nodeOfMiddle(from, level)].X_WP;
      X_WTo = to == whole ? swept.X_WEnd : swept.stations[nodeOfMiddle(to, level)].X_WP;
    } else {
      X_WFrom = motion.at(stretch.from);
      X_WTo = motion.at(stretch.to);
    }
    const dvec3& center_W = middle.at.center_W;
    const dvec3 back = X_WFrom * mesh.center() - center_W, ahead = X_WTo * mesh.center() - center_W;
    const Turn turn_back = turnOf(middle.X_WP, X_WFrom), turn_ahead = turnOf(middle.X_WP, X_WTo);
    const double bent = 0.5 * glm::length(ahead + back) + beside;
    const double rest = bent + mesh.radius() * std::max(turn_back.chord, turn_ahead.chord);
    if (rest < spread.rest) {
      spread.sweep = {0.5 * (ahead - back), 0.5 * (turn_ahead.w_W - turn_back.w_W)};
      spread.rest = rest;
      spread.bent = bent + mesh.radius() * (0.5 * glm::length(turn_ahead.w_W + turn_back.w_W) +
                                            std::max(turn_back.bent, turn_ahead.bent));
    }
  }
  if (bit != 0) {
    swept.spread[stretch.node] = spread;
    swept.known_spreads |= bit;
  }
  return spread;
}

void Scene::endMotion() {
  for (const Swept& swept : swept()) swept_of_[swept.part] = 0;
}

/// As collision::advance(), for motions that are long against what they pass: halves them until what is left of each is
/// shorter than the distance there, which most searches find without measuring it; only near contact it is followed.
MotionStop Scene::follow(ProximityQuery& query, const Mover& moved, const Mover& met, double gap,
                         const MotionDemand& demand) {
  PartMotion still_a, still_b;
  const double least = std::max(demand.clearance, kLeastClearance);
  if (gap <= least && query.within(moved.at(0.0), met.at(0.0), least))
    return collision::advance(query, moved.motion(still_a), met.motion(still_b), demand);
  constexpr std::size_t kLastNode = std::size_t{1} << kMostHalvings;
  const bool is_whole = demand.until == 1.0;
  Stretch open[kMostHalvings + 2];
  int count = 0;
  open[count++] = {0.0, demand.until, kWhole};
  Station scratch_a, scratch_b;
  MotionStop stop;
  while (count > 0) {
    const Stretch piece = open[--count];
    const double middle = piece.middle();
    const std::size_t node = is_whole ? piece.node : 0;
    const Place a = placeOf(moved, node, middle, scratch_a), b = placeOf(met, node, middle, scratch_b);
    const Stretch stretch{piece.from, piece.to, node};
    const Spread of_a = spreadOf(moved, stretch, a), of_b = spreadOf(met, stretch, b);
    const dvec3 sweep_W = of_a.sweep.d_W - of_b.sweep.d_W;
    const double margin = least + of_a.rest + of_b.rest + kRounding;
    if (sweptSphereGap(a.at, b.at, sweep_W) > margin) continue;
    if (sweptBoxGap(a.at, b.at, sweep_W) > margin) continue;
    const bool is_long = 2.0 * (margin + glm::length(sweep_W)) > kShortStretch && piece.node < kLastNode;
    // Of a long stretch each half is soon looked at, with less to look for: the whole is not worth much.
    const int effort = !is_long || piece.node > kSoonHalved ? kAnyEffort : kEffortBeforeHalving;
    const double bent = least + of_a.bent + of_b.bent + kRounding;
    if (piece.node > kWhole && !query.mayMeet({a.X_WP, of_a.sweep}, {b.X_WP, of_b.sweep}, bent, effort)) continue;
    if (is_long) {
      open[count++] = {middle, piece.to, 2 * piece.node + 1};
      open[count++] = {piece.from, middle, 2 * piece.node};
      continue;
    }
    const Cut cut_a(moved.motion(still_a), piece.from, piece.to), cut_b(met.motion(still_b), piece.from, piece.to);
    stop = collision::advance(query, cut_a.motion, cut_b.motion, {demand.clearance, 1.0});
    stop.s = piece.from + stop.s * (piece.to - piece.from);
    if (stop.stopped) return stop;
  }
  stop.s = demand.until;
  return stop;
}

SceneStop Scene::stopOnce(double clearance, double until) {
  SceneStop stop;
  stop.s = until;
  const double least = std::max(clearance, kLeastClearance);
  for (const Candidate& candidate : candidates_) {
    ScenePairs::Pair& pair = pairs_[candidate.pair];
    const Mover moved = moverOf(pair.moved), met = moverOf(pair.environment);
    const double reach = (moved.pathBound() + met.pathBound()) * stop.s;
    if (stop.s == 0.0 && !stop.began_colliding && candidate.lower_bound <= kTouchingDistance) {
      stop.began_colliding = queryOf(pair).collides(moved.at(0.0), met.at(0.0));
    }
    if (reach == 0.0 || candidate.lower_bound > reach + least) continue;
    const MotionStop pair_stop = follow(queryOf(pair), moved, met, candidate.lower_bound, {clearance, stop.s});
    stop.began_colliding |= pair_stop.began_colliding;
    if (!pair_stop.stopped || pair_stop.s >= stop.s) continue;
    stop.s = pair_stop.s;
    stop.stopped = true;
    stop.pair = candidate.pair;
    stop.nearest = pair_stop.nearest;
  }
  return stop;
}

SceneStop Scene::advance(std::span<const MovedPart> moved, double clearance) {
  prepareMotion(moved, std::max(clearance, kLeastClearance) + kTouchingDistance);
  SceneStop stop = stopOnce(clearance, 1.0);
  // Passes by which pairs go back that a stop found later has moved past. Then the motion is given up. Half: in crowds
  // it stops more often; twice: longer before.
  constexpr int kMostPasses = 4;
  bool holds = !stop.stopped;
  for (int pass = 0; !holds && pass < kMostPasses; ++pass) {
    SceneStop again = stopOnce(clearance, stop.s);
    holds = !again.stopped;
    if (holds) break;
    again.began_colliding = stop.began_colliding;
    stop = again;
  }
  if (!holds) stop.s = 0.0;
  endMotion();
  return stop;
}

/// Whether a pair is nearer at the end of the motion; those that do not move are only looked at here.
std::optional<PairIndex> Scene::nearerAtEnd(std::span<const double> clearance) {
  for (const Candidate& candidate : candidates_) {
    ScenePairs::Pair& pair = pairs_[candidate.pair];
    const Mover a = moverOf(pair.moved), b = moverOf(pair.environment);
    const double least = leastOf(pair, clearance), way = a.pathBound() + b.pathBound();
    if (candidate.lower_bound > way + least) continue;
    Station scratch_a, scratch_b;
    const Place end_a = placeOf(a, kEndNode, 1.0, scratch_a), end_b = placeOf(b, kEndNode, 1.0, scratch_b);
    if (sphereGap(end_a.at, end_b.at) > least || boxGap(end_a.at, end_b.at) > least) continue;
    if (queryOf(pair).within(end_a.X_WP, end_b.X_WP, least)) return candidate.pair;
  }
  return std::nullopt;
}

/// Lists the candidates that move, each for the whole motion; those that begin too near are found.
std::optional<PairIndex> Scene::listUnproven(std::span<const double> clearance) {
  unproven_.clear();
  for (const Candidate& candidate : candidates_) {
    ScenePairs::Pair& pair = pairs_[candidate.pair];
    const Mover a = moverOf(pair.moved), b = moverOf(pair.environment);
    const double least = leastOf(pair, clearance), way = a.pathBound() + b.pathBound();
    if (way == 0.0 || candidate.lower_bound > way + least) continue;
    // One inside the other is seen here only: on its way out its surface would come near.
    if (candidate.lower_bound <= least && queryOf(pair).within(a.at(0.0), b.at(0.0), least)) return candidate.pair;
    unproven_.push_back({{0.0, 1.0, kWhole}, candidate.pair, way});
  }
  return std::nullopt;
}

/// Drops what its spread keeps apart, and looks at the middles of what is left: what is not free mostly ends here.
std::optional<PairIndex> Scene::lookAtMiddles(std::span<const double> clearance) {
  std::size_t kept = 0;
  Station scratch_a, scratch_b;
  for (Unproven& one : unproven_) {
    ScenePairs::Pair& pair = pairs_[one.pair];
    const Mover a = moverOf(pair.moved), b = moverOf(pair.environment);
    const double middle = one.stretch.middle(), least = leastOf(pair, clearance);
    const Place at_a = placeOf(a, one.stretch.node, middle, scratch_a);
    const Place at_b = placeOf(b, one.stretch.node, middle, scratch_b);
    one.of_moved = spreadOf(a, one.stretch, at_a);
    one.of_environment = spreadOf(b, one.stretch, at_b);
    one.margin = least + one.of_moved.rest + one.of_environment.rest + kRounding;
    if (sweptSphereGap(at_a.at, at_b.at, one.sweep_W()) > one.margin) continue;
    if (sweptBoxGap(at_a.at, at_b.at, one.sweep_W()) > one.margin) continue;
    if (isLong(one, least) && sphereGap(at_a.at, at_b.at) <= least && boxGap(at_a.at, at_b.at) <= least &&
        queryOf(pair).within(at_a.X_WP, at_b.X_WP, least))
      return one.pair;
    unproven_[kept++] = one;
  }
  unproven_.resize(kept);
  return std::nullopt;
}

bool Scene::isLong(const Unproven& one, double least) {
  const double shortest = least <= kLeastClearance ? kShortStretch : std::max(kShortestProof, kProofShare * least);
  constexpr std::size_t kLastNode = std::size_t{1} << (kMostHalvings + 4);
  return one.length() > shortest && one.stretch.node < kLastNode;
}

/// Proves what can be proven and halves the rest; of the shortest stretches the distance in the middle decides.
std::optional<PairIndex> Scene::proveOrHalve(std::span<const double> clearance) {
  halves_.clear();
  Station scratch_a, scratch_b;
  for (const Unproven& one : unproven_) {
    ScenePairs::Pair& pair = pairs_[one.pair];
    const Mover a = moverOf(pair.moved), b = moverOf(pair.environment);
    const auto [from, to, node] = one.stretch;
    const double middle = one.stretch.middle(), least = leastOf(pair, clearance);
    const bool is_long = isLong(one, least);
    const double size = std::min(parts_[pair.moved].collider->radius(), parts_[pair.environment].collider->radius());
    const double extent = 2.0 * (one.margin + glm::length(one.sweep_W()));
    if (!is_long || extent < kProvenSize * size) {
      const Place at_a = placeOf(a, node, middle, scratch_a), at_b = placeOf(b, node, middle, scratch_b);
      const double bent = least + one.of_moved.bent + one.of_environment.bent + kRounding;
      if (!queryOf(pair).mayMeet({at_a.X_WP, one.of_moved.sweep}, {at_b.X_WP, one.of_environment.sweep}, bent))
        continue;
    }
    if (is_long) {
      halves_.push_back({{from, middle, 2 * node}, one.pair, one.way});
      halves_.push_back({{middle, to, 2 * node + 1}, one.pair, one.way});
      continue;
    }
    const Place at_a = placeOf(a, node, middle, scratch_a), at_b = placeOf(b, node, middle, scratch_b);
    if (!queryOf(pair).within(at_a.X_WP, at_b.X_WP, least + 0.5 * one.length() + kRounding)) continue;
    if (least > kLeastClearance) return one.pair;
    PartMotion still_a, still_b;
    const Cut cut_a(a.motion(still_a), from, to), cut_b(b.motion(still_b), from, to);
    const MotionStop stop = collision::advance(queryOf(pair), cut_a.motion, cut_b.motion, {0.0, 1.0});
    if (stop.stopped || stop.began_colliding) return one.pair;
  }
  std::swap(unproven_, halves_);
  return std::nullopt;
}

double Scene::leastOf(const ScenePairs::Pair& pair, std::span<const double> clearance) {
  return std::max(clearance[pair.tag], kLeastClearance);
}

std::optional<PairIndex> Scene::findNearer(std::span<const MovedPart> moved, std::span<const double> clearance,
                                           bool standing) {
  double most = kLeastClearance;
  for (const double one : clearance) most = std::max(most, one);
  prepareMotion(moved, most + kTouchingDistance, standing);
  std::optional<PairIndex> found = nearerAtEnd(clearance);
  if (!found) found = listUnproven(clearance);
  while (!found && !unproven_.empty()) {
    found = lookAtMiddles(clearance);
    if (!found) found = proveOrHalve(clearance);
  }
  endMotion();
  return found;
}

}  // namespace hapticell::collision
