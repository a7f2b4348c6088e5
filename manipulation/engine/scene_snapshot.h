// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/text.h"
#include "haptic/protocol/link_problem.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/felt_plan.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/scene/pair_state.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// Present configuration of one entity, as drawn by the window. Never a penetrating pose.
struct EntityState {
  workcell::EntityId id = 0;
  Pose X_WE;
  std::vector<double> joints;
  bool in_contact = false;
  bool near_miss = false;
};

/// A limit that is near or holds the entity, and so explains why it does not follow.
struct LimitState {
  Text text;       ///< "A5 is 1.2 deg from its upper limit"
  int joint = -1;  ///< Index among the robot's joints; -1 if the limit is not a joint's.
  LimitKind kind = LimitKind::kJoint;
  double gap = 0.0;    ///< m that the moved frame can still move.
  bool holds = false;  ///< It limits the motion now.
};

/// One stylus and what it holds, for the window.
struct StylusState {
  bool connected = false;
  bool forces_on = false;
  bool device_fault = false;    ///< The device cannot be read or commanded; the force is zero.
  bool loop_stalled = false;    ///< The haptic server got no constraint set for 2 s and lets the force fade.
  workcell::EntityId held = 0;  ///< 0 if nothing is held.
  double force_ramp = 0.0;      ///< 0 .. 1.
  Pose X_WStylus;               ///< As drawn in the cell.
  Pose X_DS;                    ///< In its own workspace.
  dvec3 force_W{0.0};           ///< On the hand, N, mapped to the cell's axes.
  double force_n = 0.0;
  double motion_scale = 1.0;   ///< Metres in the cell per metre of hand motion.
  double device_edge_m = 0.0;  ///< To the edge of the device's workspace.
};

/// The data that the manipulation loop passes to the window each step: a value, the newest wins, no lock between the
/// loops.
struct SceneSnapshot {
  std::uint64_t step = 0;
  double time_s = 0.0;  ///< Since the start of the loop.
  std::vector<EntityState>
      entities;                  ///< Only those that differ from the document (the held entity and what moves with it).
  std::vector<PairState> pairs;  ///< Nearest first.
  std::vector<LimitState> limits;
  StylusState stylus;
  FeltPlan::State plan;  ///< The planner beside the stylus.
  bool clutched = false;
  bool stopped = false;     ///< A pair in mode *Stop* holds the entity.
  double free_gap_m = 0.0;  ///< Nearest free pair.
  double rate_manipulation_hz = 0.0, step_p99_ms = 0.0;
  /// When the newest contact was first felt, ns of this program's steady clock: the force loop's tick, converted to
  /// that clock. 0 before the first.
  std::int64_t felt_ns = 0;
  /// The loop is idle: nothing is held, forces are off, the stylus does not move. The rate is the last one before that.
  bool idle = false;
  haptic::ServerStatistics server;  ///< The newest figures of the haptic server.
  struct Recording {
    bool on = false;
    double seconds = 0.0;     ///< Duration so far.
    std::size_t frames = 0;   ///< Kept so far, of all entities.
    std::size_t by_hand = 0;  ///< Those of them added by the user.
  } recording;
  std::optional<StylusState> second;  ///< Set if there is a second stylus.
  haptic::LinkProblem problem;        ///< Why the stylus is not connected; empty if it is.
  /// The state of the held entity, in a sentence or two: "Gripper G2 is 6.4 mm from Clamp tower B", and the limit that
  /// holds it.
  std::vector<Text> status;
};

}  // namespace hapticell::manipulation
