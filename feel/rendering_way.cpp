// SPDX-License-Identifier: Apache-2.0
#include "feel/rendering_way.h"

#include <cmath>
#include <numbers>

#include "haptic/rendering/proxy_rows.h"

namespace hapticell::feel {

using haptic::ConstraintSet;
using haptic::RenderResult;
using haptic::SolverRow;

namespace {

// Hz, as of the stiff couplings of the renderer that it is compared with (kQuickFilter). Half: its damper lags and its
// energy is worse; twice: encoder steps tremble in its force.
constexpr double kFilterFrequency = 100.0;

double violation(const SolverRow& row) {
  return row.equality ? std::abs(row.slack) : -row.slack;
}

}  // namespace

void ClassicWay::reset(const Pose& X_DS) {
  has_plane_ = false;
  X_DS_ = X_DS;
  v_DS_ = dvec3(0.0);
}

ConstraintSet ClassicWay::sent(const ConstraintSet& exact) const {
  ConstraintSet plane;
  plane.sequence = exact.sequence;
  plane.X_DR = exact.X_DR;
  plane.zone_radius = 1e3;
  haptic::GroupedSet grouped;
  grouped.take(exact);
  haptic::ProxyRows rows;
  rows.gather(grouped, exact.X_DR);
  const std::size_t count = rows.row.count;
  std::size_t nearest = count;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (nearest == count || violation(rows.row.at(i)) > violation(rows.row.at(nearest))) nearest = i;
  }
  if (nearest == count) return plane;
  const SolverRow row = rows.row.at(nearest);
  haptic::Constraint& entry = plane.constraints[0];
  entry.kind = row.equality ? haptic::ConstraintKind::kEquality : haptic::ConstraintKind::kInequality;
  entry.gap = row.slack;
  entry.gradient = row.normal;
  for (std::size_t i = 3; i < 6; ++i) entry.gradient[i] *= haptic::kRotationLever;
  plane.count = 1;
  return plane;
}

void ClassicWay::offer(const ConstraintSet& set, double) {
  plane_ = set;
  has_plane_ = set.count > 0;
}

RenderResult ClassicWay::tick(const Pose& X_DS, double dt) {
  const double gain = 1.0 - std::exp(-2.0 * std::numbers::pi * kFilterFrequency * dt);
  v_DS_ += gain * ((X_DS.p - X_DS_.p) / dt - v_DS_);
  X_DS_ = X_DS;
  RenderResult result;
  result.X_DP = X_DS;
  result.v_DS = v_DS_;
  result.stiffness = options_.stiffness;
  if (!has_plane_) return result;
  const haptic::Constraint& entry = plane_.constraints[0];
  const Twist motion = difference(X_DS, plane_.X_DR);
  const haptic::Vector6 xi{motion.linear.x,  motion.linear.y,  motion.linear.z,
                           motion.angular.x, motion.angular.y, motion.angular.z};
  const double value = haptic::evaluate(entry, xi);
  const bool equality = entry.kind == haptic::ConstraintKind::kEquality;
  const dvec3 normal(entry.gradient[0], entry.gradient[1], entry.gradient[2]);
  const double length = glm::length(normal);
  if ((!equality && value >= 0.0) || length < 1e-6) return result;
  const dvec3 unit = normal / length;
  result.X_DP.p -= (value / length) * unit;
  result.contact = true;
  result.active_rows = 1;
  result.spring_D = options_.stiffness * (result.X_DP.p - X_DS.p);
  result.force_D = result.spring_D - options_.damping * glm::dot(v_DS_, unit) * unit;
  if (glm::dot(result.force_D, result.spring_D) < 0.0) result.force_D = dvec3(0.0);
  if (options_.peak_torque > 0.0) {
    const dvec3 lever(entry.gradient[3], entry.gradient[4], entry.gradient[5]);
    result.torque_D = glm::dot(result.force_D, unit) / length * lever;
    result.spring_torque_D = glm::dot(result.spring_D, unit) / length * lever;
  }
  return result;
}

}  // namespace hapticell::feel
