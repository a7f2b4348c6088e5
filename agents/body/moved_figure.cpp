// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "agents/body/moved_body.h"
#include "geometry/system/assertion.h"
#include "mannequin/body/rotations.h"
#include "mannequin/posture/body_solver.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::agents {

namespace {

using mannequin::Segment;
using mannequin::Side;

/// The variables before the legs' are those of the posture solver; the neck's nine come after them.
constexpr std::size_t kTrunkAndArms = kFirstNeckVariable, kNeckTurns = 9;
static_assert(kFirstNeckVariable == mannequin::kLegVariable);
constexpr std::size_t kFigureVariables = kTrunkAndArms + kNeckTurns;
/// The first of the neck's among the joint angles.
constexpr std::size_t kFirstNeckDof = 9;

/// m/s of the pelvis, rad/s of pelvis, spine, arms and neck: a person who is careful. Half: runs take twice as long;
/// twice: hurried, and more steps are cut near obstacles.
constexpr std::array kSpeeds{0.25, 0.5, 0.6, 1.6, 1.0};
/// How readily they follow a hand; our choice. Half beside the arms' 1: the arm stretches first; twice: the trunk leans
/// early.
constexpr std::array kReadiness{0.10, 0.05, 0.15, 1.0, 0.0};
/// m that a foot may be off its place after a step: a third of what the posture solver calls solved. Half: more steps
/// are refused; twice: feet slide visibly over a long run.
constexpr double kFootPlace = 1e-4;

/// What does not change with the posture.
struct FigurePlan {
  std::shared_ptr<const mannequin::Figure> figure;
  std::shared_ptr<const kinematics::RobotModel> model;
  Side side = Side::kRight;
  int hand_link = 0;
  std::vector<Segment> segment_of;  ///< Of each link.
  std::array<int, mannequin::kSegmentCount> link_of{};
  std::array<std::array<bool, mannequin::kSegmentCount>, kFigureVariables> carries{};
  std::array<mannequin::SegmentPlace, 2> feet{};
};

Segment segmentOf(std::size_t variable) {
  if (variable < kTrunkAndArms) return mannequin::segmentOfVariable(static_cast<int>(variable));
  return mannequin::dofInfo(static_cast<mannequin::Dof>(kFirstNeckDof + variable - kTrunkAndArms)).segment;
}

bool isLeg(Segment segment) {
  return segment >= Segment::kLeftThigh;
}

/// The axis of a turn of the neck in the world: R = Ry Rx Rz, each about the frame that those before it have turned.
dvec3 neckAxis(const mannequin::Posture& posture, const mannequin::FigurePose& pose, std::size_t dof) {
  const mannequin::DofInfo& info = mannequin::dofInfo(static_cast<mannequin::Dof>(dof));
  double y = 0.0, x = 0.0;
  for (std::size_t k = kFirstNeckDof; k < kFirstNeckDof + kNeckTurns; ++k) {
    const mannequin::DofInfo& other = mannequin::dofInfo(static_cast<mannequin::Dof>(k));
    if (other.segment != info.segment) continue;
    if (other.axis == 1) y = other.sign * posture.angles[k];
    if (other.axis == 0) x = other.sign * posture.angles[k];
  }
  dvec3 axis(0.0);
  axis[info.axis] = info.sign;
  dmat3 before(1.0);
  if (info.axis != 1) before = mannequin::aboutY(y);
  if (info.axis == 2) before = before * mannequin::aboutX(x);
  return pose[*mannequin::segmentInfo(info.segment).parent].R_WS * before * axis;
}

double pick(const std::array<double, 5>& values, std::size_t variable) {
  return values[static_cast<std::size_t>(regionOf(variable))];
}

class MovedFigure final : public MovedBody {
 public:
  MovedFigure(std::shared_ptr<const FigurePlan> plan, const mannequin::Posture& posture)
      : plan_(std::move(plan)), posture_(posture), view_{*plan_->figure, posture_, pose_, plan_->side, plan_->link_of} {
    state_ = mannequin::stateOf(posture_);
    mannequin::placeSegments(*plan_->figure, state_, pose_);
    mannequin::findAxes(state_, pose_, axes_);
    mannequin::ModelConfiguration model = mannequin::toModel(*plan_->figure, posture_);
    at_ = {model.X_WE, std::move(model.joints)};
    for (std::size_t v = 0; v < kTrunkAndArms; ++v) screws_[v] = {axes_.axis[v], axes_.origin[v], v < 3};
    for (std::size_t k = 0; k < kNeckTurns; ++k) {
      const Segment segment = segmentOf(kTrunkAndArms + k);
      screws_[kTrunkAndArms + k] = {neckAxis(posture_, pose_, kFirstNeckDof + k), pose_[segment].p_WS, false};
    }
    const Pose hand = mannequin::handPose(pose_, plan_->side);
    handle_ = {hand * plan_->figure->p_HandGrip[static_cast<std::size_t>(plan_->side)], hand.q};
  }
  MovedFigure(const MovedFigure&) = delete;
  MovedFigure& operator=(const MovedFigure&) = delete;

