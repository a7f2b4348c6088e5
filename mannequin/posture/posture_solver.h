// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/body/figure.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// An object held rigidly by both hands: its target and how the hands hold it.
struct HeldObject {
  Pose X_WO;                 ///< Target.
  std::array<Pose, 2> X_OH;  ///< Left and right hand (frame H) in the object's frame.
};

/// Requirements on a posture.
struct PostureTask {
  std::array<std::optional<Pose>, 2> hands;        ///< Target poses X_WH of left and right hand (see handPose()).
  std::array<bool, 2> orientation = {true, true};  ///< False: only the position of the wrist matters.
  std::optional<HeldObject> held;                  ///< Overrides `hands`.
  /// Poses of the feet (the frames of their segments); if not given, those of the start.
  std::array<std::optional<Pose>, 2> feet;
  bool trunk_locked = false;   ///< Pelvis and spine do not move.
  bool pelvis_locked = false;  ///< The pelvis does not move.
  bool may_step = false;  ///< The feet may be moved if the hands cannot reach their targets from the present place.
  bool balance = true;    ///< Keep the centre of mass over the soles.
  double balance_margin = 0.020;       ///< m inside the soles' edge.
  std::array<HandLoad, 2> loads = {};  ///< Carried loads; they count in the balance.
  /// Steps of solve() towards comfort once the task is met; a recording with only hands and feet needs about 60.
  int comfort_steps = 2;
};

enum class PostureStatus {
  kSolved,      ///< Hands within 1 mm and 0.5 deg, feet within 0.3 mm, balance and all limits kept.
  kOutOfReach,  ///< The nearest posture that keeps limits, feet and balance; the errors give the remaining distance.
};

struct PostureResult {
  Posture posture;
  PostureStatus status = PostureStatus::kOutOfReach;
  std::array<double, 2> hand_position_error{};     ///< m; 0 for a hand without target.
  std::array<double, 2> hand_orientation_error{};  ///< rad
  double foot_displacement = 0.0;                  ///< m, of the worse foot from its place in the start.
  double balance_margin = 0.0;  ///< m that the centre of mass is inside the soles' edge; negative outside.
  dvec3 p_WCom{0.0};
  int iterations = 0;
  int tries = 0;  ///< Starting postures that were tried.
};

/// Finds postures, with priorities in this order: joint limits, feet, balance, hands, comfort.
///
/// A bounded quadratic step over 45 variables (root, spine, arms, legs) with closed-form arms and legs for the start
/// and the legs; the method and its figures are in docs/dev/mannequin.md. The same start and task give the same bits,
/// independent of earlier calls: no state, no clock, no random numbers, no libm in the sines of the inner loop. Const
/// methods are thread-safe; no allocation.
class PostureSolver {
 public:
  /// `figure` must outlive the solver.
  explicit PostureSolver(const Figure& figure) : figure_(&figure) {}

  /// Solves from any start; tries many starting postures if the first does not succeed.
  PostureResult solve(const PostureTask& task, const Posture& start) const;

  /// One tick of a drag (1 kHz): moves at most about 2 degrees in any joint towards the task, never worse than `from`.
  /// The elbows of the posture swing without jumps.
  PostureResult follow(const PostureTask& task, const Posture& from) const;

  /// One tick after release: trunk and pelvis move towards their comfortable position, within all limits and by about 4
  /// degrees at most; the feet stay at the places of the task, and its hands are ignored.
  PostureResult relax(const PostureTask& task, const Posture& from) const;

 private:
  const Figure* figure_;
};

}  // namespace hapticell::mannequin
