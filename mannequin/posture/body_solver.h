// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/posture/body_state.h"
#include "mannequin/posture/bounded_step.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::mannequin {

/// m that a rad of hand or foot counts, about the length of a hand. Half: hands turn away to reach farther; twice: they
/// stop short to keep their turn.
inline constexpr double kLever = 0.2;

/// A task with everything said: what the solver's iterations work towards.
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

/// How far a state is from a task.
struct TaskErrors {
  std::array<dvec3, 2> hand{}, hand_turn{};  ///< Wanted less present, m and rotation vector.
  std::array<double, 2> hand_position{}, hand_orientation{};
  double relative_position = 0.0, relative_orientation = 0.0;  ///< Of a held object.
  std::array<dvec3, 2> foot{}, foot_turn{};
  double foot_position = 0.0;
  double balance = 0.0;  ///< m inside the wanted margin; negative outside.
  dvec3 p_WCom{0.0};
  double merit = 0.0;  ///< Hands, and far heavier feet, held object and balance: m^2.

  bool solved() const;
};

/// How bold a step may be.
struct StepLimits {
  double turn = 0.6;     ///< rad in any joint
  double lambda = 1e-3;  ///< Regularisation of the hands' rows.
  double comfort = 0.0;  ///< Share of the way to comfort that is wished for per step.
  double slack = 1e-9;   ///< m^2 by which a step for comfort may raise the merit.
};

/// One state on its way to a task.
class BodySolver {
 public:
  BodySolver(const Figure& figure, const ResolvedTask& task) : figure_(&figure), task_(&task) {}

  void set(const BodyState& state);
  /// How much balance counts against the hands in the merit (both in m^2). On the way to a goal a little, else steps
  /// are refused that would get there; what is kept at the end needs the strict one.
  void setBalanceWeight(double weight) {
    balance_weight_ = weight;
    set(BodyState(state_));
  }
  /// Against 1 of the hands in the merit: balance goes before hands, a mm of it like 100 mm. Half, twice: no change
  /// seen in order; much less: figures lean out for what is far.
  static constexpr double kStrictBalance = 1e4;
  const BodyState& state() const { return state_; }
  const FigurePose& pose() const { return pose_; }
  const TaskErrors& errors() const { return errors_; }

  /// Steps until solved or `most` steps, each accepted only if the merit does not rise. With `impatient`, gives up when
  /// the merit has not fallen to a quarter after 8, 14, 20 steps. Counts into iterations().
  void run(int most, StepLimits limits, bool impatient);
  /// One accepted or refused step; false when it was refused.
  bool step(const StepLimits& limits);
  /// Puts hands that can be met exactly from the present trunk there, in closed form, elbows where they are.
  void finishArms();
  /// Binds the right hand to the left one exactly; false when the arm cannot.
  bool bindHeld();

  /// What the variables would do for a small motion of a hand, to first order; `axes` lists their rotation axes.
  Variables response(Side hand, const Twist& motion, VariableAxes& axes) const;

  int iterations() const { return iterations_; }
  /// Where another one's steps are to be counted too.
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

/// The segment that a variable turns (with everything it carries).
Segment segmentOfVariable(int variable);

/// Replaces legs by their closed form where that keeps the limits.
void placeFeet(const Figure& figure, const std::array<SegmentPlace, 2>& feet, BodyState& state);

/// The comfortable direction of all variables (dqc of the step), `share` of the way (docs/dev/mannequin.md).
void wishComfort(const Figure& figure, const ResolvedTask& task, const BodyState& state, const FigurePose& pose,
                 const VariableAxes& axes, double share, Variables& wish);

}  // namespace hapticell::mannequin
