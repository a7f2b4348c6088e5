// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/robot_base_manipulator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/model/jog.h"
#include "manipulation/manipulators/robot_differential.h"
#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

/// m and rad: the tool stands where it stood, above what inverse models leave. Half: good answers may be refused;
/// twice: it may creep by 2 um a step.
constexpr double kKept = 1e-6;
/// Of the way of the base to where the tool can just be kept: 1/65,536 of it. Half: it stops up to 1/256 short; twice:
/// below rounding.
constexpr int kBisections = 16;
/// m and rad of the base, so large because the tool is kept to 1e-6 only (kKept): 0.2 % of velocities at worst. Half:
/// noise four times in curvatures; twice: four times the error.
constexpr double kDifference = 5e-4;

Twist along(std::size_t i, double amount) {
  Twist twist;
  (i < 3 ? twist.linear : twist.angular)[static_cast<int>(i % 3)] = amount;
  return twist;
}

Twist times(const Twist& twist, double factor) {
  return {factor * twist.linear, factor * twist.angular};
}

Twist plus(const Twist& a, const Twist& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}

}  // namespace

RobotBaseManipulator::RobotBaseManipulator(std::shared_ptr<const kinematics::RobotModel> model,
                                           const RobotManipulator::Tool& tool,
                                           std::unique_ptr<const kinematics::InverseModel> inverse,
                                           std::vector<RobotManipulator::Part> parts, const EntityConfiguration& taken)
    : model_(model),
      tool_(tool),
      arm_(model, tool, std::move(inverse), parts),
      parts_(parts.size()),
      X_WT_(arm_.movedFrame(taken)) {}

bool RobotBaseManipulator::follow(const EntityConfiguration& from, const Pose& X_WE, double duration_s,
                                  EntityConfiguration& to) const {
  to = arm_.propose({X_WE, from.joints}, X_WT_, duration_s);
  const Twist off = difference(arm_.movedFrame(to), X_WT_);
  return glm::length(off.linear) < kKept && glm::length(off.angular) < kKept;
}

EntityConfiguration RobotBaseManipulator::propose(const EntityConfiguration& from, const Pose& X_WM,
                                                  double duration_s) const {
  EntityConfiguration to;
  if (follow(from, X_WM, duration_s, to)) return to;
  EntityConfiguration best = from;
  double kept = 0.0, lost = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double s = 0.5 * (kept + lost);
    const bool follows = follow(from, interpolate(from.X_WE, X_WM, s), duration_s, to);
    (follows ? kept : lost) = s;
    if (follows) best = to;
  }
  return best;
}

MotionTime RobotBaseManipulator::leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const {
  return arm_.leastTime(from, to);
}

EntityConfiguration RobotBaseManipulator::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                                  double s) const {
  EntityConfiguration at = arm_.between(from, to, s);
  at.X_WE = s >= 1.0 ? to.X_WE : interpolate(from.X_WE, to.X_WE, s);
  return at;
}

void RobotBaseManipulator::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  arm_.partPoses(configuration, X_WP);
}

Pose RobotBaseManipulator::partPose(const EntityConfiguration& configuration, std::size_t part) const {
  return arm_.partPose(configuration, part);
}

void RobotBaseManipulator::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                      std::span<const PartSphere> spheres, std::span<double> bounds) const {
  arm_.pathBounds(from, to, spheres, bounds);
  // The base carries everything besides; a part is never further from it than now by more than it moves itself.
  const Twist base = difference(to.X_WE, from.X_WE);
  std::vector<Pose> X_WP(parts_);
  arm_.partPoses(from, X_WP);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const double lever = glm::length(X_WP[k] * spheres[k].p_PS - from.X_WE.p) + spheres[k].radius + bounds[k];
    bounds[k] += glm::length(base.linear) + glm::length(base.angular) * lever;
  }
}

double RobotBaseManipulator::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  return arm_.turnBound(from, to) + glm::length(difference(to.X_WE, from.X_WE).angular);
}

