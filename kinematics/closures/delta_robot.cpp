// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/delta_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/closures/closure_inverse.h"

namespace hapticell::kinematics {

namespace {

constexpr std::size_t kArms = 1, kRods = 4, kDeltaPlatform = 10, kDeltaTool = 11;  // Places of the links.
// m and rad: a branch is a solution, as kReached of closure_inverse.cpp. Half, twice: no effect, the closed form is
// exact or the orientation is another.
constexpr double kDeltaSolved = 1e-9;

Pose frameOf(const dvec3& p, const dvec3& x, const dvec3& y_hint) {
  const dvec3 ex = glm::normalize(x);
  const dvec3 ez = glm::normalize(glm::cross(ex, y_hint));
  return {p, glm::normalize(glm::quat_cast(dmat3(ex, glm::cross(ez, ex), ez)))};
}

class DeltaClosure final : public Closure, public std::enable_shared_from_this<DeltaClosure> {
 public:
  DeltaClosure(const DeltaGeometry& geometry, const DeltaOptions& options) : delta_(geometry), options_(options) {}

  std::string name() const override { return "delta"; }

  bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const override {
    X_BL.resize(kDeltaTool + 1);
    const std::array<double, 3> theta{q[0], q[1], q[2]};
    dvec3 p_BP{0.0};
    const bool closed = delta_.forward(theta, p_BP);
    X_BL[0] = {};
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(k);
      const dvec3 out = delta_.outward(k), side = glm::cross(dvec3(0, 0, 1), out);
      const dvec3 axle = delta_.geometry().base_radius * out, knee = delta_.knee(k, theta[place]);
      X_BL[kArms + place] = frameOf(axle, knee - axle, side);
      const dvec3 joint = delta_.platformJoint(k, p_BP);
      const dvec3 half = 0.5 * delta_.geometry().rod_spacing * side;
      X_BL[kRods + 2 * place] = frameOf(knee + half, joint - knee, side);
      X_BL[kRods + 2 * place + 1] = frameOf(knee - half, joint - knee, side);
    }
    X_BL[kDeltaPlatform] = Pose::translation(p_BP);
    const double turn = q.size() > 3 ? q[3] : 0.0;
    X_BL[kDeltaTool] = X_BL[kDeltaPlatform] * toolInPlatform(turn);
    return closed;
  }

  Pose toolInPlatform(double turn) const {
    // The tool looks away from the base: z downwards on a hanging robot.
    const bool up = delta_.geometry().upward;
    const dquat about_z = glm::angleAxis(turn, dvec3(0, 0, 1));
    const dquat over = up ? dquat(1, 0, 0, 0) : dquat(0, 1, 0, 0);
    return {dvec3(0, 0, up ? options_.tool_length : -options_.tool_length), about_z * over};
  }

  void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const override {
    std::vector<Pose> X_BL;
    pose(q, X_BL);
    out.clear();
    std::array<dvec3, 3> rods;
    for (std::size_t k = 0; k < 3; ++k) {
      rods[k] = X_BL[kRods + 2 * k].rotate({1, 0, 0});
      const dvec3 side = glm::cross(dvec3(0, 0, 1), delta_.outward(static_cast<int>(k)));
      const double lean = std::asin(std::clamp(std::abs(glm::dot(rods[k], side)), 0.0, 1.0));
      out.push_back({Text("the ball joint of rod %1", k + 1), options_.ball_limit - lean, ClosureMargin::Kind::kAngle});
    }
    const double volume = std::abs(glm::dot(rods[0], glm::cross(rods[1], rods[2])));
    out.push_back({Text("the platform"), volume - options_.least_regular, ClosureMargin::Kind::kSingularity});
  }

  Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel& model, int tip_link,
                                                  const Pose& X_LT) const override;

  const DeltaKinematics& delta() const { return delta_; }

 private:
  DeltaKinematics delta_;
  DeltaOptions options_;
};

