// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_track.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "manipulation/manipulators/arm_configuration.h"

namespace hapticell::manipulation {

namespace {

/// m that a radian counts like, for the distance to singular positions: lever_m of the inverse models. Half: rotations
/// count half as much; twice: twice, so wrists are reported sooner.
constexpr double kLever = 0.25;
/// rad or m beyond a limit that are rounding of a file. Half: a file of six digits may have findings; twice: 2 um or 2
/// urad are let pass.
constexpr double kJointTolerance = 1e-6;

std::string namesOfChange(int bits) {
  std::string names;
  for (const auto& [bit, name] : {std::pair(1, "front or back"), std::pair(2, "elbow"), std::pair(4, "wrist")}) {
    if ((bits & bit) != 0) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

}  // namespace

JointTrack::JointTrack(const workcell::Entity& entity) : model_(*entity.robot()), arm_(sixAxisChain(entity)) {
  tip_ = model_.findLink(entity.jointed().tip_link);
  if (tip_ < 0) tip_ = model_.defaultTip();
  variables_ = tip_ >= 0 ? kinematics::variablesOfChain(model_, tip_) : std::vector<int>{};
}

void JointTrack::look(const EntityConfiguration& at, const EntityConfiguration* before, double t, double dt,
                      FindingList& list) {
  const auto distances = kinematics::limitDistances(model_, at.joints);
  for (std::size_t v = 0; v < model_.dof(); ++v) {
    const kinematics::Joint& joint = model_.joints[static_cast<std::size_t>(model_.moving[v])];
    const double beyond = -std::min(distances[v].to_lower, distances[v].to_upper);
    if (beyond > kJointTolerance) list.add(PathFinding::Kind::kJointLimit, joint.name, t, beyond);
    if (before == nullptr || joint.velocity <= 0.0) continue;
    const double speed = std::abs(at.joints[v] - before->joints[v]) / dt;
    if (speed > joint.velocity * (1.0 + 1e-3)) {
      list.add(PathFinding::Kind::kJointSpeed, joint.name, t, speed - joint.velocity);
    }
  }
  lookAtConfiguration(at, t, list);
  if (tip_ < 0) return;
  kinematics::forwardKinematics(model_, at.joints, X_BL_);
  kinematics::geometricJacobian(model_, X_BL_, tip_, X_BL_[static_cast<std::size_t>(tip_)].p, jacobian_);
  // A robot with fewer than six joints lacks directions everywhere; that is no finding.
  if (variables_.size() >= 6 && kinematics::manipulability(jacobian_, kLever).smallest < 0.01) {
    list.add(PathFinding::Kind::kSingularity, "", t, 0.0);
  }
}

void JointTrack::lookAtConfiguration(const EntityConfiguration& at, double t, FindingList& list) {
  if (!arm_) return;
  const auto now = configurationNumber(*arm_, at.joints);
  if (now && configuration_ && *now != *configuration_) {
    list.add(PathFinding::Kind::kConfiguration, namesOfChange(*configuration_ ^ *now), t, 0.0);
  }
  if (now) configuration_ = now;
}

}  // namespace hapticell::manipulation
