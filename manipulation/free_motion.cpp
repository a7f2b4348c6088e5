// SPDX-License-Identifier: Apache-2.0
#include "manipulation/free_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/assertion.h"

namespace hapticell::manipulation {

namespace {

constexpr double kLeastLook = 0.05;  ///< Metres that a query looks ahead at least, so that far pairs rest for long.

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
    states_.push_back({collision::ProximityQuery(parts_[pair.part], met), 0.0, false, dvec3(0.0)});
  }
  for (const auto& part : parts_) spheres_.push_back({part->center(), part->radius()});
  X_WP_.resize(parts_.size());
  X_WP_at_s_.resize(parts_.size());
  bounds_.resize(parts_.size());
  reached_.resize(pairs_.size());
}

collision::DistanceResult FreeMotion::measure(std::uint32_t pair, const Pose& X_WP, double limit) {
  return states_[pair].query.distance(X_WP, standingPose(pair), limit);
}

/// Where what it is checked against stands at the accepted configuration.
Pose FreeMotion::standingPose(std::uint32_t pair) const {
  const int other = pairs_[pair].other_part;
  return other < 0 ? obstacles_[pairs_[pair].obstacle].X_WO : X_WP_[static_cast<std::size_t>(other)];
}

/// How far the two may come together along the whole motion.
double FreeMotion::boundOf(std::uint32_t pair) const {
  const int other = pairs_[pair].other_part;
  return bounds_[pairs_[pair].part] + (other < 0 ? 0.0 : bounds_[static_cast<std::size_t>(other)]);
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
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], kLeastLook);
    states_[i].clearance = found.distance;
    states_[i].soft = found.distance <= collision::kLeastClearance;
    states_[i].stand_back_W = dvec3(0.0);
  }
}

void FreeMotion::moveObstacle(std::uint32_t obstacle, const Pose& X_WO) {
  const collision::MeshCollider& mesh = *obstacles_[obstacle].collider;
  const Pose before = std::exchange(obstacles_[obstacle].X_WO, X_WO);
  const Twist way = difference(X_WO, before);
  const double reach = glm::length(mesh.center()) + mesh.radius();
  const double gone = glm::length(way.linear) + reach * glm::length(way.angular);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].obstacle != obstacle) continue;
    states_[i].clearance = std::max(0.0, states_[i].clearance - gone);
  }
}

bool FreeMotion::anySoft() const {
  return std::any_of(states_.begin(), states_.end(), [](const PairState& state) { return state.soft; });
}

const Pose& FreeMotion::partPoseAt(const Motion& motion, std::uint32_t part, double s) {
  if (s != scratch_s_) {
    motion.manipulator.partPoses(motion.manipulator.between(motion.from, motion.to, s), X_WP_at_s_);
    scratch_s_ = s;
  }
  return X_WP_at_s_[part];
}

void FreeMotion::advancePair(const Motion& motion, std::uint32_t pair, MotionAnswer& answer) {
  const std::uint32_t part = pairs_[pair].part;
  const double bound = boundOf(pair);
  PairState& state = states_[pair];
  reached_[pair] = 0.0;
  if (state.clearance - kStandOff > answer.s * bound) return;
  const Pose X_WO = obstaclePose(pair);
  const double reach_of_list = state.query.near().reachAt(X_WP_[part].inverse() * X_WO);
  if (reach_of_list < kStandOff + answer.s * bound) {
    state.clearance = state.query.distance(X_WP_[part], X_WO, std::max(kLeastLook, 2.0 * bound)).distance;
    if (state.clearance - kStandOff > answer.s * bound) return;
  }

  collision::PartMotion moved;
  moved.X_WStart = X_WP_[part];
  moved.path_bound = bounds_[part];
  moved.bend_bound = 2.0 * motion.turned * bounds_[part];
  moved.along = [&](double s) { return partPoseAt(motion, part, s); };
  collision::PartMotion met = collision::standingStill(X_WO);
  if (const int other = pairs_[pair].other_part; other >= 0) {
    const auto second = static_cast<std::uint32_t>(other);
    met.path_bound = bounds_[second];
    met.bend_bound = 2.0 * motion.turned * bounds_[second];
    met.along = [&, second](double s) {
      const Pose& X_WP = partPoseAt(motion, second, s);
      return Pose{X_WP.p + state.stand_back_W, X_WP.q};
    };
  }
  const collision::MotionStop stop = collision::advance(state.query, moved, met, {kStandOff, answer.s});
  reached_[pair] = stop.s;
  state.clearance = stop.distance_at_least;
  if (!stop.stopped) return;
  answer.s = stop.s;
  answer.blocked = true;
  answer.pair = pair;
  answer.contact = stop.nearest;
  // Where the check gave up its nearest points may be missing.
  if (stop.nearest.beyond_limit || stop.nearest.colliding) {
    answer.contact = state.query.distance(partPoseAt(motion, part, stop.s), met.at(stop.s), kLeastLook);
  }
}

MotionAnswer FreeMotion::advance(const Manipulator& manipulator, const EntityConfiguration& from,
                                 const EntityConfiguration& to) {
  const Motion motion{manipulator, from, to, manipulator.turnBound(from, to)};
  MotionAnswer answer;
  scratch_s_ = -1.0;
  manipulator.pathBounds(from, to, spheres_, bounds_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    reached_[i] = 0.0;
    if (pairs_[i].blocks && (!states_[i].soft || states_[i].guarded())) advancePair(motion, i, answer);
  }
  manipulator.partPoses(manipulator.between(from, to, answer.s), X_WP_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    PairState& state = states_[i];
    state.clearance -= std::abs(answer.s - reached_[i]) * boundOf(i);
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
  for (std::uint32_t i = first; i < pairs_.size(); ++i) {
    if (states_[i].clearance >= limit && !states_[i].guarded()) continue;
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], std::max(limit, kLeastLook));
    if (!states_[i].guarded()) states_[i].clearance = found.distance;
    if (!found.beyond_limit && found.distance < limit) near.push_back({i, found});
  }
}

}  // namespace hapticell::manipulation
