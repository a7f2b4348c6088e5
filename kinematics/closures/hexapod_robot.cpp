// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/hexapod_robot.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "kinematics/closures/closure_inverse.h"

namespace hapticell::kinematics {

namespace {

constexpr std::size_t kLegs = 1, kHexapodPlatform = 13, kHexapodTool = 14;  // Places of the links.
// m and rad: the legs are a solution, as kReached of closure_inverse.cpp. Half, twice: no effect, the lengths of the
// legs are exact or the assembly is another.
constexpr double kHexapodSolved = 1e-9;
// Of the platform's radius, of a leg, from one known pose to the next; chosen by trial, so that Newton stays in the
// home's assembly. Half: twice the steps from home; twice: it may converge to another assembly.
constexpr double kLongestLegStride = 0.1;

Pose alongLeg(const dvec3& p, const dvec3& direction) {
  const dvec3 z(0, 0, 1);
  const dvec3 axis = glm::cross(z, direction);
  const double s = glm::length(axis), c = glm::dot(z, direction);
  dquat q = c > 0 ? dquat(1, 0, 0, 0) : dquat(0, 1, 0, 0);
  if (s > 1e-12) q = glm::angleAxis(std::atan2(s, c), axis / s);
  return {p, glm::normalize(q)};
}

LegLengths legsOf(const std::vector<double>& q) {
  LegLengths lengths{};
  std::copy_n(q.begin(), 6, lengths.begin());
  return lengths;
}

class HexapodClosure final : public Closure, public std::enable_shared_from_this<HexapodClosure> {
 public:
  HexapodClosure(const HexapodGeometry& geometry, const HexapodOptions& options)
      : hexapod_(geometry), options_(options), home_(hexapod_.lengths(options.X_BPHome)) {
    regular_home_ = hexapod_.regularity(options.X_BPHome);
    for (std::size_t i = 0; i < 6; ++i) {
      const dvec3 leg = options.X_BPHome * geometry.p_PC[i] - geometry.p_BA[i];
      home_direction_B_[i] = glm::normalize(leg);
      home_direction_P_[i] = options.X_BPHome.inverse().rotate(home_direction_B_[i]);
    }
  }

  std::string name() const override { return "hexapod"; }

  /// The platform for leg lengths in the home's assembly: Newton from the last pose when that is near, else from home
  /// in strides.
  bool platform(const LegLengths& lengths, Pose& X_BP) const {
    LegLengths from = home_;
    X_BP = options_.X_BPHome;
    {
      const std::lock_guard lock(mutex_);
      if (has_last_ && farthest(last_, lengths) < farthest(home_, lengths)) {
        from = last_;
        X_BP = X_BPLast_;
      }
    }
    const int strides = std::clamp(
        static_cast<int>(std::ceil(farthest(from, lengths) / (kLongestLegStride * hexapod_.radius()))), 1, 400);
    bool found = true;
    for (int stride = 1; stride <= strides && found; ++stride) {
      LegLengths here{};
      for (std::size_t i = 0; i < 6; ++i) {
        here[i] = stride == strides ? lengths[i] : from[i] + (lengths[i] - from[i]) * stride / strides;
      }
      const HexapodForward forward = hexapod_.forward(here, X_BP);
      found = forward.converged;
      X_BP = forward.X_BP;
    }
    if (found) {
      const std::lock_guard lock(mutex_);
      has_last_ = true;
      last_ = lengths;
      X_BPLast_ = X_BP;
    }
    return found;
  }

  bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const override {
    X_BL.resize(kHexapodTool + 1);
    Pose X_BP;
    const bool found = platform(legsOf(q), X_BP);
    X_BL[0] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      const dvec3 bottom = hexapod_.geometry().p_BA[i], top = X_BP * hexapod_.geometry().p_PC[i];
      const dvec3 direction = glm::normalize(top - bottom);
      X_BL[kLegs + 2 * i] = alongLeg(bottom, direction);
      X_BL[kLegs + 2 * i + 1] = alongLeg(top, direction);
    }
    X_BL[kHexapodPlatform] = X_BP;
    X_BL[kHexapodTool] = X_BP * Pose::translation({0, 0, options_.tool_length});
    return found;
  }

