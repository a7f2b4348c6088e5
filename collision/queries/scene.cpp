// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/scene.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::collision {

PartIndex Scene::addPart(const PartKey& key, std::shared_ptr<const MeshCollider> collider, const Pose& X_WP) {
  HAPTICELL_DEMAND(collider != nullptr);
  auto unused = std::find_if(parts_.begin(), parts_.end(), [](const Part& part) { return part.collider == nullptr; });
  if (unused == parts_.end()) unused = parts_.insert(parts_.end(), Part{});
  unused->key = key;
  unused->collider = std::move(collider);
  place(*unused, X_WP);
  return static_cast<PartIndex>(unused - parts_.begin());
}

void Scene::removePart(PartIndex part) {
  parts_[part] = {};
  std::erase_if(pairs_, [&](const Pair& pair) { return pair.moved == part || pair.environment == part; });
}

void Scene::setPose(PartIndex part, const Pose& X_WP) {
  place(parts_[part], X_WP);
}

void Scene::place(Part& part, const Pose& X_WP) {
  part.X_WP = X_WP;
  part.center_W = X_WP * part.collider->center();
  if (!part.collider->isEmpty())
    part.root_W = collision::moved(X_WP.R(), X_WP.p, part.collider->tree().box(BoxTree::kRoot));
}

PairIndex Scene::addPair(PartIndex moved, PartIndex environment, std::uint32_t tag) {
  HAPTICELL_DEMAND(moved != environment && parts_[moved].collider && parts_[environment].collider);
  pairs_.push_back(
      {moved, environment, tag, true, ProximityQuery(parts_[moved].collider, parts_[environment].collider)});
  candidates_.reserve(pairs_.size());
  return static_cast<PairIndex>(pairs_.size() - 1);
}

void Scene::clearPairs() {
  pairs_.clear();
}

double Scene::lowerBound(const Pair& pair) const {
  const Part &a = parts_[pair.moved], &b = parts_[pair.environment];
  if (a.collider->isEmpty() || b.collider->isEmpty()) return std::numeric_limits<double>::infinity();
  const double spheres = glm::distance(a.center_W, b.center_W) - a.collider->radius() - b.collider->radius();
  return std::max(spheres, std::sqrt(lowerBoundSquared(a.root_W, b.root_W)));
}

const std::vector<Scene::Candidate>& Scene::candidatesWithin(double margin) {
  candidates_.clear();
  for (PairIndex i = 0; i < pairs_.size(); ++i) {
    if (!pairs_[i].enabled) continue;
    const double bound = lowerBound(pairs_[i]);
    if (bound < margin) candidates_.push_back({bound, i});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.lower_bound != b.lower_bound ? a.lower_bound < b.lower_bound : a.pair < b.pair;
  });
  return candidates_;
}

DistanceResult Scene::query(PairIndex pair, double limit) {
  Pair& p = pairs_[pair];
  return p.query.distance(parts_[p.moved].X_WP, parts_[p.environment].X_WP, limit);
}

DistanceResult Scene::distance(PairIndex pair, double limit) {
  return query(pair, limit);
}

std::optional<PairDistance> Scene::nearest(double limit) {
  return nearest(DistanceDemand{limit});
}

std::optional<PairDistance> Scene::nearest(const DistanceDemand& demand) {
  std::optional<PairDistance> best;
  DistanceDemand left = demand;
  for (const Candidate& candidate : candidatesWithin(demand.limit)) {
    if (candidate.lower_bound >= left.limit) break;
    const Pair& pair = pairs_[candidate.pair];
    const DistanceResult result =
        pairs_[candidate.pair].query.distance(parts_[pair.moved].X_WP, parts_[pair.environment].X_WP, left);
    if (result.beyond_limit) continue;
    best = PairDistance{candidate.pair, result};
    // Far away only what is nearer by more than the tolerance is worth looking for.
    left.limit = result.distance <= demand.exact_within
                     ? result.distance
                     : std::max(demand.exact_within, result.distance / (1.0 + demand.tolerance));
    if (result.colliding) break;
  }
  return best;
}

void Scene::pairsWithin(double margin, std::vector<PairDistance>& found) {
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  for (const Candidate& candidate : candidatesWithin(margin)) {
    const DistanceResult result = query(candidate.pair, margin);
    if (!result.beyond_limit) found.push_back({candidate.pair, result});
  }
  std::sort(found.begin() + before, found.end(),
            [](const PairDistance& a, const PairDistance& b) { return a.result.distance < b.result.distance; });
}

bool Scene::collides() {
  for (const Candidate& candidate : candidatesWithin(kTouchingDistance)) {
    Pair& pair = pairs_[candidate.pair];
    if (pair.query.collides(parts_[pair.moved].X_WP, parts_[pair.environment].X_WP)) return true;
  }
  return false;
}

SceneStop Scene::stopOnce(double clearance, double until) {
  SceneStop stop;
  stop.s = until;
  for (const Candidate& candidate : candidates_) {
    Pair& pair = pairs_[candidate.pair];
    const PartMotion &a = *motions_[pair.moved], &b = *motions_[pair.environment];
    const double reach = (a.path_bound + b.path_bound) * stop.s;
    if (reach == 0.0 || candidate.lower_bound > reach + std::max(clearance, kLeastClearance)) continue;
    const MotionStop pair_stop = collision::advance(pair.query, a, b, {clearance, stop.s});
    stop.began_colliding |= pair_stop.began_colliding;
    if (!pair_stop.stopped || pair_stop.s >= stop.s) continue;
    stop.s = pair_stop.s;
    stop.stopped = true;
    stop.pair = candidate.pair;
    stop.nearest = pair_stop.nearest;
  }
  return stop;
}

void Scene::prepareMotion(std::span<const MovedPart> moved, double clearance) {
  standing_.resize(parts_.size());
  motions_.resize(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    standing_[i] = standingStill(parts_[i].X_WP);
    motions_[i] = &standing_[i];
  }
  // The lower bounds are of the beginning, wherever the scene has its parts now.
  double reach = 0.0;
  for (const MovedPart& part : moved) {
    motions_[part.part] = &part.motion;
    place(parts_[part.part], part.motion.at(0.0));
    reach = std::max(reach, part.motion.path_bound);
  }
  candidatesWithin(2.0 * reach + std::max(clearance, kLeastClearance) + kTouchingDistance);
  for (const MovedPart& part : moved) place(parts_[part.part], standing_[part.part].X_WStart);
}

SceneStop Scene::advance(std::span<const MovedPart> moved, double clearance) {
  prepareMotion(moved, clearance);
  SceneStop stop = stopOnce(clearance, 1.0);
  // Passes by which pairs go back that a stop found later has moved past. Then the motion is given up. Half: in crowds
  // it stops more often; twice: longer before.
  constexpr int kMostPasses = 4;
  for (int pass = 0; stop.stopped && pass < kMostPasses; ++pass) {
    SceneStop again = stopOnce(clearance, stop.s);
    if (!again.stopped) return stop;
    again.began_colliding = stop.began_colliding;
    stop = again;
  }
  if (stop.stopped) stop.s = 0.0;
  return stop;
}

}  // namespace hapticell::collision
