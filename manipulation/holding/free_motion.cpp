// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/free_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::manipulation {

namespace {

/// m that a query looks ahead at least, so that far pairs rest: at 0.1 m/s for half a second. Half: asked twice as
/// often; twice: dearer queries.
constexpr double kLeastLook = 0.05;
/// m: what is farther away is not looked at. Half: the list of the near is made twice as often (some microseconds for
/// 1000 pairs); twice: more pairs in it.
constexpr double kFar = 0.1;

}  // namespace

FreeMotion::FreeMotion(std::vector<std::shared_ptr<const collision::MeshCollider>> parts,
                       std::vector<Obstacle> obstacles, std::vector<MotionPair> pairs)
    : parts_(std::move(parts)), obstacles_(std::move(obstacles)), pairs_(std::move(pairs)) {
  states_.reserve(pairs_.size());
  for (const MotionPair& pair : pairs_) {
    HAPTICELL_DEMAND(pair.part < parts_.size() && pair.other_part < static_cast<int>(parts_.size()));
    HAPTICELL_DEMAND(pair.other_part >= 0 || pair.obstacle < obstacles_.size());
    const auto& met =
        pair.other_part < 0 ? obstacles_[pair.obstacle].collider : parts_[static_cast<std::size_t>(pair.other_part)];
    states_.push_back({.query = collision::ProximityQuery(parts_[pair.part], met)});
  }
  for (const auto& part : parts_) spheres_.push_back({part->center(), part->radius()});
  X_WP_.resize(parts_.size());
  bounds_.resize(parts_.size());
  way_.resize(parts_.size());
  part_bounds_.resize(parts_.size());
  for (const Obstacle& obstacle : obstacles_) {
    obstacle_bounds_.push_back(collision::placedBounds(*obstacle.collider, obstacle.X_WO));
  }
  pairs_of_.resize(obstacles_.size());
  near_.reserve(pairs_.size());
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].other_part < 0) {
      pairs_of_[pairs_[i].obstacle].push_back(i);
      continue;
    }
    own_.push_back(i);
    own_parts_.push_back({pairs_[i].part, static_cast<std::uint32_t>(pairs_[i].other_part)});
  }
  own_bounds_.resize(own_.size());
}

collision::DistanceResult FreeMotion::measure(std::uint32_t pair, const Pose& X_WP, double limit) {
  return states_[pair].query.distance(X_WP, standingPose(pair), limit);
}

/// Where what it is checked against stands at the accepted configuration.
Pose FreeMotion::standingPose(std::uint32_t pair) const {
  const int other = pairs_[pair].other_part;
  return other < 0 ? obstacles_[pairs_[pair].obstacle].X_WO : X_WP_[static_cast<std::size_t>(other)];
}

/// How far the two of each near pair may come together along the whole motion.
void FreeMotion::boundPairs(const Motion& motion) {
  motion.manipulator.pathBounds(motion.from, motion.to, spheres_, bounds_);
  const double most = bounds_.empty() ? 0.0 : *std::max_element(bounds_.begin(), bounds_.end());
  if (far_clearance_ - kStandOff <= most) listNear(most + kFar);
  for (const std::uint32_t i : near_) states_[i].bound = bounds_[pairs_[i].part];
  for (std::size_t k = 0; k < own_.size(); ++k) {
    own_bounds_[k] = bounds_[own_parts_[k].part] + bounds_[own_parts_[k].other];
  }
  motion.manipulator.tightenOwnBounds(motion.from, motion.to, spheres_, own_parts_, own_bounds_);
  for (std::size_t k = 0; k < own_.size(); ++k) states_[own_[k]].bound = own_bounds_[k];
}

/// Lower bound of the distance of a pair with an obstacle, without a look at the meshes.
double FreeMotion::boundsGap(std::uint32_t pair) const {
  const collision::MeshCollider &part = *parts_[pairs_[pair].part], &met = *obstacles_[pairs_[pair].obstacle].collider;
  if (part.isEmpty() || met.isEmpty()) return std::numeric_limits<double>::infinity();
  const collision::PlacedBounds &a = part_bounds_[pairs_[pair].part], &b = obstacle_bounds_[pairs_[pair].obstacle];
  const double spheres = collision::sphereGap(a, b);
  return spheres > kFar ? spheres : std::max(spheres, collision::boxGap(a, b));
}