  const manipulation::EntityConfiguration& configuration() const override { return at_; }
  const Pose& handle() const override { return handle_; }
  int handleLink() const override { return plan_->hand_link; }
  std::span<const Screw> screws() const override { return screws_; }
  bool carries(std::size_t variable, int link) const override {
    const Segment segment = plan_->segment_of[static_cast<std::size_t>(std::max(0, link))];
    return plan_->carries[variable][mannequin::indexOf(segment)];
  }
  const FigureView* figure() const override { return &view_; }
  bool isFixed(int link) const override {
    const Segment segment = plan_->segment_of[static_cast<std::size_t>(std::max(0, link))];
    return segment == Segment::kLeftFoot || segment == Segment::kLeftToes || segment == Segment::kRightFoot ||
           segment == Segment::kRightToes;
  }

  Room room(std::size_t variable) const override {
    if (variable < 6) return {};
    if (const auto dof = dofOf(variable)) {
      const mannequin::DofInfo& info = mannequin::dofInfo(*dof);
      const double angle = posture_[*dof];
      return {angle - info.lower, info.upper - angle};
    }
    // A shoulder: cone, free, bone.
    const bool left = variable < static_cast<std::size_t>(mannequin::armVariable(Side::kRight));
    const auto first = static_cast<std::size_t>(mannequin::armVariable(left ? Side::kLeft : Side::kRight)) + 2;
    const mannequin::BallAxes& ball = axes_.balls[left ? 0 : 1];
    if (variable == first) {
      const double left_rad = (ball.state.rho_max - ball.state.rho) / std::max(0.1, std::abs(ball.cone_rate));
      Room cone;
      (ball.cone_rate >= 0.0 ? cone.up : cone.down) = left_rad;
      return cone;
    }
    if (variable == first + 2) {
      return {ball.state.twist - mannequin::kShoulderTwistLower, mannequin::kShoulderTwistUpper - ball.state.twist};
    }
    return {};
  }

  double speed(std::size_t variable) const override { return pick(kSpeeds, variable); }
  double readiness(std::size_t variable) const override { return pick(kReadiness, variable); }

  std::string nameOf(std::size_t variable) const override {
    if (variable < 6) return "pelvis";
    if (const auto dof = dofOf(variable)) return mannequin::dofInfo(*dof).name;
    return mannequin::segmentInfo(segmentOf(variable)).joint;
  }

  std::unique_ptr<MovedBody> moved(std::span<const double> step) const override {
    HAPTICELL_DEMAND(step.size() == kFigureVariables);
    // Where the legs do not reach, the pelvis goes less far, then not at all.
    for (const double pelvis : {1.0, 0.5, 0.0}) {
      if (auto there = movedWith(step, pelvis)) return there;
    }
    return nullptr;
  }