/// Closed form where the pose is reached; the descent of ClosureInverse where it is not.
class DeltaInverse final : public ClosureInverse {
 public:
  DeltaInverse(const RobotModel& model, std::shared_ptr<const DeltaClosure> closure, int tip_link, const Pose& X_LT)
      : ClosureInverse(model, tip_link, X_LT), closure_(std::move(closure)), tip_(static_cast<std::size_t>(tip_link)) {}

  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override {
    if (closedForm(X_BT, q_start, solution) && withinSpeed(solution.q, q_start, duration_s)) return;
    ClosureInverse::solveNearest(X_BT, q_start, duration_s, solution);
  }

  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override {
    InverseSolution solution;
    if (closedForm(X_BT, q_start, solution)) return solution;
    const auto all = solveAll(X_BT, q_start);
    if (!all.empty() && all.front().within_limits) {
      solution.q = all.front().q;
      judge(X_BT, limits(), solution);
      if (solution.status == InverseStatus::kSolved) return solution;
    }
    ClosureInverse::solveNearest(X_BT, q_start, kUnboundedDuration, solution);
    if (!all.empty() && solution.status != InverseStatus::kSolved) solution.status = InverseStatus::kLimit;
    return solution;
  }

  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const override {
    std::vector<AlternativeSolution> found;
    double turn = 0.0;
    const dvec3 p_BP = platformFor(X_BT, q_start, turn);
    DeltaBranches branches{};
    closure_->delta().inverseAll(p_BP, branches);
    for (std::size_t branch = 0; branch < branches.size(); ++branch) {
      AlternativeSolution one;
      one.q.assign(branches[branch].begin(), branches[branch].end());
      if (q_start.size() > 3) one.q.push_back(turn);
      if (!std::isfinite(one.q[0] + one.q[1] + one.q[2])) continue;
      InverseSolution checked;
      checked.q = one.q;
      judge(X_BT, limits(), checked);
      if (checked.position_error > kDeltaSolved || checked.orientation_error > kDeltaSolved) continue;
      one.within_limits = withinLimits(one.q);
      for (std::size_t k = 0; k < 3; ++k) {
        one.configuration +=
            (k > 0 ? ", arm " : "arm ") + std::to_string(k + 1) + ((branch >> k & 1u) != 0 ? " in" : " out");
      }
      found.push_back(std::move(one));
    }
    std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
      if (a.within_limits != b.within_limits) return a.within_limits;
      return distance(a.q, q_start) < distance(b.q, q_start);
    });
    return found;
  }

 private:
  static double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
  }

  /// Where the platform must be for the tool centre point to be at the pose's position, and the turn of the tool that
  /// comes nearest to its orientation.
  dvec3 platformFor(const Pose& X_BT, const std::vector<double>& q_start, double& turn) const {
    turn = q_start.size() > 3 ? q_start[3] : 0.0;
    Pose X_PT = toolInTip();
    if (tip_ == kDeltaTool) {
      if (q_start.size() > 3) {
        const dmat3 R = glm::mat3_cast(X_BT.q * glm::conjugate((closure_->toolInPlatform(0.0) * toolInTip()).q));
        const double angle = std::atan2(R[0][1] - R[1][0], R[0][0] + R[1][1]);
        turn = angle + 2.0 * std::numbers::pi * std::round((turn - angle) / (2.0 * std::numbers::pi));
        if (turn > limits().upper[3]) turn -= 2.0 * std::numbers::pi;
        if (turn < limits().lower[3]) turn += 2.0 * std::numbers::pi;
      }
      X_PT = closure_->toolInPlatform(turn) * toolInTip();
    }
    return X_BT.p - X_PT.p;
  }

  /// The branch nearest to the start, arm by arm; false where it is not within limits or does not reach.
  bool closedForm(const Pose& X_BT, const std::vector<double>& q_start, InverseSolution& solution) const {
    double turn = 0.0;
    const dvec3 p_BP = platformFor(X_BT, q_start, turn);
    std::array<double, 3> outer{}, inner{};
    if (!closure_->delta().inverse(p_BP, outer, inner)) return false;
    solution.q.resize(q_start.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const bool out = std::abs(outer[k] - q_start[k]) <= std::abs(inner[k] - q_start[k]);
      solution.q[k] = out ? outer[k] : inner[k];
    }
    if (q_start.size() > 3) solution.q[3] = turn;
    if (!withinLimits(solution.q)) return false;
    judge(X_BT, limits(), solution);
    return solution.position_error < kDeltaSolved && solution.orientation_error < kDeltaSolved;
  }

  std::shared_ptr<const DeltaClosure> closure_;
  std::size_t tip_ = 0;
};

