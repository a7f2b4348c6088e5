// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/moved_body.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::agents {

namespace {

/// Share of the joints' greatest speeds that agents use. Half: runs take twice as long; twice: the robot's own limit.
constexpr double kSpeedShare = 0.5;

/// What does not change with the joints.
struct RobotPlan {
  std::shared_ptr<const kinematics::RobotModel> model;
  int tip = 0;
  Pose X_LT;
  std::vector<std::vector<bool>> carries;  ///< By variable, then link.
  std::vector<bool> led;                   ///< By variable: another joint follows it; agents leave it alone.
};

class MovedRobot final : public MovedBody {
 public:
  MovedRobot(std::shared_ptr<const RobotPlan> plan, manipulation::EntityConfiguration at)
      : plan_(std::move(plan)), at_(std::move(at)), screws_(plan_->model->dof()) {
    const kinematics::RobotModel& model = *plan_->model;
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(model, at_.joints, X_BL);
    for (std::size_t v = 0; v < screws_.size(); ++v) {
      const kinematics::Joint& joint = jointOf(v);
      const Pose X_WL = at_.X_WE * X_BL[static_cast<std::size_t>(joint.child_link)];
      // The axis is the same in the child's frame: the joint turns about it.
      screws_[v] = {X_WL.rotate(joint.axis_J), X_WL.p, joint.type == kinematics::JointType::kPrismatic};
    }
    handle_ = at_.X_WE * X_BL[static_cast<std::size_t>(plan_->tip)] * plan_->X_LT;
  }

  const manipulation::EntityConfiguration& configuration() const override { return at_; }
  const Pose& handle() const override { return handle_; }
  int handleLink() const override { return plan_->tip; }
  std::span<const Screw> screws() const override { return screws_; }
  bool carries(std::size_t variable, int link) const override {
    return plan_->carries[variable][static_cast<std::size_t>(std::max(0, link))];
  }
  bool isFixed(int link) const override {
    for (std::size_t v = 0; v < size(); ++v) {
      if (carries(v, link)) return false;
    }
    return true;
  }
  Room room(std::size_t variable) const override {
    const kinematics::Joint& joint = jointOf(variable);
    return {at_.joints[variable] - joint.lower, joint.upper - at_.joints[variable]};
  }
  double speed(std::size_t variable) const override {
    return plan_->led[variable] ? 0.0 : kSpeedShare * kinematics::greatestSpeed(jointOf(variable));
  }
  double readiness(std::size_t variable) const override { return plan_->led[variable] ? 0.0 : 1.0; }
  std::string nameOf(std::size_t variable) const override { return jointOf(variable).name; }

  std::unique_ptr<MovedBody> moved(std::span<const double> step) const override {
    manipulation::EntityConfiguration to = at_;
    for (std::size_t v = 0; v < to.joints.size(); ++v) {
      const kinematics::Joint& joint = jointOf(v);
      to.joints[v] = std::clamp(to.joints[v] + step[v], joint.lower, joint.upper);
    }
    return placed(to);
  }
  std::unique_ptr<MovedBody> placed(const manipulation::EntityConfiguration& at) const override {
    return std::make_unique<MovedRobot>(plan_, at);
  }

 private:
  const kinematics::Joint& jointOf(std::size_t variable) const {
    return plan_->model->joints[static_cast<std::size_t>(plan_->model->moving[variable])];
  }

  std::shared_ptr<const RobotPlan> plan_;
  manipulation::EntityConfiguration at_;
  std::vector<Screw> screws_;
  Pose handle_;
};

}  // namespace

Expected<std::unique_ptr<MovedBody>> makeMovedRobot(const workcell::Entity& entity) {
  const auto refused = [&](Text found, Text expected) {
    return makeError(
        {.place = Text("entity '%1'", entity.name), .found = std::move(found), .expected = std::move(expected)});
  };
  auto plan = std::make_shared<RobotPlan>();
  plan->model = entity.robot();
  if (plan->model->closure) return refused(Text("a robot with closed loops"), Text("one whose joints are a chain or a tree"));
  plan->tip = plan->model->findLink(entity.jointed().tip_link);
  if (plan->tip < 0) plan->tip = plan->model->defaultTip();
  if (plan->tip < 0 || plan->model->dof() == 0) return refused(Text("it has no moving link"), Text("a robot with joints"));
  plan->X_LT = entity.jointed().X_LT;
  plan->carries.assign(plan->model->dof(), std::vector<bool>(plan->model->links.size(), false));
  for (std::size_t link = 0; link < plan->model->links.size(); ++link) {
    for (const int variable : kinematics::variablesOfChain(*plan->model, static_cast<int>(link)))
      plan->carries[static_cast<std::size_t>(variable)][link] = true;
  }
  plan->led.assign(plan->model->dof(), false);
  for (const kinematics::Joint& joint : plan->model->joints) {
    if (!joint.mimic) continue;
    const int variable = plan->model->joints[static_cast<std::size_t>(joint.mimic->joint)].variable;
    if (variable >= 0) plan->led[static_cast<std::size_t>(variable)] = true;
  }
  return std::make_unique<MovedRobot>(std::move(plan),
                                      manipulation::EntityConfiguration{entity.X_WE, entity.joints()});
}

}  // namespace hapticell::agents