std::vector<PartDifferential> RobotBaseManipulator::differentiate(const EntityConfiguration& configuration) const {
  std::vector<Pose> X_W0(parts_), X_W(parts_);
  arm_.partPoses(configuration, X_W0);
  EntityConfiguration to;
  // How all parts stand after the base has moved by a little.
  const auto moved = [&](const Twist& xi, std::vector<Twist>& parts) {
    follow(configuration, displaced(configuration.X_WE, xi), kinematics::kUnboundedDuration, to);
    arm_.partPoses(to, X_W);
    parts.resize(parts_);
    for (std::size_t k = 0; k < parts_; ++k) parts[k] = difference(X_W[k], X_W0[k]);
  };
  std::array<std::vector<Twist>, 6> ahead, back;
  for (std::size_t i = 0; i < 6; ++i) {
    moved(along(i, kDifference), ahead[i]);
    moved(along(i, -kDifference), back[i]);
  }
  std::vector<PartDifferential> result(parts_);
  for (std::size_t k = 0; k < parts_; ++k) {
    result[k].p_WPo = X_W0[k].p;
    for (std::size_t i = 0; i < 6; ++i) {
      result[k].velocity[i] = times(plus(ahead[i][k], times(back[i][k], -1.0)), 0.5 / kDifference);
      result[k].acceleration[packedIndex(i, i)] =
          times(plus(ahead[i][k], back[i][k]), 1.0 / (kDifference * kDifference));
    }
  }
  std::vector<Twist> both, against;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i + 1; j < 6; ++j) {
      moved(plus(along(i, kDifference), along(j, kDifference)), both);
      moved(plus(along(i, kDifference), along(j, -kDifference)), against);
      for (std::size_t k = 0; k < parts_; ++k) {
        // f(h, h) - f(h, -h) = 2 h f_j + 2 h^2 f_ij, to third order.
        const Twist mixed =
            plus(plus(both[k], times(against[k], -1.0)), times(result[k].velocity[j], -2.0 * kDifference));
        result[k].acceleration[packedIndex(i, j)] = times(mixed, 0.5 / (kDifference * kDifference));
      }
    }
  }
  return result;
}

std::vector<MotionLimit> RobotBaseManipulator::limits(const EntityConfiguration& configuration, double zone,
                                                      double lever) const {
  const RobotDifferential arm =
      differentiateRobot(*model_, configuration.joints, configuration.X_WE, tool_.tip_link, tool_.X_LT);
  // While the base moves by xi the tool goes the other way in it.
  const dvec3 lever_W = X_WT_.p - configuration.X_WE.p;
  std::array<std::vector<double>, 6> slope;
  for (std::size_t i = 0; i < 6; ++i) {
    const Twist base = along(i, 1.0);
    const dvec3 linear = -(base.linear + glm::cross(base.angular, lever_W)), angular = -base.angular;
    for (const auto& joint : arm.joint_velocity) {
      slope[i].push_back(joint[0] * linear.x + joint[1] * linear.y + joint[2] * linear.z + joint[3] * angular.x +
                         joint[4] * angular.y + joint[5] * angular.z);
    }
  }
  std::vector<MotionLimit> limits;
  for (std::size_t v = 0; v < model_->moving.size(); ++v) {
    const kinematics::Joint& joint = model_->joints[static_cast<std::size_t>(model_->moving[v])];
    double steep = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      const double part = i < 3 ? slope[i][v] : slope[i][v] / lever;
      steep += part * part;
    }
    steep = std::sqrt(steep);
    for (const bool upper : {false, true}) {
      const double left = upper ? joint.upper - configuration.joints[v] : configuration.joints[v] - joint.lower;
      if (steep < 1e-9 || !(left / steep < zone)) continue;
      MotionLimit limit;
      limit.joint = model_->moving[v];
      limit.text = kinematics::limitText(joint, std::max(0.0, left), upper);
      limit.constraint_W.id = 2 * v + (upper ? 1 : 0);
      limit.constraint_W.gap = left / steep;
      for (std::size_t i = 0; i < 6; ++i) limit.constraint_W.gradient[i] = (upper ? -1.0 : 1.0) * slope[i][v] / steep;
      limits.push_back(std::move(limit));
    }
  }
  return limits;
}

}  // namespace hapticell::manipulation
