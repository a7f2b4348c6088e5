// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/hand_trail.h"
#include "manipulation/engine/plan_ride.h"
#include "manipulation/engine/plan_source.h"
#include "manipulation/holding/held_entity.h"
#include "trajectory/training/path_progress.h"

namespace hapticell::manipulation {

/// The way of a planner as one stylus feels it: a soft tube, with a gentle pull to a point a little ahead on the way.
///
/// The pull is a row of the constraint set (ConstraintKind::kPull), as the guidance of training; nothing holds the hand
/// in the tube. The *authority* (0 to 1) is the user's, times a share that falls to 0 where the hand insists: out of the
/// tube for half a second. The planner then gets the place where the hand pushes; with its answer the share comes back.
/// While the hand is in the tube the entity is carried on the way itself (PlanRide), as far as the authority says. Where
/// the hand may not move or turn it freely, it is only turned, as fast as the authority says.
///
/// A new way is not felt as a jump: the point that pulls runs to the new way at a limited speed, and the renderer takes
/// out what is left (haptic::PullBlend). Manipulation thread only.
class FeltPlan {
 public:
  /// What the window and the session show.
  struct State {
    std::shared_ptr<const PlannedWay> way;  ///< Null: none.
    double authority = 0.0;                 ///< The user's, 0 .. 1.
    double share = 0.0;                     ///< Of it, what the hand leaves to the planner now, 0 .. 1.
    bool insists = false;                   ///< The hand has left the tube and the planner has not answered yet.
    bool reached = false;                   ///< The entity is at the goal.
    std::uint64_t ways = 0;                 ///< Ways felt so far,
    std::uint64_t insistences = 0;          ///< and how often the hand insisted.
  };

  /// Sets the planner (null: none, nothing is felt) and the user's authority, limited to 0 .. 1.
  void set(std::shared_ptr<PlanSource> source, double authority);
  bool isOn() const { return source_ != nullptr; }
  /// Nothing is held any more, or something else: forgets the hand's way and what is felt.
  void forget();

  /// A step with `held` at its accepted configuration, before it follows the hand: tells the planner, takes its newest
  /// way, and moves the entity (`held`, `hand`). X_DS, X_DP: stylus and proxy. True: the newest set says something else
  /// by now.
  bool step(HeldEntity& held, HandMapping& hand, const Pose& X_DS, const Pose& X_DP, const CellState& cell);
  /// The hand has been anchored again: it and the entity are at the same place again.
  void anchored() { ride_.restart(); }
  /// Adds the pull to a set about the accepted configuration.
  void addTo(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping) const;

  const State& state() const { return state_; }

 private:
  void look(const HeldEntity& held, const CellState& cell, double scale);
  void adopt(const Pose& X_WM);
  void watchHand(const dvec3& p_WH, double scale, double dt);
  double aheadOn(double scale) const;
  dvec3 wantedPoint(double scale) const;
  void turn(const HeldEntity& held, HandMapping& hand, const Pose& X_DP, double dt) const;

  std::shared_ptr<PlanSource> source_;
  State state_;
  HandTrail trail_;
  trajectory::PathProgress progress_;
  PlanView view_;
  bool leads_ = false;      ///< There is a point that pulls.
  dvec3 p_WT_{0.0};         ///< It.
  PlanRide ride_;
  bool rides_ = false;      ///< The entity is carried on the way,
  double carried_ = 0.0;    ///< by so much of its motion, 0 to 1, in the last step.
  double outside_s_ = 0.0;  ///< s that the hand has been out of the tube.
};

/// m of hand: the radius of the soft tube, and how far ahead it pulls. Half of the first: a hand that only trembles
/// insists; twice: it must go 2 cm astray to be understood. Half of the second: half of the force; twice: corners are
/// cut by as much.
inline constexpr double kPlanTube = 0.010, kPlanLead = 0.015;

/// The three rows of the pull of a plan at this authority on the moved frame at X_WM towards p_WT, over the hand's xi.
std::array<haptic::Constraint, 3> planPull(const Pose& X_WM, const dvec3& p_WT, double authority,
                                           const MotionMapping& mapping);

}  // namespace hapticell::manipulation