void FreeMotion::placeParts() {
  for (std::size_t i = 0; i < parts_.size(); ++i) part_bounds_[i] = collision::placedBounds(*parts_[i], X_WP_[i]);
}

/// Pairs of two parts, and soft ones, whatever their distance.
bool FreeMotion::isLookedAt(std::uint32_t pair) const {
  return pairs_[pair].other_part >= 0 || states_[pair].soft;
}

/// Looks at all pairs: those that may be nearer than `least` (m) are listed.
void FreeMotion::listNear(double least) {
  near_.clear();
  far_clearance_ = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    PairState& state = states_[i];
    const double way = way_[pairs_[i].part];
    if (!state.near) state.clearance -= way - state.way;
    if (!isLookedAt(i) && state.clearance < least) state.clearance = std::max(state.clearance, boundsGap(i));
    state.near = isLookedAt(i) || state.clearance < least;
    state.way = way;
    if (state.near)
      near_.push_back(i);
    else
      far_clearance_ = std::min(far_clearance_, state.clearance);
  }
}

/// Where it stands for what blocks.
Pose FreeMotion::obstaclePose(std::uint32_t pair) const {
  const Pose X_WO = standingPose(pair);
  return {X_WO.p + states_[pair].stand_back_W, X_WO.q};
}

void FreeMotion::guard(std::uint32_t pair, const dvec3& nhat_W) {
  PairState& state = states_[pair];
  if (!state.soft) return;
  state.stand_back_W = -kGuard * nhat_W;
  const collision::DistanceResult found =
      state.query.distance(X_WP_[pairs_[pair].part], obstaclePose(pair), kLeastLook);
  if (found.distance > kStandOff) {
    state.clearance = found.distance;
  } else {
    state.stand_back_W = dvec3(0.0);
  }
}

void FreeMotion::reset(const Manipulator& manipulator, const EntityConfiguration& at) {
  manipulator.partPoses(at, X_WP_);
  placeParts();
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    PairState& state = states_[i];
    const double gap = pairs_[i].other_part < 0 ? boundsGap(i) : 0.0;
    state.clearance = gap >= kLeastLook ? gap : measure(i, X_WP_[pairs_[i].part], kLeastLook).distance;
    state.soft = state.clearance <= collision::kLeastClearance;
    state.stand_back_W = dvec3(0.0);
    state.near = true;
  }
  listNear(kFar);
}

void FreeMotion::moveObstacle(std::uint32_t obstacle, const Pose& X_WO) {
  const collision::MeshCollider& mesh = *obstacles_[obstacle].collider;
  const Pose before = std::exchange(obstacles_[obstacle].X_WO, X_WO);
  const Twist way = difference(X_WO, before);
  const double reach = glm::length(mesh.center()) + mesh.radius();
  const double gone = glm::length(way.linear) + reach * glm::length(way.angular);
  obstacle_bounds_[obstacle] = collision::placedBounds(mesh, X_WO);
  for (const std::uint32_t i : pairs_of_[obstacle]) {
    PairState& state = states_[i];
    if (state.near) {
      state.clearance = std::max(0.0, state.clearance - gone);
    } else {
      state.clearance -= gone;
      far_clearance_ = std::min(far_clearance_, state.clearance - (way_[pairs_[i].part] - state.way));
    }
  }
}

bool FreeMotion::anySoft() const {
  return std::any_of(states_.begin(), states_.end(), [](const PairState& state) { return state.soft; });
}

Pose FreeMotion::partPoseAt(const Motion& motion, std::uint32_t part, double s) {
  if (s != scratch_s_) {
    at_s_ = motion.manipulator.between(motion.from, motion.to, s);
    scratch_s_ = s;
  }
  return motion.manipulator.partPose(at_s_, part);
}

