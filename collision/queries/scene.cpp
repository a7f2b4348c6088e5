// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/scene.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/motion_bound.h"
#include "geometry/system/assertion.h"

namespace hapticell::collision {

namespace {

/// m of way after which a part's count begins anew: up to there its rounding is below kRounding a step. Half and twice
/// as well.
constexpr double kLongestWay = 4e4;
/// Steps that collides() looks ahead, so that it need not look again for as many. Half: looks twice as often; twice:
/// more pairs are near, and are searched for it.
constexpr double kStepsAhead = 8.0;
/// Of a part's radius: a longer step than the first belongs to no motion (unrelated poses), and looks no farther than
/// the second. Half: fast motions are not foreseen; twice: unrelated poses are searched more widely.
constexpr double kLongStep = 0.06, kFarLook = 0.3;
/// m: looks at least so far where parts rest or move slowly. Half: looks more often in a slow hand; twice: more pairs
/// are near.
constexpr double kLeastLook = 1e-3;
/// By which the first search for the nearest widens when it finds nothing. Half: more searches; twice: more pairs.
constexpr double kWiden = 4.0;

}  // namespace

PartIndex Scene::addPart(const PartKey& key, std::shared_ptr<const MeshCollider> collider, const Pose& X_WP) {
  HAPTICELL_DEMAND(collider != nullptr);
  auto index = static_cast<PartIndex>(parts_.size());
  if (unused_.empty()) {
    parts_.emplace_back();
    swept_of_.push_back(0);
  } else {
    index = unused_.back();
    unused_.pop_back();
  }
  Part& part = parts_[index];
  part.key = key;
  part.X_WP = X_WP;
  part.at = placedBounds(*collider, X_WP);
  part.empty = collider->isEmpty();
  std::weak_ptr<InnerBallsOnDemand>& balls = balls_[collider.get()];
  part.balls = balls.lock();
  if (part.balls == nullptr) balls = part.balls = std::make_shared<InnerBallsOnDemand>();
  part.collider = std::move(collider);
  return index;
}

void Scene::removePart(PartIndex part) {
  if (parts_[part].balls.use_count() == 1) balls_.erase(parts_[part].collider.get());
  parts_[part] = {};
  tree_.remove(part);
  pairs_.removePart(part);
  unused_.push_back(part);
}

void Scene::setPose(PartIndex part, const Pose& X_WP) {
  travel(part, X_WP);
  parts_[part].X_WP = X_WP;
  parts_[part].has_moved = true;
  if (tree_.contains(part)) tree_.place(part, boundsOf(part).box_W());
}

void Scene::travel(PartIndex index, const Pose& X_WP) {
  Part& part = parts_[index];
  const double step = motionBound(part.X_WP, X_WP, part.collider->center(), part.at.radius) + kRounding;
  part.travelled += step;
  if (part.travelled > kLongestWay) {
    part.travelled = part.asked_at = 0.0;
    forgetQuiet(index);
    pairs_.forgetDistances(index);
  }
  if (!pairs_.isSought(index)) return;
  if (part.round != round_) part.way_of_round = 0.0;
  part.round = round_;
  part.way_of_round += step;
  sought_way_of_round_ = std::max(sought_way_of_round_, part.way_of_round);
}

void Scene::beginQuery() {
  ++round_;
  ++pass_;
  sought_way_ += sought_way_of_round_;
  sought_step_ = sought_way_of_round_;
  sought_way_of_round_ = 0.0;
  if (sought_way_ < kLongestWay) return;
  sought_way_ = 0.0;
  for (const PartIndex part : pairs_.seekers()) forgetQuiet(part);
}

void Scene::keepInTree(PartIndex part) {
  forgetQuiet(part);
  if (!parts_[part].empty && pairs_.isSought(part)) tree_.place(part, boundsOf(part).box_W());
}

PairIndex Scene::addPair(PartIndex moved, PartIndex environment, std::uint32_t tag) {
  HAPTICELL_DEMAND(moved != environment && parts_[moved].collider && parts_[environment].collider);
  const PairIndex pair = pairs_.add(moved, environment, tag);
  keepInTree(moved);
  keepInTree(environment);
  return pair;
}

void Scene::addPairs(std::span<const PartIndex> moved, std::span<const PartIndex> environment, std::uint32_t tag) {
  for (const auto& side : {moved, environment}) {
    for (const PartIndex part : side) HAPTICELL_DEMAND(parts_[part].collider);
  }
  pairs_.addSet(moved, environment, tag);
  for (const auto& side : {moved, environment}) {
    for (const PartIndex part : side) keepInTree(part);
  }
}

void Scene::clearPairs() {
  pairs_.clear();
  tree_ = {};
}

std::optional<PairIndex> Scene::pairOf(PartIndex a, PartIndex b) {
  const PairIndex pair = pairs_.find(a, b);
  return pair == ScenePairs::kNone ? std::nullopt : std::optional(pair);
}

void Scene::setEnabled(PairIndex pair, bool enabled) {
  pairs_[pair].enabled = enabled;
  forgetQuiet(pairs_[pair].moved);
  forgetQuiet(pairs_[pair].environment);
}

double Scene::way(const ScenePairs::Pair& pair) const {
  return parts_[pair.moved].travelled + parts_[pair.environment].travelled;
}

ProximityQuery& Scene::queryOf(ScenePairs::Pair& pair) {
  return pair.query.of(parts_[pair.moved].collider, parts_[pair.environment].collider);
}

DistanceResult Scene::query(PairIndex index, const DistanceDemand& demand) {
  ScenePairs::Pair& pair = pairs_[index];
  const DistanceResult result = queryOf(pair).distance(parts_[pair.moved].X_WP, parts_[pair.environment].X_WP, demand);
  const bool exact = result.beyond_limit || result.distance <= demand.exact_within;
  certify(pair, exact ? result.distance : result.distance / (1.0 + demand.tolerance));
  return result;
}

DistanceResult Scene::distance(PairIndex pair, double limit) {
  return query(pair, DistanceDemand{limit});
}

/// Every pair that may be nearer than the margin, nearest bounds first.
void Scene::gather(double margin) {
  candidates_.clear();
  ++pass_;
  for (const PartIndex seeker : pairs_.seekers()) {
    const Part& part = parts_[seeker];
    if (part.empty || part.quiet_until - part.travelled - sought_way_ >= margin) continue;
    const PlacedBounds& at = boundsOf(seeker);
    tree_.visitNear(at.box_W(), margin, [&](PartIndex other) {
      const double spheres = sphereGap(at, parts_[other].at);
      if (spheres >= margin) return;
      const PairIndex index = pairs_.find(seeker, other);
      if (index == ScenePairs::kNone) return;
      ScenePairs::Pair& pair = pairs_[index];
      if (!pair.enabled || pair.seen == pass_) return;
      pair.seen = pass_;
      const double known = std::max(spheres, pair.apart_until - way(pair));
      if (known >= margin) return;
      const double bound = std::max(known, boxGap(at, parts_[other].at));
      if (bound < margin) candidates_.push_back({bound, index});
    });
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.lower_bound != b.lower_bound ? a.lower_bound < b.lower_bound : a.pair < b.pair;
  });
}