  std::unique_ptr<MovedBody> placed(const manipulation::EntityConfiguration& at) const override {
    const mannequin::Posture posture = mannequin::toPosture(*plan_->figure, {at.X_WE, at.joints});
    auto plan = std::make_shared<FigurePlan>(*plan_);
    const mannequin::FigurePose pose = mannequin::forwardKinematics(*plan->figure, posture);
    plan->feet = {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
    return std::make_unique<MovedFigure>(std::move(plan), posture);
  }

 private:
  static std::optional<mannequin::Dof> dofOf(std::size_t variable) {
    if (variable < kTrunkAndArms) return mannequin::dofOfVariable(static_cast<int>(variable));
    return static_cast<mannequin::Dof>(kFirstNeckDof + variable - kTrunkAndArms);
  }
  std::unique_ptr<MovedFigure> movedWith(std::span<const double> step, double pelvis) const {
    mannequin::Variables move{};
    std::copy_n(step.begin(), kTrunkAndArms, move.begin());
    for (std::size_t v = 0; v < 6; ++v) move[v] *= pelvis;
    mannequin::BodyState state = state_;
    mannequin::applyStep(move, axes_, state);
    for (std::size_t k = 0; k < kNeckTurns; ++k) {
      const mannequin::DofInfo& info = mannequin::dofInfo(static_cast<mannequin::Dof>(kFirstNeckDof + k));
      double& angle = state.angles[kFirstNeckDof + k];
      angle = std::clamp(angle + step[kTrunkAndArms + k], info.lower, info.upper);
    }
    mannequin::placeFeet(*plan_->figure, plan_->feet, state);
    auto there = std::make_unique<MovedFigure>(plan_, mannequin::postureOf(state, posture_.gaze));
    return there->offFeet() > std::max(kFootPlace, offFeet()) ? nullptr : std::move(there);
  }
  /// m, of the worse foot, a radian of its turn counting 0.1 m.
  double offFeet() const {
    double off = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
      const Pose now = mannequin::footPose(pose_, static_cast<Side>(side));
      const Twist way = difference(now, plan_->feet[side].pose());
      off = std::max(off, glm::length(way.linear) + 0.1 * glm::length(way.angular));
    }
    return off;
  }

  std::shared_ptr<const FigurePlan> plan_;
  mannequin::Posture posture_;
  mannequin::BodyState state_;
  mannequin::FigurePose pose_;
  mannequin::VariableAxes axes_;
  manipulation::EntityConfiguration at_;
  std::array<Screw, kFigureVariables> screws_{};
  Pose handle_;
  FigureView view_;
};

/// Which segments each variable moves. The pelvis moves thighs too, although their other end stays; shanks and feet are
/// left out.
void fillCarries(FigurePlan& plan) {
  for (std::size_t v = 0; v < kFigureVariables; ++v) {
    const Segment mover = segmentOf(v);
    for (std::size_t s = 0; s < mannequin::kSegmentCount; ++s) {
      const auto segment = static_cast<Segment>(s);
      const bool thigh = segment == Segment::kLeftThigh || segment == Segment::kRightThigh;
      if (isLeg(segment) && !thigh) continue;
      for (Segment at = segment;; at = *mannequin::segmentInfo(at).parent) {
        if (at == mover) plan.carries[v][s] = true;
        if (at == mover || !mannequin::segmentInfo(at).parent) break;
      }
    }
  }
}

}  // namespace

BodyRegion regionOf(std::size_t variable) {
  if (variable < 3) return BodyRegion::kPelvisPlace;
  if (variable < 6) return BodyRegion::kPelvisTurn;
  if (variable < static_cast<std::size_t>(mannequin::kArmVariable)) return BodyRegion::kSpine;
  return variable < kFirstNeckVariable ? BodyRegion::kArms : BodyRegion::kNeck;
}

Expected<std::unique_ptr<MovedBody>> makeMovedFigure(const workcell::Entity& entity, Side side) {
  auto plan = std::make_shared<FigurePlan>();
  plan->figure = entity.figure();
  plan->model = entity.robot();
  plan->side = side;
  for (std::size_t link = 0; link < plan->model->links.size(); ++link) {
    auto body = static_cast<std::size_t>(std::max(0, mannequin::bodyOfLink(*plan->model, static_cast<int>(link))));
    while (body >= mannequin::kSegmentCount) body = mannequin::parentBody(body);
    plan->segment_of.push_back(static_cast<Segment>(body));
  }
  for (std::size_t link = 0; link < plan->segment_of.size(); ++link) {
    const int body = mannequin::bodyOfLink(*plan->model, static_cast<int>(link));
    if (body >= 0 && body < static_cast<int>(mannequin::kSegmentCount))
      plan->link_of[static_cast<std::size_t>(body)] = static_cast<int>(link);
  }
  plan->hand_link = plan->link_of[mannequin::indexOf(mannequin::armSegment(side, Segment::kLeftHand))];
  fillCarries(*plan);
  const mannequin::Posture posture = mannequin::toPosture(*plan->figure, {entity.X_WE, entity.joints()});
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*plan->figure, posture);
  plan->feet = {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
  return std::make_unique<MovedFigure>(std::move(plan), posture);
}

}  // namespace hapticell::agents
