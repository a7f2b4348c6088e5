// SPDX-License-Identifier: Apache-2.0
// Scene::advance().
#include <algorithm>
#include <cmath>

#include "collision/queries/scene.h"

namespace hapticell::collision {

namespace {

/// Strides by the bounds alone before a motion's meshes are looked at. Half: more meshes; twice: more bounds where the
/// meshes have to be looked at anyway.
constexpr int kMostStrides = 4;
/// Of the motion: shorter strides do not lead to its end. Half: more strides; twice: more meshes.
constexpr double kLeastStride = 0.1;

}  // namespace

/// Around all places of the part on its way. A point on the way is no farther from its nearer end than half the way's
/// length, nor from the line between both ends than the way bends.
geometry::Bounds Scene::sweptBox(const Swept& swept, const MeshCollider& collider) {
  geometry::Bounds box = swept.begin.box_W();
  const PartMotion& motion = *swept.motion;
  if (motion.path_bound == 0.0) return box;
  box.add(placedBounds(collider, motion.at(1.0)).box_W());
  const double beside = std::min(0.5 * motion.path_bound, motion.bend_bound / 8.0);
  return {box.min - beside, box.max + beside};
}

void Scene::addMotionPair(const Swept& swept, PartIndex other, double clearance) {
  const PairIndex index = pairs_.find(swept.part, other);
  if (index == ScenePairs::kNone || parts_[other].empty) return;
  ScenePairs::Pair& pair = pairs_[index];
  if (!pair.enabled || pair.seen == pass_) return;
  pair.seen = pass_;
  const std::uint32_t listed = swept_of_[other];
  const Swept* met = listed == 0 ? nullptr : &swept_[listed - 1];
  const PlacedBounds& at = met == nullptr ? parts_[other].at : met->begin;
  const double reach = swept.motion->path_bound + (met == nullptr ? 0.0 : met->motion->path_bound) + clearance;
  if (reach == clearance) return;
  double bound = sphereGap(swept.begin, at);
  if (bound > reach) return;
  bound = std::max(bound, boxGap(swept.begin, at));
  if (bound <= reach) candidates_.push_back({bound, index});
}

void Scene::prepareMotion(std::span<const MovedPart> moved, double clearance) {
  ++pass_;
  swept_.clear();
  candidates_.clear();
  for (const MovedPart& part : moved) {
    if (parts_[part.part].empty) continue;
    // The bounds are of the beginning, wherever the scene has its parts now.
    swept_.push_back({part.part, &part.motion, placedBounds(*parts_[part.part].collider, part.motion.at(0.0))});
    swept_of_[part.part] = static_cast<std::uint32_t>(swept_.size());
  }
  for (const Swept& swept : swept_) {
    tree_.visitNear(sweptBox(swept, *parts_[swept.part].collider), clearance, [&](PartIndex other) {
      if (swept_of_[other] == 0) addMotionPair(swept, other, clearance);
    });
    for (const Swept& other : swept_) {
      if (other.part != swept.part) addMotionPair(swept, other.part, clearance);
    }
    if (!pairs_.isSought(swept.part)) continue;
    for (const PartIndex other : pairs_.seekers()) {  // Those that the tree does not hold.
      if (swept_of_[other] == 0 && !pairs_.isSought(other)) addMotionPair(swept, other, clearance);
    }
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.lower_bound != b.lower_bound ? a.lower_bound < b.lower_bound : a.pair < b.pair;
  });
}

/// Conservative advancement by spheres and root boxes: whether these alone keep the two apart to the end.
bool Scene::boundsStayApart(const PairMotion& motion, double gap, const MotionDemand& demand) const {
  const double rate = motion.a->path_bound + motion.b->path_bound;
  double s = 0.0;
  for (int stride = 0; stride < kMostStrides; ++stride) {
    const double step = (gap - demand.clearance - kRounding) / rate;
    if (step < kLeastStride * demand.until) return false;
    s += step;
    if (s >= demand.until) return true;
    const PlacedBounds a = placedBounds(*motion.collider_a, motion.a->at(s));
    const PlacedBounds b = placedBounds(*motion.collider_b, motion.b->at(s));
    gap = std::max(sphereGap(a, b), boxGap(a, b));
  }
  return false;
}

SceneStop Scene::stopOnce(double clearance, double until) {
  SceneStop stop;
  stop.s = until;
  for (const Candidate& candidate : candidates_) {
    ScenePairs::Pair& pair = pairs_[candidate.pair];
    const Part &moved = parts_[pair.moved], &environment = parts_[pair.environment];
    const PartMotion standing_a = standingStill(moved.X_WP), standing_b = standingStill(environment.X_WP);
    const auto motionOf = [&](PartIndex part, const PartMotion& standing) {
      return swept_of_[part] == 0 ? &standing : swept_[swept_of_[part] - 1].motion;
    };
    const PairMotion motion{motionOf(pair.moved, standing_a), motionOf(pair.environment, standing_b),
                            moved.collider.get(), environment.collider.get()};
    const double least = std::max(clearance, kLeastClearance);
    const double reach = (motion.a->path_bound + motion.b->path_bound) * stop.s;
    if (reach == 0.0 || candidate.lower_bound > reach + least) continue;
    if (boundsStayApart(motion, candidate.lower_bound, {least, stop.s})) continue;
    const MotionStop pair_stop = collision::advance(queryOf(pair), *motion.a, *motion.b, {clearance, stop.s});
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
  for (const Swept& swept : swept_) swept_of_[swept.part] = 0;
  return stop;
}

}  // namespace hapticell::collision