void Scene::measure(PairIndex index, DistanceDemand& left, std::optional<PairDistance>& best) {
  const DistanceResult result = query(index, left);
  if (result.beyond_limit) return;
  best = PairDistance{index, result};
  // Far away only what is nearer by more than the tolerance is worth looking for.
  left.limit = result.distance <= left.exact_within
                   ? result.distance
                   : std::max(left.exact_within, result.distance / (1.0 + left.tolerance));
}

void Scene::searchNearest(double margin, DistanceDemand& left, std::optional<PairDistance>& best) {
  left.limit = std::min(left.limit, margin);
  gather(left.limit);
  for (const Candidate& candidate : candidates_) {
    if (candidate.lower_bound >= left.limit || (best && best->result.colliding)) return;
    if (best && best->pair == candidate.pair) continue;
    measure(candidate.pair, left, best);
  }
}

/// Around all parts that have a pair, m.
double Scene::extent() {
  geometry::Bounds all = tree_.bounds();
  for (const PartIndex part : pairs_.seekers()) {
    if (!parts_[part].empty) all.add(boundsOf(part).box_W());
  }
  return 2.0 * all.radius();
}

std::optional<PairDistance> Scene::nearest(double limit) {
  return nearest(DistanceDemand{limit});
}

std::optional<PairDistance> Scene::nearest(const DistanceDemand& demand) {
  beginQuery();
  std::optional<PairDistance> best;
  if (tree_.size() == 0) return best;
  DistanceDemand left = demand;
  // The last answer is probably near again: a bound before anything is looked for.
  const PairIndex last = pairs_.known(nearest_of_[0], nearest_of_[1]);
  if (last != ScenePairs::kNone && pairs_[last].enabled) measure(last, left, best);
  if (!best && left.limit == std::numeric_limits<double>::infinity()) {
    const double all = extent();
    for (double margin = 0.1 * all; !best && margin < all; margin *= kWiden) {
      DistanceDemand near = demand;
      searchNearest(margin, near, best);
      if (best) left = near;
    }
  } else if (best && best->result.colliding) {
    return best;
  }
  if (!best || last != ScenePairs::kNone) searchNearest(left.limit, left, best);
  if (best) {
    nearest_of_[0] = pairs_[best->pair].moved;
    nearest_of_[1] = pairs_[best->pair].environment;
  }
  return best;
}

void Scene::pairsWithin(double margin, std::vector<PairDistance>& found) {
  beginQuery();
  gather(margin);
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  for (const Candidate& candidate : candidates_) {
    const DistanceResult result = query(candidate.pair, DistanceDemand{margin});
    if (!result.beyond_limit) found.push_back({candidate.pair, result});
  }
  std::sort(found.begin() + before, found.end(),
            [](const PairDistance& a, const PairDistance& b) { return a.result.distance < b.result.distance; });
}

