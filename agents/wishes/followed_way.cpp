// SPDX-License-Identifier: Apache-2.0
#include "agents/wishes/followed_way.h"

#include <algorithm>
#include <cmath>

#include "agents/body/follow.h"

namespace hapticell::agents {

namespace {

/// rad or m of the worst joint within which a stop is reached. Half: stops at corners; twice: corners are cut, which the
/// exact distances then bend.
constexpr double kJointReached = 0.02;
/// m, and a radian counting kWayLever m, within which a frame is reached. Half: stops at corners; twice: cuts them.
constexpr double kFrameReached = 0.025, kWayLever = 0.25;
/// 1/s: the last stretch before a stop takes this share of the way a second; corners of frames are passed at full speed,
/// because other agents hold back who slows down. Half: slower at the end; twice: overshoots.
constexpr double kStopApproach = 5.0, kCornerApproach = 25.0;

double wayBetween(const FollowedWay::Stop& a, const FollowedWay::Stop& b) {
  if (a.joints.empty()) return glm::length(a.X_WM.p - b.X_WM.p);
  double sum = 0.0;
  for (std::size_t v = 0; v < a.joints.size(); ++v) sum += std::abs(a.joints[v] - b.joints[v]);
  return sum;
}

}  // namespace

double FollowedWay::distanceTo(const Stop& stop, const MovedBody& body) const {
  if (stop.joints.empty()) {
    const Twist way = difference(stop.X_WM, body.handle());
    return glm::length(way.linear) + (with_turn_ ? kWayLever * glm::length(way.angular) : 0.0);
  }
  double most = 0.0;
  for (std::size_t v = 0; v < stop.joints.size(); ++v) {
    if (body.speed(v) > 0.0) most = std::max(most, std::abs(stop.joints[v] - body.configuration().joints[v]));
  }
  return most;
}

double FollowedWay::remaining(const MovedBody& body) const {
  if (isDone()) return 0.0;
  double sum = stops_[next_].joints.empty()
                   ? distanceTo(stops_[next_], body)
                   : wayBetween(stops_[next_], {body.handle(), body.configuration().joints});
  for (std::size_t i = next_ + 1; i < stops_.size(); ++i) sum += wayBetween(stops_[i - 1], stops_[i]);
  return sum;
}

void FollowedWay::update(const MovedBody& body) {
  while (!isDone()) {
    const Stop& stop = stops_[next_];
    if (distanceTo(stop, body) > (stop.joints.empty() ? kFrameReached : kJointReached)) return;
    ++next_;
  }
}

std::vector<double> FollowedWay::velocities(const MovedBody& body, double speed, double turn_speed) const {
  const Stop& stop = stops_[next_];
  if (stop.joints.empty()) {
    const Twist way = difference(stop.X_WM, body.handle());
    PointWish wish{body.handleLink(), body.handle().p, {}, with_turn_};
    const double length = glm::length(way.linear), turn = glm::length(way.angular);
    const double most = next_ + 1 < stops_.size() ? kCornerApproach : kStopApproach;
    if (length > 1e-9) wish.velocity.linear = std::min(most, speed / length) * way.linear;
    if (with_turn_ && turn > 1e-9) wish.velocity.angular = std::min(most, turn_speed / turn) * way.angular;
    return follow(body, wish);
  }
  // Straight in joint space, as it was planned; the slowest joint decides.
  std::vector<double> v(body.size(), 0.0);
  double share = kStopApproach;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (body.speed(i) <= 0.0) continue;
    v[i] = stop.joints[i] - body.configuration().joints[i];
    if (std::abs(v[i]) > 1e-9) share = std::min(share, body.speed(i) / std::abs(v[i]));
  }
  for (double& one : v) one *= share;
  return v;
}

}  // namespace hapticell::agents
