// SPDX-License-Identifier: Apache-2.0
// The built-in robot in the hand: its joint limit, and its forearm on a wall.
#include <cmath>
#include <utility>

#include "feel/scene.h"
#include "haptic/rendering/proxy_metric.h"
#include "kinematics/numeric/numeric_inverse.h"
#include "manipulation/holding/motion_mapping.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "workcell/import/entity_source.h"

namespace hapticell::feel {

namespace {

using manipulation::EntityConfiguration;
using manipulation::RobotManipulator;

constexpr int kForearm = 3;  // Joint that carries the forearm, counted from 1.
/// rad that the limited joint still has: some 10 mm at half a metre, so that the scene begins free. Half and twice: 5
/// and 20 mm of approach in the same 0.3 s.
constexpr double kLimitAhead = 0.02;
/// m to the wall, so that the scene begins free. Half and twice: 5 and 20 mm of approach in the same 0.3 s.
constexpr double kWallAhead = 0.01;
constexpr double kArmWay = 0.03, kWaysPerSecond = 1.667;  // m and ways per second: 0.1 m/s.

std::vector<double> restJoints() {
  return {0.0, 0.3, 0.6, 0.2, 0.7, 0.0};
}

/// A flat-looking patch felt about the middle of the workspace, and a hand that slides along it.
class RobotScene : public FeelScene {
 public:
  RobotScene(std::shared_ptr<const kinematics::RobotModel> model, const RobotManipulator::Tool& tool,
             std::unique_ptr<const kinematics::InverseModel> inverse)
      : link_(model->joints[static_cast<std::size_t>(model->moving[kForearm - 1])].child_link),
        robot_(std::move(model), tool, std::move(inverse), RobotManipulator::partsOf({link_})) {
    rest_.joints = restJoints();
    // Translation only: a wrist that may turn would turn the tool out of the way, which this device cannot tell.
    mapping_.setFilter(true, false);
    mapping_.anchor(Pose::identity(), robot_.movedFrame(rest_));
  }

  double penetration(const Pose& X_DP, double t) const override {
    const Pose X_WM = mapping_.toCell(X_DP);
    const double lag = glm::distance(robot_.movedFrame(at(X_DP)).p, X_WM.p);
    return std::max(lag, inside(X_DP, t));
  }
  dvec3 handAt(double t, double press) const override {
    return surface_ + kArmWay * triangleWave(t, kWaysPerSecond) * along_ - press * normal_;
  }
  dvec3 rest() const override { return surface_; }
  dvec3 pressDirection() const override { return -normal_; }

 protected:
  /// Finds where the hand meets the only entry of the set at rest.
  void findSurface() {
    const ConstraintSet set = setAt(Pose::identity(), 0.0);
    const haptic::Vector6& a = set.constraints[0].gradient;
    const dvec3 gradient = haptic::linearPart(a);
    normal_ = glm::normalize(gradient);
    surface_ = -set.constraints[0].gap / glm::dot(gradient, gradient) * gradient;
    const dvec3 other = std::abs(normal_.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    along_ = glm::normalize(glm::cross(normal_, other));
  }
  EntityConfiguration at(const Pose& X_DP) const { return robot_.propose(rest_, mapping_.toCell(X_DP), 10.0); }
  virtual double inside(const Pose& X_DP, double t) const = 0;

  int link_;
  RobotManipulator robot_;
  EntityConfiguration rest_;
  manipulation::MotionMapping mapping_;
  dvec3 surface_{0.0}, normal_{0, 0, 1}, along_{1, 0, 0};
};

class JointLimit final : public RobotScene {
 public:
  template <typename... Arguments>
  explicit JointLimit(Arguments&&... arguments) : RobotScene(std::forward<Arguments>(arguments)...) {
    findSurface();
  }
  std::string name() const override { return "joint limit"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    const EntityConfiguration here = at(X_DP);
    ConstraintSet set = emptySet(mapping_.toDevice(robot_.movedFrame(here), X_DP));
    std::uint32_t group = 0;
    for (const manipulation::MotionLimit& limit : robot_.limits(here, set.zone_radius, haptic::kRotationLever)) {
      Constraint c = limit.constraint_W;
      c.group = group++;
      mapping_.toDevice(c);
      add(set, c);
    }
    return set;
  }

 protected:
  double inside(const Pose&, double) const override { return 0.0; }
};

class LinkContact final : public RobotScene {
 public:
  template <typename... Arguments>
  explicit LinkContact(Arguments&&... arguments) : RobotScene(std::forward<Arguments>(arguments)...) {
    wall_ = pointOf(rest_).y + kWallAhead;
    findSurface();
  }
  std::string name() const override { return "link contact"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    const EntityConfiguration here = at(X_DP);
    ConstraintSet set = emptySet(mapping_.toDevice(robot_.movedFrame(here), X_DP));
    manipulation::PointCondition condition;
    condition.p_WQ = pointOf(here);
    condition.nhat_W = dvec3(0, -1, 0);
    condition.gap = wall_ - condition.p_WQ.y;
    Constraint c;
    manipulation::applyCondition(robot_.differentiate(here)[0], condition, c);
    mapping_.toDevice(c);
    add(set, c);
    return set;
  }

 protected:
  double inside(const Pose& X_DP, double) const override { return std::max(0.0, pointOf(at(X_DP)).y - wall_); }

 private:
  /// A knob on the forearm, some way out from its joint.
  dvec3 pointOf(const EntityConfiguration& configuration) const {
    Pose X_WL;
    robot_.partPoses(configuration, {&X_WL, 1});
    return X_WL * dvec3(0.20, 0.06, 0.04);
  }
  double wall_ = 0.0;
};

struct Robot {
  std::shared_ptr<const kinematics::RobotModel> model;
  RobotManipulator::Tool tool;
  std::unique_ptr<const kinematics::InverseModel> inverse;
};

Expected<Robot> loadRobot(bool limited) {
  Diagnostics diagnostics;
  auto entity = workcell::EntityLoader(".").load("library:hc6", 1.0, diagnostics);
  HAPTICELL_TRY(entity);
  auto model = std::make_shared<kinematics::RobotModel>(*entity->robot());
  if (limited) {
    kinematics::Joint& joint = model->joints[static_cast<std::size_t>(model->moving[kForearm - 1])];
    joint.upper = restJoints()[kForearm - 1] + kLimitAhead;
  }
  int tip = model->findLink(entity->jointed().tip_link);
  if (tip < 0) tip = model->defaultTip();
  auto inverse = kinematics::NumericInverse::create(*model, tip, entity->jointed().X_LT);
  HAPTICELL_TRY(inverse);
  return Robot{model, {tip, entity->jointed().X_LT}, std::move(*inverse)};
}

template <typename Scene>
Expected<std::unique_ptr<FeelScene>> makeScene(bool limited) {
  auto robot = loadRobot(limited);
  HAPTICELL_TRY(robot);
  return std::unique_ptr<FeelScene>(
      std::make_unique<Scene>(std::move(robot->model), robot->tool, std::move(robot->inverse)));
}

}  // namespace

Expected<std::unique_ptr<FeelScene>> jointLimitScene() {
  return makeScene<JointLimit>(true);
}

Expected<std::unique_ptr<FeelScene>> linkContactScene() {
  return makeScene<LinkContact>(false);
}

}  // namespace hapticell::feel
