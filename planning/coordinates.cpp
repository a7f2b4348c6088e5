// SPDX-License-Identifier: Apache-2.0
#include "planning/coordinates.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace hapticell::planning {

namespace {

namespace ob = ompl::base;

/// rad: range of a joint without limits, to both sides. Half: full turns are lost; twice: most samples lie far away.
constexpr double kEndlessTurn = 2.0 * std::numbers::pi;
/// rad or m by which a joint is moved to see how far it takes the parts.
constexpr double kTrialStep = 0.1;
/// m a unit of a joint at least: joints that hardly move anything still count. Half, twice: such joints turn more or
/// less freely.
constexpr double kLeastLever = 0.05;

}  // namespace

Coordinates::Coordinates(const FreeSpace& space, const SearchJob& job) : space_(space), start_(job.start) {
  if (space_.hasJoints()) {
    setJointRanges(job);
  } else {
    setBox(job);
  }
}

ob::StateSpacePtr Coordinates::makeSpace() const {
  if (space_.hasJoints()) {
    auto joints = std::make_shared<ob::RealVectorStateSpace>(static_cast<unsigned>(lever_.size()));
    ob::RealVectorBounds bounds(static_cast<unsigned>(lever_.size()));
    for (unsigned i = 0; i < lever_.size(); ++i) {
      bounds.setLow(i, lower_[i] * lever_[i]);
      bounds.setHigh(i, upper_[i] * lever_[i]);
    }
    joints->setBounds(bounds);
    return joints;
  }
  auto poses = std::make_shared<ob::SE3StateSpace>();
  ob::RealVectorBounds bounds(3);
  for (unsigned i = 0; i < 3; ++i) {
    bounds.setLow(i, box_.min[static_cast<int>(i)]);
    bounds.setHigh(i, box_.max[static_cast<int>(i)]);
  }
  poses->setBounds(bounds);
  poses->setSubspaceWeight(1, 2.0 * std::max(kLeastLever, space_.radius()));  // Its distance is half the angle.
  return poses;
}

void Coordinates::write(const EntityConfiguration& at, ob::State* state) const {
  if (space_.hasJoints()) {
    double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      values[i] = std::clamp(at.joints[i], lower_[i], upper_[i]) * lever_[i];
    }
    return;
  }
  auto* pose = state->as<ob::SE3StateSpace::StateType>();
  pose->setXYZ(at.X_WE.p.x, at.X_WE.p.y, at.X_WE.p.z);
  pose->rotation().x = at.X_WE.q.x;
  pose->rotation().y = at.X_WE.q.y;
  pose->rotation().z = at.X_WE.q.z;
  pose->rotation().w = at.X_WE.q.w;
}

EntityConfiguration Coordinates::read(const ob::State* state) const {
  EntityConfiguration at = start_;
  if (space_.hasJoints()) {
    const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (std::size_t i = 0; i < lever_.size(); ++i) at.joints[i] = values[i] / lever_[i];
    return at;
  }
  const auto* pose = state->as<ob::SE3StateSpace::StateType>();
  at.X_WE.p = {pose->getX(), pose->getY(), pose->getZ()};
  at.X_WE.q = glm::normalize(dquat(pose->rotation().w, pose->rotation().x, pose->rotation().y, pose->rotation().z));
  return at;
}

void Coordinates::sample(std::mt19937_64& random, ob::State* state) const {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  if (space_.hasJoints()) {
    double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      values[i] = (lower_[i] + unit() * (upper_[i] - lower_[i])) * lever_[i];
    }
    return;
  }
  EntityConfiguration at = start_;
  for (int i = 0; i < 3; ++i) at.X_WE.p[i] = box_.min[i] + unit() * (box_.max[i] - box_.min[i]);
  // Shoemake, "Uniform random rotations" (1992).
  const double u = unit(), turn = 2.0 * std::numbers::pi * unit(), spin = 2.0 * std::numbers::pi * unit();
  const double a = std::sqrt(1.0 - u), b = std::sqrt(u);
  at.X_WE.q = dquat(b * std::cos(spin), a * std::sin(turn), a * std::cos(turn), b * std::sin(spin));
  write(at, state);
}

double Coordinates::distance(const EntityConfiguration& a, const EntityConfiguration& b) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lever_.size(); ++i) {
    const double way = lever_[i] * (a.joints[i] - b.joints[i]);
    sum += way * way;
  }
  const Twist way = difference(a.X_WE, b.X_WE);
  return std::sqrt(sum) + glm::length(way.linear) + space_.radius() * glm::length(way.angular);
}

void Coordinates::setJointRanges(const SearchJob& job) {
  const kinematics::RobotModel& robot = *space_.entity().robot();
  for (std::size_t i = 0; i < robot.dof(); ++i) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[i])];
    lower_.push_back(std::min(start_.joints[i], std::max(joint.lower, -kEndlessTurn)));
    upper_.push_back(std::max(start_.joints[i], std::min(joint.upper, kEndlessTurn)));
    for (const EntityConfiguration& goal : job.goals) {
      lower_[i] = std::min(lower_[i], goal.joints[i]);
      upper_[i] = std::max(upper_[i], goal.joints[i]);
    }
    EntityConfiguration moved = start_;
    moved.joints[i] += kTrialStep;
    lever_.push_back(std::max(kLeastLever, space_.pathBound(start_, moved) / kTrialStep));
  }
}

void Coordinates::setBox(const SearchJob& job) {
  box_ = space_.obstacleBounds();
  box_.add(job.start.X_WE.p);
  for (const EntityConfiguration& goal : job.goals) box_.add(goal.X_WE.p);
  box_.min -= 2.0 * space_.radius();
  box_.max += 2.0 * space_.radius();
}

}  // namespace hapticell::planning
