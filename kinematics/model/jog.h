// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/text.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// The frame whose axes a Cartesian jog uses.
enum class JogFrame {
  kBase,   ///< The robot's root link.
  kTool,   ///< The frame of the tool centre point.
  kWorld,  ///< The cell.
  kGiven,  ///< Any other frame, with the orientation JogStep::R_WF.
};

/// One step of a jog of the tool centre point. Rotations are about the tool centre point, which keeps its position.
struct JogStep {
  JogFrame frame = JogFrame::kBase;
  dvec3 along{0.0};                ///< m, along the axes of the frame.
  dvec3 turn{0.0};                 ///< Rotation vector, rad, in the axes of the frame.
  dquat R_WF{1.0, 0.0, 0.0, 0.0};  ///< kGiven only: the axes, a unit quaternion.
};

/// Pose of the tool centre point, at X_WT before, after the step; the root link is at X_WB.
Pose jogged(const Pose& X_WT, const Pose& X_WB, const JogStep& step);

/// Result of a jog.
struct JogResult {
  std::vector<double> q;  ///< As far as possible: one per variable, within limits.
  bool complete = true;   ///< False if something stopped it.
  Text reason;            ///< The reason, if it is not complete: "A5 is at its upper limit".
};

/// Moves one variable by `amount` (rad or m), at most to its limit. `q_now` has one number a variable (contract).
JogResult jogJoint(const RobotModel& model, const std::vector<double>& q_now, int variable, double amount);

/// Moves the tool centre point from its pose at `q_now` along a straight step, in the present configuration.
///
/// The path is divided into pieces of at most 2 mm and 0.5 degrees, so that the arm never jumps to another
/// configuration. It ends before a piece that cannot be followed within 1 um and 1e-5 rad; the reason is the joint at
/// its limit, a wrist singularity (a joint would have to turn by more than 10 degrees in one piece) or the limit of the
/// reach. `inverse` is for `tip_link` of `model` with the tool centre point X_LT on it.
struct JogRobot {
  const RobotModel& model;
  const InverseModel& inverse;
  int tip_link = 0;
  Pose X_LT;
  Pose X_WB;
};
JogResult jogTool(const JogRobot& robot, const std::vector<double>& q_now, const JogStep& step);

/// "A5 is 1.2 deg from its upper limit", "Z is at its lower limit": the joint nearest to a limit at `q`; empty if no
/// joint is within `near` of one (rad; a metre of a slide counts as a radian).
Text nearestLimitText(const RobotModel& model, const std::vector<double>& q, double near);

/// "A5 is 1.2 deg from its upper limit", or "A5 is at its upper limit" within 0.05 deg (or mm).
Text limitText(const Joint& joint, double left, bool upper);

/// "A5 would be 12.3 deg over its upper limit".
Text beyondLimitText(const Joint& joint, double over, bool upper);

}  // namespace hapticell::kinematics
