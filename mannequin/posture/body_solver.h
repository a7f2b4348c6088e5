// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/posture/body_state.h"
#include "mannequin/posture/bounded_step.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::mannequin {

/// m per rad of a hand or foot, about the length of a hand. Half: hands turn away to reach farther; twice: they stop
/// short to keep their orientation.
inline constexpr double kLever = 0.2;

/// A task with all defaults resolved: the target of the solver's iterations.
struct ResolvedTask {
  std::array<bool, 2> has_hand{};
  std::array<bool, 2> has_orientation{true, true};
  std::array<SegmentPlace, 2> hands{};
  bool held = false;           ///< The right hand is bound to the left one by X_LR.
  SegmentPlace left_to_right;  ///< R_LR, p_LR: the right hand in the left one's frame.
  std::array<SegmentPlace, 2> feet{};
  SupportPolygon support;
  bool trunk_locked = false, pelvis_locked = false, balance = true;
  double balance_margin = 0.020;
  std::array<HandLoad, 2> loads{};
};

ResolvedTask resolve(const Figure& figure, const PostureTask& task, const FigurePose& start);

/// The error of a state for a task.
struct TaskErrors {
  std::array<dvec3, 2> hand{}, hand_turn{};  ///< Target minus present, m and rotation vector.
  std::array<double, 2> hand_position{}, hand_orientation{};
  double relative_position = 0.0, relative_orientation = 0.0;  ///< Of a held object.
  std::array<dvec3, 2> foot{}, foot_turn{};
  double foot_position = 0.0;
  double balance = 0.0;  ///< m inside the wanted margin; negative outside.
  dvec3 p_WCom{0.0};
  double merit = 0.0;  ///< Hands, and with far greater weight feet, held object and balance: m^2.

  bool solved() const;
};

/// Step size of the solver.
struct StepLimits {
  double turn = 0.6;     ///< rad in any joint
  double lambda = 1e-3;  ///< Regularisation of the hands' rows.
  double comfort = 0.0;  ///< Share of the remaining distance to comfort per step.
  double slack = 1e-9;   ///< m^2 by which a step for comfort may raise the merit.
};

/// One state on its way to a task.
class BodySolver {
 public:
  BodySolver(const Figure& figure, const ResolvedTask& task) : figure_(&figure), task_(&task) {}

  void set(const BodyState& state);
  /// Weight of balance relative to the hands in the merit (both in m^2). A little during the search, because otherwise
  /// necessary steps are refused; the final result needs the strict one.
  void setBalanceWeight(double weight) {
    balance_weight_ = weight;
    set(BodyState(state_));
  }
  /// Weight relative to 1 of the hands in the merit: balance has priority, one mm of it counts like 100 mm. Half,
  /// twice: no change of the order seen; much less: figures lean out to distant targets.
  static constexpr double kStrictBalance = 1e4;
  const BodyState& state() const { return state_; }
  const FigurePose& pose() const { return pose_; }
  const TaskErrors& errors() const { return errors_; }

  /// Steps until solved or `most` steps, each accepted only if the merit does not rise. With `impatient`, gives up if
  /// the merit has not fallen to a quarter after 8, 14, 20 steps. Adds to iterations().
  void run(int most, StepLimits limits, bool impatient);
  /// One step; false if it was refused.
  bool step(const StepLimits& limits);
  /// Places hands that can be reached exactly from the present trunk, in closed form, with unchanged elbows.
  void finishArms();
  /// Couples the right hand to the left one exactly; false if the arm cannot.
  bool bindHeld();

  /// The motion of the variables for a small motion of a hand, to first order; `axes` lists their rotation axes.
  Variables response(Side hand, const Twist& motion, VariableAxes& axes) const;

  int iterations() const { return iterations_; }
  /// Where the steps of another solver are also counted.
  void count(int iterations) { iterations_ = iterations; }

 private:
  void measure();
  void fillProblem(const VariableAxes& axes, const StepLimits& limits, StepProblem& problem) const;
  void fillBounds(const VariableAxes& axes, const StepLimits& limits, StepProblem& problem) const;
  void fillHands(const VariableAxes& axes, double lambda, StepProblem& problem) const;
  void fillFeet(const VariableAxes& axes, StepProblem& problem) const;
  void fillBalance(const VariableAxes& axes, StepProblem& problem) const;

  const Figure* figure_;
  const ResolvedTask* task_;
  BodyState state_;
  FigurePose pose_;
  TaskErrors errors_;
  ActiveSet active_{};
  double balance_weight_ = 1e2;
  int iterations_ = 0;
};

/// The segment that a variable turns (with everything attached to it).
Segment segmentOfVariable(int variable);

/// Replaces legs by their closed form if that keeps the limits.
void placeFeet(const Figure& figure, const std::array<SegmentPlace, 2>& feet, BodyState& state);

/// The comfortable direction of all variables (dqc of the step), for a `share` of the distance (docs/dev/mannequin.md).
void wishComfort(const Figure& figure, const ResolvedTask& task, const BodyState& state, const FigurePose& pose,
                 const VariableAxes& axes, double share, Variables& wish);

}  // namespace hapticell::mannequin
