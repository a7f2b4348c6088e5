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

/// `held`: limits constrain the positions that were found.
constexpr InverseStatus statusOf(bool solved, bool held) {
  if (solved) return InverseStatus::kSolved;
  return held ? InverseStatus::kLimit : InverseStatus::kUnreachable;
}

/// "solved", "limit" or "unreachable", as in files and on the command line.
const char* toString(InverseStatus status);

/// Joint positions for a requested pose of the tip, and their errors.
struct InverseSolution {
  InverseStatus status = InverseStatus::kUnreachable;
  std::vector<double> q;        ///< One per variable of the model; those that do not move the tip are as in the start.
  double position_error = 0.0;  ///< m
  double orientation_error = 0.0;  ///< rad, the angle between the two orientations.
  bool singular = false;  ///< The tip (nearly) cannot move in some direction there, see Manipulability; set by solve().
};

/// One of several solutions for the same pose.
struct AlternativeSolution {
  std::vector<double> q;  ///< Each joint at the full turn nearest to the start, within the limits if one is.
  bool within_limits = false;
  std::string configuration;  ///< What distinguishes it from the others, e.g. "front, elbow up, wrist flipped".
};

/// Computes joint positions from a pose of the tip. One object per chain; const methods may be called from any one
/// thread.
class InverseModel {
 public:
  virtual ~InverseModel() = default;

  /// The class of the model: "numeric", "opw", "rail+ur" and so on; see describe() for serial chains.
  virtual std::string name() const = 0;

  /// The serial chain of the model; null for robots that are not serial chains.
  virtual const Chain* chain() const { return nullptr; }

  /// Indices of the variables that move the tip, from base to tip.
  virtual const std::vector<int>& variables() const = 0;

  /// One bounded step from `q_start`, for the manipulation loop: no restarts, no jump to another configuration, no
  /// allocation once `solution.q` has its size.
  ///
  /// `X_BT` is the tool centre point in the root link. No variable leaves its limits or moves more than its velocity
  /// times `duration_s` (infinity: no such bound). If the pose cannot be met (limits, reach, speed), the answer is the
  /// pose with the least error near the start: it stays on the boundary and moves along it; see the class for the
  /// weights. The status is then kLimit if a limit is active, otherwise kUnreachable. A start outside the limits is
  /// first moved onto them.
  virtual void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                            InverseSolution& solution) const = 0;

  /// The solution nearest to `q_start`, without a limit on computing time: kSolved whenever a solution within limits
  /// exists (numeric model: if one of its restarts finds it). Full turns are chosen nearest to `q_start`.
  virtual InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const = 0;

  /// All solutions (full turns counted once), nearest to `q_start` first; for a chain with more than six variables, a
  /// sample of the infinitely many. Solutions outside the limits are included and marked.
  virtual std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const = 0;
};

/// For solveNearest(): no bound from joint speeds.
inline constexpr double kUnboundedDuration = std::numeric_limits<double>::infinity();

}  // namespace hapticell::kinematics
