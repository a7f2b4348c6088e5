// SPDX-License-Identifier: Apache-2.0
#include "manipulation/free_motion.h"

#include <algorithm>
#include <cmath>

#include "geometry/assertion.h"

namespace hapticell::manipulation {

namespace {

constexpr double kLeastLook = 0.05;      ///< Metres that a query looks ahead at least, so that far pairs rest for long.
constexpr double kLeastProgress = 2e-7;  ///< Metres: less room than this is a contact.
constexpr int kMaxSteps = 60;

}  // namespace

FreeMotion::FreeMotion(std::vector<std::shared_ptr<const collision::MeshCollider>> parts,
                       std::vector<Obstacle> obstacles, std::vector<MotionPair> pairs)
    : parts_(std::move(parts)), obstacles_(std::move(obstacles)), pairs_(std::move(pairs)) {
  states_.reserve(pairs_.size());
  for (const MotionPair& pair : pairs_) {
    HAPTICELL_DEMAND(pair.part < parts_.size() && pair.obstacle < obstacles_.size());
    states_.push_back({collision::ProximityQuery(parts_[pair.part], obstacles_[pair.obstacle].collider), 0.0, false});
  }
  for (const auto& part : parts_) spheres_.push_back({part->center(), part->radius()});
  X_WP_.resize(parts_.size());
  X_WP_at_s_.resize(parts_.size());
  bounds_.resize(parts_.size());
  reached_.resize(pairs_.size());
}

collision::DistanceResult FreeMotion::measure(std::uint32_t pair, const Pose& X_WP, double limit) {
  return states_[pair].query.distance(X_WP, obstacles_[pairs_[pair].obstacle].X_WO, limit);
}

void FreeMotion::reset(const Manipulator& manipulator, const EntityConfiguration& at) {
  manipulator.partPoses(at, X_WP_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], kLeastLook);
    states_[i].clearance = found.distance;
    states_[i].soft = found.distance <= kStandOff + kLeastProgress;
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

bool FreeMotion::advancePair(const Motion& motion, std::uint32_t pair, MotionAnswer& answer) {
  const double bound = bounds_[pairs_[pair].part];
  PairState& state = states_[pair];
  double s = 0.0;
  reached_[pair] = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    if (state.clearance - kStandOff > (answer.s - s) * bound) return true;
    const double look = std::max(kLeastLook, 2.0 * bound);
    const collision::DistanceResult found = measure(pair, partPoseAt(motion, pairs_[pair].part, s), look);
    state.clearance = found.distance;
    reached_[pair] = s;
    const double room = found.distance - kStandOff;
    if (room > (answer.s - s) * bound) return true;
    if (room < kLeastProgress || step + 1 == kMaxSteps) {
      answer.s = s;
      answer.blocked = true;
      answer.pair = pair;
      answer.contact = found;
      return false;
    }
    s += room / bound;
    state.clearance = kStandOff;
    reached_[pair] = s;
  }
  return true;
}

MotionAnswer FreeMotion::advance(const Manipulator& manipulator, const EntityConfiguration& from,
                                 const EntityConfiguration& to) {
  const Motion motion{manipulator, from, to};
  MotionAnswer answer;
  scratch_s_ = -1.0;
  manipulator.pathBounds(from, to, spheres_, bounds_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    reached_[i] = 0.0;
    if (pairs_[i].blocks && !states_[i].soft) advancePair(motion, i, answer);
  }
  manipulator.partPoses(manipulator.between(from, to, answer.s), X_WP_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    PairState& state = states_[i];
    state.clearance -= std::abs(answer.s - reached_[i]) * bounds_[pairs_[i].part];
    if (!state.soft || !pairs_[i].blocks) continue;
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], kLeastLook);
    state.clearance = found.distance;
    state.soft = found.distance <= kStandOff + kLeastProgress;
  }
  return answer;
}

void FreeMotion::distances(double limit, std::vector<PairDistance>& near) {
  near.clear();
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (states_[i].clearance >= limit) continue;
    const collision::DistanceResult found = measure(i, X_WP_[pairs_[i].part], std::max(limit, kLeastLook));
    states_[i].clearance = found.distance;
    if (!found.beyond_limit && found.distance < limit) near.push_back({i, found});
  }
}

}  // namespace hapticell::manipulation
