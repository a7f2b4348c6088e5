// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/motion_path.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

namespace {

/// Value and two derivatives of a unit quaternion's curve, from those of a quaternion that is not a unit one.
struct UnitQuaternion {
  dquat value, first, second;
};

UnitQuaternion normalised(const dquat& q, const dquat& dq, const dquat& ddq) {
  const double norm = glm::length(q);
  const dquat n = q / norm;
  const double growth = glm::dot(n, dq);  // Of the norm.
  const dquat dn = (dq - n * growth) / norm;
  const double growth_2 = glm::dot(dn, dq) + glm::dot(n, ddq);
  const dquat ddn = (ddq - dn * growth - n * growth_2 - dn * growth) / norm;
  return {n, dn, ddn};
}

dvec3 imaginary(const dquat& q) {
  return {q.x, q.y, q.z};
}

void put(std::span<double> values, std::size_t at, const dvec3& v) {
  for (int k = 0; k < 3; ++k) values[at + static_cast<std::size_t>(k)] = v[k];
}

}  // namespace

std::vector<dvec3> runningTurns(const Trajectory& frames) {
  std::vector<dvec3> turns(frames.size(), dvec3(0.0));
  for (std::size_t i = 1; i < frames.size(); ++i)
    turns[i] = turns[i - 1] + rotationVector(frames[i].X_WT.q * glm::conjugate(frames[i - 1].X_WT.q));
  return turns;
}

StraightPath::StraightPath(const Trajectory& frames, double length, LimitedBy by)
    : breaks_{0.0, length}, X_WT_(frames[0].X_WT) {
  const std::size_t last = frames.size() - 1;
  way_ = (frames[last].X_WT.p - X_WT_.p) / length;
  turn_ = runningTurns(frames).back() / length;
  const auto begin = frames.joints(0), end = frames.joints(last);
  start_.assign(begin.begin(), begin.end());
  for (std::size_t j = 0; j < end.size(); ++j) change_.push_back((end[j] - begin[j]) / length);
  first_ = by == LimitedBy::kJoints ? change_ : std::vector<double>{way_.x, way_.y, way_.z, turn_.x, turn_.y, turn_.z};
}

void StraightPath::derivatives(double, std::span<double> first, std::span<double> second) const {
  std::copy(first_.begin(), first_.end(), first.begin());
  std::fill(second.begin(), second.end(), 0.0);
}

Pose StraightPath::pose(double u) const {
  return {X_WT_.p + u * way_, glm::normalize(quaternionFromRotationVector(u * turn_) * X_WT_.q)};
}

std::vector<double> StraightPath::joints(double u) const {
  std::vector<double> q = start_;
  for (std::size_t j = 0; j < q.size(); ++j) q[j] += u * change_[j];
  return q;
}

void CurvedPath::derivatives(double u, std::span<double> first, std::span<double> second) const {
  const CubicSpline& spline = spline_.spline();
  std::vector<double> value(spline.dimensions()), d(value), dd(value);
  spline.evaluate(u, 1, d);
  spline.evaluate(u, 2, dd);
  if (by_ == LimitedBy::kJoints) {
    std::copy(d.begin() + 7, d.end(), first.begin());
    std::copy(dd.begin() + 7, dd.end(), second.begin());
    return;
  }
  spline.evaluate(u, 0, value);
  const auto quaternion = [](const std::vector<double>& v) { return dquat(v[3], v[4], v[5], v[6]); };
  const UnitQuaternion q = normalised(quaternion(value), quaternion(d), quaternion(dd));
  put(first, 0, {d[0], d[1], d[2]});
  put(second, 0, {dd[0], dd[1], dd[2]});
  put(first, 3, 2.0 * imaginary(q.first * glm::conjugate(q.value)));
  put(second, 3, 2.0 * imaginary(q.second * glm::conjugate(q.value)));
}

}  // namespace hapticell::trajectory