  void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const override {
    Pose X_BP;
    platform(legsOf(q), X_BP);
    out.clear();
    for (std::size_t i = 0; i < 6; ++i) {
      const dvec3 leg = glm::normalize(X_BP * hexapod_.geometry().p_PC[i] - hexapod_.geometry().p_BA[i]);
      const auto lean = [&](const dvec3& a, const dvec3& b) {
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      };
      out.push_back({Text("the lower joint of leg %1", i + 1), options_.swivel_limit - lean(leg, home_direction_B_[i]),
                     ClosureMargin::Kind::kAngle});
      out.push_back({Text("the upper joint of leg %1", i + 1),
                     options_.swivel_limit - lean(X_BP.inverse().rotate(leg), home_direction_P_[i]),
                     ClosureMargin::Kind::kAngle});
    }
    out.push_back({Text("the platform"), hexapod_.regularity(X_BP) / regular_home_ - options_.least_regular,
                   ClosureMargin::Kind::kSingularity});
  }

  Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel& model, int tip_link,
                                                  const Pose& X_LT) const override;

  const HexapodKinematics& hexapod() const { return hexapod_; }
  double toolLength() const { return options_.tool_length; }
  double regularHome() const { return regular_home_; }

 private:
  static double farthest(const LegLengths& a, const LegLengths& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < 6; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  HexapodKinematics hexapod_;
  HexapodOptions options_;
  LegLengths home_{};
  double regular_home_ = 1.0;
  std::array<dvec3, 6> home_direction_B_{}, home_direction_P_{};
  mutable std::mutex mutex_;  // Guards the last pose: a start that is nearer than home.
  mutable bool has_last_ = false;
  mutable LegLengths last_{};
  mutable Pose X_BPLast_;
};

/// Closed form where the legs allow it; the descent of ClosureInverse where they do not.
class HexapodInverse final : public ClosureInverse {
 public:
  HexapodInverse(const RobotModel& model, std::shared_ptr<const HexapodClosure> closure, int tip_link, const Pose& X_LT)
      : ClosureInverse(model, tip_link, X_LT), closure_(std::move(closure)) {
    const double length = static_cast<std::size_t>(tip_link) == kHexapodTool ? closure_->toolLength() : 0.0;
    X_TP_ = (Pose::translation({0, 0, length}) * X_LT).inverse();
  }

  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override {
    if (closedForm(X_BT, solution) && withinSpeed(solution.q, q_start, duration_s)) return;
    ClosureInverse::solveNearest(X_BT, q_start, duration_s, solution);
  }

  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override {
    InverseSolution solution;
    if (closedForm(X_BT, solution)) return solution;
    ClosureInverse::solveNearest(X_BT, q_start, kUnboundedDuration, solution);
    // Six distances always exist: only limits, hinges or a singular surface can be in the way.
    if (solution.status == InverseStatus::kUnreachable) solution.status = InverseStatus::kLimit;
    return solution;
  }

  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>&) const override {
    InverseSolution one;
    one.q = legsFor(X_BT);
    judge(X_BT, limits(), one);
    if (one.position_error > kHexapodSolved || one.orientation_error > kHexapodSolved) return {};  // Another's.
    return {{one.q, withinLimits(one.q), "the home's assembly"}};
  }

 private:
  std::vector<double> legsFor(const Pose& X_BT) const {
    const LegLengths lengths = closure_->hexapod().lengths(X_BT * X_TP_);
    return {lengths.begin(), lengths.end()};
  }