Expected<std::unique_ptr<InverseModel>> DeltaClosure::inverse(const RobotModel& model, int tip_link,
                                                              const Pose& X_LT) const {
  const auto tip = static_cast<std::size_t>(tip_link);
  if (tip != kDeltaPlatform && tip != kDeltaTool) return ClosureInverse::create(model, tip_link, X_LT);
  return std::unique_ptr<InverseModel>(new DeltaInverse(model, shared_from_this(), tip_link, X_LT));
}

}  // namespace

Expected<RobotModel> buildDelta(const std::string& name, const DeltaGeometry& geometry, const DeltaOptions& options,
                                const std::vector<JointData>& joints, const std::vector<double>& home) {
  const Text place("Delta '%1'", name);
  for (const double length : {geometry.base_radius, geometry.upper_arm, geometry.lower_arm, geometry.platform_radius}) {
    if (!(length > 0.0) || !std::isfinite(length))
      return makeError({.place = place,
                        .found = "an invalid length",
                        .expected = "base_radius, upper_arm, lower_arm and platform_radius above 0"});
  }
  if (joints.size() != 3 && joints.size() != 4)
    return makeError(
        {.place = place, .found = Text("%1 joints", joints.size()), .expected = "3 joints, or 4 if the tool turns"});
  RobotModel model;
  model.name = name;
  const auto addLink = [&](const std::string& link, int parent, bool moving, const std::string& joint_name) {
    Joint joint;
    joint.name = joint_name;
    joint.parent_link = parent;
    joint.child_link = static_cast<int>(model.links.size());
    joint.axis_J = {0.0, 1.0, 0.0};
    if (moving) {
      const JointData& data = joints[model.moving.size()];
      joint.type = JointType::kRevolute;
      joint.lower = data.lower;
      joint.upper = data.upper;
      joint.velocity = data.velocity;
      joint.variable = static_cast<int>(model.moving.size());
      model.moving.push_back(static_cast<int>(model.joints.size()));
    }
    model.links.push_back({link, static_cast<int>(model.joints.size()), {}, {}});
    model.joints.push_back(std::move(joint));
  };
  model.links.push_back({"base_link", -1, {}, {}});
  for (std::size_t k = 0; k < 3; ++k) addLink("arm_" + std::to_string(k + 1), 0, true, joints[k].name);
  for (int k = 0; k < 3; ++k) {
    for (const char* side : {"a", "b"}) {
      const std::string rod = "rod_" + std::to_string(k + 1) + side;
      addLink(rod, k + 1, false, rod + " ball");
    }
  }
  addLink("platform", 4, false, "platform ball");
  const bool turns = joints.size() == 4;
  addLink("tool0", static_cast<int>(kDeltaPlatform), turns, turns ? joints[3].name : "flange");
  model.tip = static_cast<int>(kDeltaTool);
  model.home = home;
  const auto closure = std::make_shared<DeltaClosure>(geometry, options);
  model.closure = closure;
  std::vector<Pose> X_BL;
  if (!closure->pose(restPositions(model), X_BL))
    return makeError({.place = place,
                      .found = "the rods do not reach the platform at the home position",
                      .expected = "lengths that can be assembled"});
  for (int k = 1; k <= 9; ++k) model.disabled_pairs.push_back({0, k, "Adjacent"});
  // Every rod hangs on the platform, whichever of them carries it in the tree.
  const int platform = model.findLink("platform");
  for (std::size_t k = 1; platform >= 0 && k < model.links.size(); ++k) {
    if (model.links[k].name.starts_with("rod_"))
      model.disabled_pairs.push_back({static_cast<int>(k), platform, "Adjacent"});
  }
  return model;
}

}  // namespace hapticell::kinematics
