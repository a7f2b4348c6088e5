// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/jog.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"

namespace hapticell::kinematics {

namespace {

/// m of a straight jog between two solutions: a joint then swings little and limits are met within 2 mm. Half: twice
/// the time; twice: the reported stop is 4 mm before the limit.
constexpr double kPieceLength = 0.002;
/// rad, half a degree, for turning as kPieceLength for moving. Half: twice the time; twice: stops a degree before the
/// limit.
constexpr double kPieceTurn = std::numbers::pi / 360.0;
/// rad of a joint in one piece, 10 degrees: twenty times a piece's turn, so near a singularity. Half: stops earlier
/// beside it; twice: the wrist swings 20 degrees at once.
constexpr double kLargestSwing = std::numbers::pi / 18.0;
// A jog of 40 m or 28 turns, more than any cell; bounds the time. Half: pieces over 2 mm from 20 m on; twice: no
// effect.
constexpr int kMostPieces = 20000;
/// m, rad: the pose is met, for the numeric model too, and not to be seen. Half, twice: no effect, solutions are met to
/// 1e-9.
constexpr double kOffPosition = 1e-6, kOffOrientation = 1e-5;
/// rad or m: the joint is named as at its limit; a thousand times the solvers' slack. Half, twice: no effect.
constexpr double kAtLimit = 1e-6;

const Joint& jointOf(const RobotModel& model, std::size_t variable) {
  return model.joints[static_cast<std::size_t>(model.moving[variable])];
}

Pose tcpAt(const JogRobot& robot, const std::vector<double>& q) {
  std::vector<Pose> X_BL;
  forwardKinematics(robot.model, q, X_BL);
  return robot.X_WB * X_BL[static_cast<std::size_t>(robot.tip_link)] * robot.X_LT;
}

/// The joint that turns furthest from one to the other.
std::size_t fastest(const std::vector<double>& from, const std::vector<double>& to, double& swing) {
  std::size_t worst = 0;
  swing = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (std::abs(to[i] - from[i]) <= swing) continue;
    swing = std::abs(to[i] - from[i]);
    worst = i;
  }
  return worst;
}

/// An angle, or a slide's length.
Text::Argument motionOf(const Joint& joint, double amount) {
  if (joint.type == JointType::kPrismatic) return Text::Length{amount};
  return Text::Angle{amount};
}

/// Why the next piece cannot be followed.
Text reasonAt(const RobotModel& model, const std::vector<double>& q, const InverseSolution& tried) {
  double swing = 0.0;
  const std::size_t worst = fastest(q, tried.q, swing);
  if (Text limit = nearestLimitText(model, tried.q, kAtLimit); !limit.empty()) return limit;
  if (tried.status == InverseStatus::kSolved || swing > kLargestSwing)
    return Text("near a singularity %1 would have to swing round", jointOf(model, worst).name);
  return Text("the arm is at the edge of its reach");
}

dquat turnOfFrame(const Pose& X_WT, const Pose& X_WB, const JogStep& step) {
  if (step.frame == JogFrame::kTool) return X_WT.q;
  if (step.frame == JogFrame::kBase) return X_WB.q;
  return step.frame == JogFrame::kGiven ? step.R_WF : dquat(1.0, 0.0, 0.0, 0.0);
}

}  // namespace

Pose jogged(const Pose& X_WT, const Pose& X_WB, const JogStep& step) {
  const dquat R_WF = turnOfFrame(X_WT, X_WB, step);
  return {X_WT.p + R_WF * step.along, glm::normalize(quaternionFromRotationVector(R_WF * step.turn) * X_WT.q)};
}

JogResult jogJoint(const RobotModel& model, const std::vector<double>& q_now, int variable, double amount) {
  HAPTICELL_DEMAND(q_now.size() == model.dof() && variable >= 0 && static_cast<std::size_t>(variable) < q_now.size());
  const auto i = static_cast<std::size_t>(variable);
  const Joint& joint = jointOf(model, i);
  const double wanted = q_now[i] + amount;
  JogResult result{q_now, true, {}};
  result.q[i] = std::clamp(wanted, joint.lower, joint.upper);
  result.complete = result.q[i] == wanted;
  if (!result.complete) result.reason = limitText(joint, 0.0, wanted > joint.upper);
  return result;
}

JogResult jogTool(const JogRobot& robot, const std::vector<double>& q_now, const JogStep& step) {
  HAPTICELL_DEMAND(q_now.size() == robot.model.dof());
  const double share = std::max(glm::length(step.along) / kPieceLength, glm::length(step.turn) / kPieceTurn);
  const int pieces = static_cast<int>(std::clamp(std::ceil(share), 1.0, static_cast<double>(kMostPieces)));
  const Pose X_WT0 = tcpAt(robot, q_now);
  const Pose X_BW = robot.X_WB.inverse();
  JogResult result{q_now, true, {}};
  InverseSolution solution;
  for (int piece = 1; piece <= pieces; ++piece) {
    const double s = static_cast<double>(piece) / pieces;
    // Over the axes as they stood at the start: a tool's own axes do not turn away under the step.
    const Pose X_WT = jogged(X_WT0, robot.X_WB, {step.frame, s * step.along, s * step.turn, step.R_WF});
    robot.inverse.solveNearest(X_BW * X_WT, result.q, kUnboundedDuration, solution);
    double swing = 0.0;
    if (solution.q.size() == result.q.size()) fastest(result.q, solution.q, swing);
    const bool met = solution.position_error < kOffPosition && solution.orientation_error < kOffOrientation;
    if (!met || swing > kLargestSwing) {
      result.complete = false;
      result.reason = reasonAt(robot.model, result.q, solution);
      return result;
    }
    result.q = solution.q;
  }
  return result;
}

Text nearestLimitText(const RobotModel& model, const std::vector<double>& q, double near) {
  HAPTICELL_DEMAND(q.size() == model.dof());
  Text text;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = jointOf(model, i);
    const double to_lower = q[i] - joint.lower, to_upper = joint.upper - q[i];
    const double left = std::min(to_lower, to_upper);
    if (left > near) continue;
    near = left;
    text = limitText(joint, left, to_upper < to_lower);
  }
  return text;
}

Text limitText(const Joint& joint, double left, bool upper) {
  // degrees, mm: half of the last digit shown, so that no "0.0 from the limit" is read. Half, twice: it would be.
  constexpr double kShownDegrees = 0.05, kShownMillimetres = 0.05;
  const bool is_there = joint.type == JointType::kPrismatic ? left * 1000.0 < kShownMillimetres
                                                            : left * 180.0 / std::numbers::pi < kShownDegrees;
  if (is_there)
    return upper ? Text("%1 is at its upper limit", joint.name) : Text("%1 is at its lower limit", joint.name);
  return upper ? Text("%1 is %2 from its upper limit", joint.name, motionOf(joint, left))
               : Text("%1 is %2 from its lower limit", joint.name, motionOf(joint, left));
}

Text beyondLimitText(const Joint& joint, double over, bool upper) {
  return upper ? Text("%1 would be %2 over its upper limit", joint.name, motionOf(joint, over))
               : Text("%1 would be %2 under its lower limit", joint.name, motionOf(joint, over));
}

}  // namespace hapticell::kinematics