void FreeMotion::advancePair(const Motion& motion, std::uint32_t pair, MotionAnswer& answer) {
  const std::uint32_t part = pairs_[pair].part;
  PairState& state = states_[pair];
  const double bound = state.bound;
  if (state.clearance - kStandOff > answer.s * bound) return;
  if (pairs_[pair].other_part < 0 && !state.soft) {
    state.clearance = std::max(state.clearance, boundsGap(pair));
    if (state.clearance - kStandOff > answer.s * bound) return;
  }
  const Pose X_WO = obstaclePose(pair), X_WP = X_WP_[part];
  const double reach_of_list = state.query.near().reachAt(X_WP.inverse() * X_WO);
  if (reach_of_list < kStandOff + answer.s * bound) {
    state.clearance = state.query.distance(X_WP, X_WO, std::max(kLeastLook, 2.0 * bound)).distance;
    if (state.clearance - kStandOff > answer.s * bound) return;
  }

  // Of two parts of the entity the one is looked at from the other: what carries both along brings them no nearer.
  const bool own = pairs_[pair].other_part >= 0;
  const auto other = static_cast<std::uint32_t>(std::max(0, pairs_[pair].other_part));
  collision::PartMotion moved, met = collision::standingStill(X_WO);
  if (own) {
    moved = collision::standingStill(X_WP);
    met.path_bound = bound;
    met.bend_bound = 2.0 * motion.turned * bound;
    met.along = [&](double s) {
      const Pose X_WQ = partPoseAt(motion, other, s);
      const Pose back = {X_WQ.p + state.stand_back_W, X_WQ.q};
      return X_WP * (partPoseAt(motion, part, s).inverse() * back);
    };
  } else {
    moved.X_WStart = X_WP;
    moved.path_bound = bound;
    moved.bend_bound = 2.0 * motion.turned * bound;
    moved.along = [&](double s) { return partPoseAt(motion, part, s); };
  }
  const collision::MotionStop stop = collision::advance(state.query, moved, met, {kStandOff, answer.s});
  state.reached = stop.s;
  state.clearance = stop.distance_at_least;
  if (!stop.stopped) return;
  answer.s = stop.s;
  answer.blocked = true;
  answer.pair = pair;
  answer.contact = stop.nearest;
  // Where the check gave up its nearest points may be missing.
  if (stop.nearest.beyond_limit || stop.nearest.colliding) {
    answer.contact = state.query.distance(moved.at(stop.s), met.at(stop.s), kLeastLook);
  }
  if (own) {
    const Pose carried = partPoseAt(motion, part, stop.s) * X_WP.inverse();
    answer.contact.p_WA = carried * answer.contact.p_WA;
    answer.contact.p_WB = carried * answer.contact.p_WB;
    answer.contact.nhat_BA_W = carried.rotate(answer.contact.nhat_BA_W);
  }
}

MotionAnswer FreeMotion::advance(const Manipulator& manipulator, const EntityConfiguration& from,
                                 const EntityConfiguration& to) {
  const Motion motion{manipulator, from, to, manipulator.turnBound(from, to)};
  MotionAnswer answer;
  scratch_s_ = -1.0;
  boundPairs(motion);
  for (const std::uint32_t i : near_) {
    states_[i].reached = 0.0;
    if (pairs_[i].blocks && (!states_[i].soft || states_[i].guarded())) advancePair(motion, i, answer);
  }
  manipulator.partPoses(manipulator.between(from, to, answer.s), X_WP_);
  placeParts();
  double most = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double step = answer.s * bounds_[i];
    most = std::max(most, step);
    if (std::isfinite(step)) way_[i] += step;  // Else nothing was far, and all is looked at anew.
  }
  far_clearance_ -= most;
  for (const std::uint32_t i : near_) {
    PairState& state = states_[i];
    state.clearance -= std::abs(answer.s - state.reached) * state.bound;
    if (!state.soft || !pairs_[i].blocks) continue;
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], kLeastLook);
    state.soft = found.distance <= collision::kLeastClearance;
    if (state.soft && state.guarded()) continue;
    state.stand_back_W = dvec3(0.0);
    state.clearance = found.distance;
  }
  return answer;
}

void FreeMotion::distances(double limit, std::uint32_t first, std::vector<PairDistance>& near) {
  near.clear();
  if (limit > far_clearance_) listNear(limit + kFar);
  for (const std::uint32_t i : near_) {
    if (i < first) continue;
    if (states_[i].clearance >= limit && !states_[i].guarded()) continue;
    if (!isLookedAt(i)) {
      states_[i].clearance = std::max(states_[i].clearance, boundsGap(i));
      if (states_[i].clearance >= limit) continue;
    }
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], std::max(limit, kLeastLook));
    if (!states_[i].guarded()) states_[i].clearance = found.distance;
    if (!found.beyond_limit && found.distance < limit) near.push_back({i, found});
  }
}

}  // namespace hapticell::manipulation
