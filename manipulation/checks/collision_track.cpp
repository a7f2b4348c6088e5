// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/collision_track.h"

#include <algorithm>
#include <utility>

namespace hapticell::manipulation {

MeetingBodies::MeetingBodies(const HeldEntity& of) : held(of), pairs(of.motion().pairs()) {
  for (MotionPair& pair : pairs) pair.blocks = true;
}

FreeMotion MeetingBodies::motionOf(std::vector<MotionPair> some) const {
  return {held.motion().parts(), held.motion().obstacles(), std::move(some)};
}

std::string MeetingBodies::first(std::uint32_t pair) const {
  return held.nameOf(*held.movedParts()[pairs[pair].part].part);
}

std::string MeetingBodies::second(std::uint32_t pair) const {
  const int other = pairs[pair].other_part;
  return held.nameOf(other < 0 ? *held.obstacleParts()[pairs[pair].obstacle]
                               : *held.movedParts()[static_cast<std::size_t>(other)].part);
}

CollisionTrack::CollisionTrack(const MeetingBodies& bodies, const Manipulator& manipulator, double look)
    : bodies_(bodies),
      manipulator_(manipulator),
      look_(look),
      motion_(bodies.motionOf(bodies.pairs)),
      open_(bodies.pairs.size()) {}

void CollisionTrack::start(const EntityConfiguration& at, double t, PathCheckResult& result) {
  motion_.reset(manipulator_, at);
  for (std::uint32_t i = 0; i < open_.size(); ++i) {
    if (!motion_.isSoft(i)) continue;
    open_[i] = finding(i, t);
    at_start_.push_back(i);
  }
  look(t, result);
}

void CollisionTrack::step(const EntityConfiguration& from, const EntityConfiguration& to, double t0, double t1,
                          PathCheckResult& result) {
  const MotionAnswer answer = motion_.advance(manipulator_, from, to);
  if (answer.blocked) {
    note(answer, answer.pair, t0, t1);
    noteOthers(from, to, answer.pair, t0, t1);
    motion_.reset(manipulator_, to);
  }
  for (std::uint32_t i = 0; i < open_.size(); ++i) {
    if (!open_[i]) continue;
    open_[i]->t_out = t1;
    if (!motion_.isSoft(i)) close(i, result);
  }
  look(t1, result);
}

void CollisionTrack::finish(PathCheckResult& result) {
  for (std::uint32_t i = 0; i < open_.size(); ++i) {
    if (open_[i]) close(i, result);
  }
}

PathFinding CollisionTrack::finding(std::uint32_t pair, double t) const {
  PathFinding found;
  found.t_in = found.t_out = t;
  found.first = bodies_.first(pair);
  found.second = bodies_.second(pair);
  return found;
}

void CollisionTrack::note(const MotionAnswer& answer, std::uint32_t pair, double t0, double t1) {
  if (open_[pair]) return;
  open_[pair] = finding(pair, t0 + answer.s * (t1 - t0));
  open_[pair]->p_W = 0.5 * (answer.contact.p_WA + answer.contact.p_WB);
}

/// A motion ends at the first pair that blocks; the others are tried without it.
void CollisionTrack::noteOthers(const EntityConfiguration& from, const EntityConfiguration& to, std::uint32_t first,
                                double t0, double t1) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < open_.size(); ++i) {
    if (i != first && !open_[i]) left.push_back(i);
  }
  while (!left.empty()) {
    std::vector<MotionPair> pairs;
    for (const std::uint32_t i : left) pairs.push_back(bodies_.pairs[i]);
    FreeMotion others = bodies_.motionOf(std::move(pairs));
    others.reset(manipulator_, from);
    const MotionAnswer answer = others.advance(manipulator_, from, to);
    if (!answer.blocked) return;
    note(answer, left[answer.pair], t0, t1);
    left.erase(left.begin() + answer.pair);
  }
}

void CollisionTrack::close(std::uint32_t pair, PathCheckResult& result) {
  const auto first = std::find(at_start_.begin(), at_start_.end(), pair);
  if (first != at_start_.end()) {
    result.touching_at_start.push_back(*open_[pair]);
    at_start_.erase(first);
  } else {
    result.findings.push_back(*open_[pair]);
  }
  open_[pair].reset();
}

void CollisionTrack::look(double t, PathCheckResult& result) {
  motion_.distances(std::min(result.least_clearance, look_), near_);
  for (const auto& one : near_) {
    const bool own = bodies_.pairs[one.pair].other_part >= 0;  // Links of one arm are always near each other.
    if (own || open_[one.pair] || one.result.distance >= result.least_clearance) continue;
    result.least_clearance = one.result.distance;
    result.nearest_first = bodies_.first(one.pair);
    result.nearest_second = bodies_.second(one.pair);
    result.t_nearest = t;
  }
}

}  // namespace hapticell::manipulation
