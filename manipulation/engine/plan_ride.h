// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/plan_source.h"
#include "manipulation/holding/held_entity.h"
#include "trajectory/training/path_progress.h"

namespace hapticell::manipulation {

/// Carries the held entity on the way of a planner, configuration by configuration, as far along as the hand has come:
/// what the planner has found free is what is moved through, with the joints or the posture of the plan.
///
/// The hand's anchor goes along, so that the hand may wander beside the way without leading the entity off it. What of
/// the hand's motion moves the entity is 1 minus the authority. Where the hand presses, the entity moves so slowly that
/// forces change by little. Every motion is checked (HeldEntity::goTo). Manipulation thread only.
class PlanRide {
 public:
  struct Step {
    double authority = 0.0;  ///< 0 to 1, with the share that the hand leaves.
    double dt = 0.0;         ///< s of this step.
    bool pressed = false;    ///< The hand presses against something.
    Pose X_DS;               ///< The stylus: a hand that presses along the way is ahead on it too.
    double agrees = 0.0;     ///< 0 to 1: how far the hand gives way to the pull, so that the way goes on without it.
  };

  /// The entity and the hand are at the same place again, and on no way.
  void restart() { shift_W_ = dvec3(0.0), held_up_s_ = 0.0; }
  /// Whether the hand moves the entity freely, and the way says where all of it goes.
  static bool carries(const HeldEntity& held, const PlannedWay& way, const MotionMapping& mapping);

  /// Where the hand alone would have the moved frame, m, world. X_DP: the proxy.
  dvec3 handAt(const MotionMapping& mapping, const Pose& X_DP) const { return mapping.toCell(X_DP).p + shift_W_; }
  /// From the moved frame to there, m, world.
  const dvec3& shift_W() const { return shift_W_; }
  /// Something has kept the entity off the way for a while.
  bool strays() const;

  /// @pre carries()
  void step(HeldEntity& held, HandMapping& hand, const Pose& X_DP, const PlannedWay& way,
            trajectory::PathProgress& progress, const Step& now);

 private:
  dvec3 shift_W_{0.0};
  double held_up_s_ = 0.0;  ///< s that something has kept it off the way.
};

/// While the hand's motion moves the entity by 1 - `authority` of it only, contacts and limits are as much farther for
/// the hand, at `scale` (m of the cell a metre of hand). Those that truly touch stay, and so do those that nothing but
/// their row keeps apart.
void easeContacts(BuiltConstraints& built, const HeldEntity& held, double scale, double authority);

/// The direction of a way at a place (m of its length), unit; zero where the whole way only turns.
dvec3 directionOf(const trajectory::PathProgress& progress, double way);

}  // namespace hapticell::manipulation