/// How far collides() looks: a few steps ahead on a motion, nowhere where poses are unrelated.
double Scene::lookAhead(const Part& part) const {
  const double step = part.travelled - part.asked_at + sought_step_;
  if (step > kLongStep * part.at.radius) return kTouchingDistance;
  return std::max(kLeastLook, std::min(kStepsAhead * step, kFarLook * part.at.radius));
}

void Scene::suspect(PartIndex seeker, PartIndex other) {
  const Part& part = parts_[seeker];
  const double gap = sphereGap(part.at, parts_[other].at);
  if (gap > part.look) return;
  const PairIndex index = pairs_.find(seeker, other);
  if (index == ScenePairs::kNone || !pairs_[index].enabled) return;
  if (pairs_[index].apart_until - way(pairs_[index]) > part.look) return;
  suspects_.push_back({gap, index, seeker});
}

void Scene::lookAround(PartIndex seeker) {
  Part& part = parts_[seeker];
  part.look = part.clear = lookAhead(part);
  part.asked_at = part.travelled;
  part.asked_in = round_;
  tree_.visitNear(boundsOf(seeker).box_W(), part.look, [&](PartIndex other) { suspect(seeker, other); });
}

/// How far apart they are by what is known, or else by their boxes.
double Scene::boxesApart(ScenePairs::Pair& pair) {
  const double way_of_pair = way(pair), known = pair.apart_until - way_of_pair;
  if (known > kTouchingDistance) return known;
  const double apart = boxGap(boundsOf(pair.moved), boundsOf(pair.environment));
  pair.apart_until = std::max(pair.apart_until, apart + way_of_pair);
  return apart;
}

bool Scene::collide(ScenePairs::Pair& pair, Part& seeker) {
  const Part &a = parts_[pair.moved], &b = parts_[pair.environment];
  const double way_of_pair = way(pair);
  double apart = boxesApart(pair);
  ProximityQuery* query = apart <= kTouchingDistance ? &queryOf(pair) : nullptr;
  if (query != nullptr && seeker.look > kTouchingDistance && way_of_pair >= pair.near_until) {
    if (query->within(a.X_WP, b.X_WP, seeker.look)) {
      pair.near_until = way_of_pair + 0.5 * seeker.look;
    } else {
      certify(pair, seeker.look);
      apart = pair.apart_until - way_of_pair;
    }
  }
  seeker.clear = std::min(seeker.clear, std::max(0.0, apart));
  return query != nullptr && apart <= kTouchingDistance && query->collides(a.X_WP, b.X_WP);
}

/// Whether the pair surely collides; a look that is much shorter than a search.
bool Scene::ballsMeet(ScenePairs::Pair& pair) {
  if (boxesApart(pair) > kTouchingDistance) return false;
  const Part &a = parts_[pair.moved], &b = parts_[pair.environment];
  const InnerBalls* of_a = a.balls->get(*a.collider);
  const InnerBalls* of_b = b.balls->get(*b.collider);
  return of_a != nullptr && of_b != nullptr && of_a->overlap(a.X_WP, *of_b, b.X_WP);
}

bool Scene::collides() {
  beginQuery();
  // What collided last probably does again.
  const PairIndex last = pairs_.known(met_[0], met_[1]);
  if (last != ScenePairs::kNone && pairs_[last].enabled) {
    if (collide(pairs_[last], parts_[pairs_[last].moved])) return true;
    met_[0] = met_[1];
  }
  suspects_.clear();
  for (const PartIndex seeker : pairs_.seekers()) {
    if (!parts_[seeker].empty && !isQuiet(parts_[seeker])) lookAround(seeker);
  }
  // The deepest first.
  std::sort(suspects_.begin(), suspects_.end(), [](const Suspect& a, const Suspect& b) { return a.gap < b.gap; });
  const auto isHit = [this](const Suspect& suspect) {
    // On a motion what is near was mostly free before: there balls seldom meet.
    return parts_[suspect.seeker].look <= kTouchingDistance && suspect.gap < 0.0 && ballsMeet(pairs_[suspect.pair]);
  };
  auto hit = std::find_if(suspects_.begin(), suspects_.end(), isHit);
  if (hit == suspects_.end()) {
    hit = std::find_if(suspects_.begin(), suspects_.end(), [this](const Suspect& suspect) {
      return collide(pairs_[suspect.pair], parts_[suspect.seeker]);
    });
  }
  if (hit != suspects_.end()) {
    met_[0] = pairs_[hit->pair].moved;
    met_[1] = pairs_[hit->pair].environment;
    return true;
  }
  for (const PartIndex seeker : pairs_.seekers()) {
    Part& part = parts_[seeker];
    if (part.asked_in == round_) part.quiet_until = part.clear + part.travelled + sought_way_;
  }
  return false;
}

}  // namespace hapticell::collision