  bool closedForm(const Pose& X_BT, InverseSolution& solution) const {
    solution.q = legsFor(X_BT);
    if (!withinLimits(solution.q)) return false;
    judge(X_BT, limits(), solution);
    return solution.position_error < kHexapodSolved && solution.orientation_error < kHexapodSolved;
  }

  std::shared_ptr<const HexapodClosure> closure_;
  Pose X_TP_;
};

Expected<std::unique_ptr<InverseModel>> HexapodClosure::inverse(const RobotModel& model, int tip_link,
                                                                const Pose& X_LT) const {
  const auto tip = static_cast<std::size_t>(tip_link);
  if (tip != kHexapodPlatform && tip != kHexapodTool) return ClosureInverse::create(model, tip_link, X_LT);
  return std::unique_ptr<InverseModel>(new HexapodInverse(model, shared_from_this(), tip_link, X_LT));
}

}  // namespace

Expected<RobotModel> buildHexapod(const std::string& name, const HexapodGeometry& geometry,
                                  const HexapodOptions& options, const std::vector<JointData>& joints) {
  const Text place("hexapod '%1'", name);
  if (joints.size() != 6)
    return makeError({.place = place, .found = Text("%1 joints", joints.size()), .expected = "6 legs"});
  RobotModel model;
  model.name = name;
  model.links.push_back({"base_link", -1, {}, {}});
  const auto addLink = [&](const std::string& link, int parent, const Joint& prototype) {
    Joint joint = prototype;
    joint.parent_link = parent;
    joint.child_link = static_cast<int>(model.links.size());
    model.links.push_back({link, static_cast<int>(model.joints.size()), {}, {}});
    if (joint.type == JointType::kPrismatic) {
      joint.variable = static_cast<int>(model.moving.size());
      model.moving.push_back(static_cast<int>(model.joints.size()));
    }
    model.joints.push_back(std::move(joint));
  };
  const auto closure = std::make_shared<HexapodClosure>(geometry, options);
  const LegLengths home = closure->hexapod().lengths(options.X_BPHome);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string leg = "leg_" + std::to_string(i + 1);
    Joint hinge, slide;
    hinge.name = leg + " hinge";
    slide.name = joints[i].name;
    slide.type = JointType::kPrismatic;
    slide.lower = joints[i].lower;
    slide.upper = joints[i].upper;
    slide.velocity = joints[i].velocity;
    addLink(leg + "_lower", 0, hinge);
    addLink(leg + "_upper", static_cast<int>(model.links.size()) - 1, slide);
    const Text at("hexapod '%1', %2", name, leg);
    if (!(home[i] > 1e-9))
      return makeError(
          {.place = at, .found = "both joints of the leg are at the same point", .expected = "a leg length above 0"});
    if (home[i] < slide.lower || home[i] > slide.upper) {
      return makeError({.place = at,
                        .found = Text("a length of %1 m at the home position", std::to_string(home[i])),
                        .expected = Text("%1 to %2 m, the limits of the leg", std::to_string(slide.lower),
                                         std::to_string(slide.upper))});
    }
  }
  Joint top, flange;
  top.name = "platform hinge";
  flange.name = "flange";
  addLink("platform", static_cast<int>(kLegs) + 1, top);
  addLink("tool0", static_cast<int>(kHexapodPlatform), flange);
  if (std::abs(closure->regularHome()) < 1e-6)
    return makeError({.place = place,
                      .found = "the home position is singular",
                      .expected = "a home position in which the six legs fix the platform",
                      .fix = "Move the joints of the legs apart, or rotate the platform relative to the base."});
  model.tip = static_cast<int>(kHexapodTool);
  model.home.assign(home.begin(), home.end());
  model.closure = closure;
  for (int k = 1; k <= 12; ++k) {
    model.disabled_pairs.push_back({0, k, "Adjacent"});
    model.disabled_pairs.push_back({k, static_cast<int>(kHexapodPlatform), "Adjacent"});
  }
  return model;
}

}  // namespace hapticell::kinematics
