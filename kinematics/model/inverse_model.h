// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "kinematics/model/chain.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

enum class InverseStatus {
  kSolved,       ///< The tip is at the wanted pose.
  kLimit,        ///< Only joint limits prevent it.
  kUnreachable,  ///< No joint positions reach the pose, even without limits (or none were found).
};

/// `held`: limits hold the positions that were found.
constexpr InverseStatus statusOf(bool solved, bool held) {
  if (solved) return InverseStatus::kSolved;
  return held ? InverseStatus::kLimit : InverseStatus::kUnreachable;
}

/// "solved", "limit" or "unreachable", as files and the command line say it.
const char* toString(InverseStatus status);

/// Joint positions for a wanted pose of the tip, and how well they meet it.
struct InverseSolution {
  InverseStatus status = InverseStatus::kUnreachable;
  std::vector<double> q;           ///< One a variable of the model; those that do not move the tip as in the start.
  double position_error = 0.0;     ///< m
  double orientation_error = 0.0;  ///< rad, the angle between the two orientations.
  bool singular = false;  ///< A direction of the tip is (nearly) lost there, see Manipulability; solve() looks at it.
};

/// One of several answers for the same pose.
struct AlternativeSolution {
  std::vector<double> q;  ///< The turn of each joint that is nearest to the start, within limits where one is.
  bool within_limits = false;
  std::string configuration;  ///< What distinguishes it from the others, e.g. "front, elbow up, wrist flipped".
};

/// From a pose of the tip to joint positions. One object a chain; const methods may be called from any one thread.
class InverseModel {
 public:
  virtual ~InverseModel() = default;

  /// The class of the model: "numeric", "opw", "rail+ur" and so on; see describe() for serial chains.
  virtual std::string name() const = 0;

  /// The serial chain that it inverts; null for robots that are not serial chains.
  virtual const Chain* chain() const { return nullptr; }

  /// Indices of the variables that move the tip, from base to tip.
  virtual const std::vector<int>& variables() const = 0;

  /// One bounded shot from `q_start`, for the manipulation loop: no restarts, no jump to another configuration, no
  /// allocation once `solution.q` has its size.
  ///
  /// `X_BT` is the tool centre point in the root link. No variable leaves its limits or moves further than its velocity
  /// times `duration_s` (infinity: no such bound). Where the pose cannot be met (limits, reach, speed), the answer is
  /// the pose of least error from there, so it rests on the boundary and moves along it; see the class for the weights.
  /// The status then is kLimit when a limit holds it, else kUnreachable. A start outside the limits is first put on
  /// them.
  virtual void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                            InverseSolution& solution) const = 0;

  /// The solution nearest to `q_start`, however long it takes: kSolved whenever a solution within limits exists (for a
  /// numeric model: is found by all its restarts). Full turns are chosen nearest to `q_start`.
  virtual InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const = 0;

  /// All solutions (full turns counted once), nearest to `q_start` first; for a chain with more than six variables a
  /// sample of the infinitely many. Solutions outside the limits are included and marked.
  virtual std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const = 0;
};

/// For solveNearest(): no bound from joint speeds.
inline constexpr double kUnboundedDuration = std::numeric_limits<double>::infinity();

}  // namespace hapticell::kinematics
