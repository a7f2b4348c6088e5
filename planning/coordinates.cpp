// SPDX-License-Identifier: Apache-2.0
#include "planning/coordinates.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "planning/standing_figure.h"

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
/// Range of a variable that does not move: OMPL wants one. Half, twice: as well.
constexpr double kNoRange = 1e-6;
/// Share of the samples of a mannequin with its arm anywhere. Half: arms are led round things late; twice: trunks and
/// arms hardly move together.
constexpr double kFreeArms = 0.5;
/// Share of the ranges by which a sample lies beside the way from start to goal at most. Half: no bowing under things;
/// twice: most samples do not stand.
constexpr double kBeside = 0.5;

}  // namespace

Coordinates::Coordinates(const FreeSpace& space, const SearchJob& job) : space_(space), start_(job.start) {
  if (space_.figure() != nullptr) {
    setFigureRanges(job);
  } else if (space_.hasJoints()) {
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
    const std::vector<double> numbers = numbersOf(at);
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      values[i] = std::clamp(numbers[i], lower_[i], upper_[i]) * lever_[i];
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
    if (const StandingFigure* figure = space_.figure()) {
      StandingFigure::Numbers numbers{};
      for (std::size_t i = 0; i < lever_.size(); ++i) numbers[i] = values[i] / lever_[i];
      return figure->configurationOf(numbers);
    }
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
  if (space_.figure() != nullptr) {
    sampleFigure(random, state);
    return;
  }
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

/// Trunks anywhere hardly ever stand: pelvis and spine are taken from between the start and a goal, more or less far
/// beside it; the arm is anywhere, or as those.
void Coordinates::sampleFigure(std::mt19937_64& random, ob::State* state) const {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  const auto& goal = goals_[static_cast<std::size_t>(unit() * static_cast<double>(goals_.size()))];
  const double share = unit(), beside = unit(), arm = unit();
  for (std::size_t i = 0; i < lever_.size(); ++i) {
    double value = std::lerp(numbers_of_start_[i], goal[i], share);
    const double off = 2.0 * unit() - 1.0;
    if (i >= StandingFigure::kArm && arm < kFreeArms) {
      value = std::lerp(lower_[i], upper_[i], 0.5 + 0.5 * off);
    } else {
      value += kBeside * beside * beside * off * (upper_[i] - lower_[i]);
    }
    values[i] = std::clamp(value, lower_[i], upper_[i]) * lever_[i];
  }
}

std::vector<double> Coordinates::numbersOf(const EntityConfiguration& at) const {
  if (space_.figure() == nullptr) return at.joints;
  const auto numbers = space_.figure()->numbersOf(at);
  return {numbers.begin(), numbers.end()};
}

double Coordinates::distance(const EntityConfiguration& a, const EntityConfiguration& b) const {
  double sum = 0.0;
  if (!lever_.empty()) {
    const std::vector<double> of_a = numbersOf(a), of_b = numbersOf(b);
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      const double way = lever_[i] * (of_a[i] - of_b[i]);
      sum += way * way;
    }
  }
  if (space_.figure() != nullptr) return std::sqrt(sum);
  const Twist way = difference(a.X_WE, b.X_WE);
  return std::sqrt(sum) + glm::length(way.linear) + space_.radius() * glm::length(way.angular);
}

void Coordinates::setFigureRanges(const SearchJob& job) {
  const StandingFigure& figure = *space_.figure();
  numbers_of_start_ = numbersOf(start_);
  for (const EntityConfiguration& goal : job.goals) goals_.push_back(numbersOf(goal));
  for (std::size_t i = 0; i < StandingFigure::kNumbers; ++i) {
    lower_.push_back(std::min(figure.lower()[i], numbers_of_start_[i]));
    upper_.push_back(std::max(figure.upper()[i], numbers_of_start_[i]));
    for (const auto& goal : goals_) {
      lower_[i] = std::min(lower_[i], goal[i]);
      upper_[i] = std::max(upper_[i], goal[i]);
    }
    const bool stays = figure.pelvisStays() && i < StandingFigure::kPelvis;
    if (stays) upper_[i] = lower_[i] + kNoRange;
    StandingFigure::Numbers moved = figure.numbersOf(start_);
    moved[i] += kTrialStep;
    const double way = stays ? 0.0 : space_.pathBound(start_, figure.configurationOf(moved));
    lever_.push_back(std::max(kLeastLever, way / kTrialStep));
  }
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
