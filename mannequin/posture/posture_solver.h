// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/body/figure.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// An object held rigidly by both hands: where it is wanted, and where the hands hold it.
struct HeldObject {
  Pose X_WO;                 ///< Wanted.
  std::array<Pose, 2> X_OH;  ///< Left and right hand (frame H) in the object's frame.
};

/// What is asked of a posture.
struct PostureTask {
  std::array<std::optional<Pose>, 2> hands;        ///< Wanted poses X_WH of left and right hand (see handPose()).
  std::array<bool, 2> orientation = {true, true};  ///< False: only the wrist's place is wanted.
  std::optional<HeldObject> held;                  ///< Goes before `hands`.
  std::array<std::optional<Pose>, 2> feet;  ///< Where the feet (their segments' frames) stand; where the start has them
                                            ///< if not said.
  bool trunk_locked = false;                ///< Pelvis and spine do not move.
  bool pelvis_locked = false;               ///< The pelvis does not move.
  bool may_step = false;          ///< The feet may be put elsewhere when the hands cannot be met from where they are.
  bool balance = true;            ///< Keep the centre of mass over the soles.
  double balance_margin = 0.020;  ///< m inside the soles' edge.
  std::array<HandLoad, 2> loads = {};  ///< Carried; they count in the balance.
  int comfort_steps = 2;  ///< Steps that solve() takes towards comfort once the task is met; a recording of which only
                          ///< hands and feet are known wants some 60.
};

enum class PostureStatus {
  kSolved,      ///< Hands within 1 mm and 0.5 deg, feet within 0.3 mm, balance and all limits kept.
  kOutOfReach,  ///< The nearest posture that keeps limits, feet and balance; the errors say what is missing.
};

struct PostureResult {
  Posture posture;
  PostureStatus status = PostureStatus::kOutOfReach;
  std::array<double, 2> hand_position_error{};     ///< m; 0 for a hand that nothing is asked of.
  std::array<double, 2> hand_orientation_error{};  ///< rad
  double foot_displacement = 0.0;                  ///< m, of the worse foot from where it stood in the start.
  double balance_margin = 0.0;  ///< m that the centre of mass is inside the soles' edge; negative outside.
  dvec3 p_WCom{0.0};
  int iterations = 0;
  int tries = 0;  ///< Starting postures that were tried.
};

/// Finds postures: joint limits before feet before balance before hands before comfort.
///
/// A bounded quadratic step over 45 variables (root, spine, arms, legs) with closed-form arms and legs for the start
/// and the legs; the method and its figures are in docs/dev/mannequin.md. The same start and task give the same bits,
/// whatever was solved before: no state, no clock, no random numbers, no libm in the inner loop's sines. Const methods
/// may run in several threads; no allocation.
class PostureSolver {
 public:
  /// `figure` must outlive the solver.
  explicit PostureSolver(const Figure& figure) : figure_(&figure) {}

  /// Solves from any start; tries many starting postures where the first does not lead there.
  PostureResult solve(const PostureTask& task, const Posture& start) const;

  /// One tick of a drag (1 kHz): moves at most about 2 degrees in any joint towards the task, never worse than `from`.
  /// The posture's elbows swing, they never jump.
  PostureResult follow(const PostureTask& task, const Posture& from) const;

  /// One tick of letting go: trunk and pelvis go towards where they are comfortable, within all limits and by about 4
  /// degrees at most; the feet stay where the task has them, and hands that it names are not minded.
  PostureResult relax(const PostureTask& task, const Posture& from) const;

 private:
  const Figure* figure_;
};

}  // namespace hapticell::mannequin
