// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/device_profile.h"
#include "geometry/system/error.h"
#include "haptic/devices/hand_path.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/session/contact_tracker.h"
#include "manipulation/session/exercise.h"
#include "manipulation/session/joint_meter.h"
#include "manipulation/session/limit_tracker.h"
#include "manipulation/session/straight_hand.h"
#include "trajectory/motion/recorder.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// A hand that answers to what it feels, in place of a path. Virtual time only.
struct LiveHand {
  double duration_s = 0.0;  ///< Of the session.
  /// The hand at `t` (s), asked once a tick in the session's thread, given what the force loop gave in the tick before.
  std::function<haptic::HandSample(double t, const haptic::HapticState& felt)> at;
};

/// A whole session: a workcell, the moved entity, the motion of the hand, and all options.
struct SessionOptions {
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  std::vector<workcell::Guide> guides;
  std::string entity;  ///< Name of the entity that the first press of the button takes.
  haptic::HandPath hand{{haptic::HandSample{}}};
  std::optional<LiveHand> live_hand;  ///< Goes over `hand`.

  double rate_gui_hz = 60.0;
  double latency_s = 0.0;  ///< One way, virtual time only.
  config::DeviceProfile device;
  config::Configuration configuration;  ///< Its manipulation.rate_hz is the loop's rate, 10 .. 1000.

  MovedBy moved_by;
  AxesChoice axes;
  ScaleChoice scale;
  std::optional<workcell::OnContact> on_contact;
  std::optional<workcell::ForceClass> force_class;
  bool forces = true;
  command::SetFilter filter;

  std::optional<trajectory::RecordingOptions> recording;  ///< Records what is held, once per step of the loop.
  bool mark_by_button = false;  ///< The second button adds a frame by hand (else it is the clutch).
  /// Guidance along an expert's path (0 to 1), felt while the recording's entity is held.
  struct Training {
    Exercise exercise;
    trajectory::Trajectory expert;
    double help = 1.0;
  };
  std::optional<Training> training;
  /// A planner that works beside the hand, felt with this authority (0 to 1).
  struct Assistance {
    std::shared_ptr<PlanSource> planner;
    double authority = 1.0;
  };
  std::optional<Assistance> assistance;
  /// Virtual time only: this hand instead of the path `hand`, which then says only where the stylus begins and how long
  /// the session lasts at most; it ends half a second after the goal of `assistance` is reached.
  std::optional<StraightHandOptions> straight_hand;
  /// Gets each picture (`rate_gui_hz`) in the session's thread; may be empty. What it throws ends the session.
  std::function<void(const SceneSnapshot& picture)> picture;
};

/// One tick of the force loop, for --trace.
struct TraceRow {
  double t = 0.0;
  Pose X_DS;
  Pose X_DP;
  dvec3 force_D{0.0};   ///< Commanded, N.
  dvec3 torque_D{0.0};  ///< Commanded, N m; zero on a device without torque.
  std::uint32_t buttons = 0;
  bool contact = false;
  Pose X_WM;  ///< The moved frame of the held entity, as shown; identity if nothing is held.
  dvec3 pull_D{0.0};  ///< Part of it from pulls (of a plan) and loads, N; virtual time.
};
using TraceSink = std::function<void(const TraceRow&)>;

/// Delays in a session, ms.
struct SessionDelays {
  double step_median_ms = 0.0, step_p99_ms = 0.0, step_max_ms = 0.0;  ///< Machine time of a step.
  double latency_p50_ms = 0.0, latency_p99_ms = 0.0;  ///< From the query of a set to its use by the force loop.
};

/// The worst values for hand and parts in a session.
struct SessionForces {
  double force_max_n = 0.0, force_max_step_n_per_ms = 0.0;
  double penetration_blocked_m = 0.0;  ///< For pairs that must not pass through each other.
  double penetration_max_m = 0.0;
  double energy_min_j = 0.0;
};

/// What a planner beside the hand did in a session.
struct SessionPlan {
  std::uint64_t ways = 0;         ///< Ways that were felt.
  std::uint64_t insistences = 0;  ///< How often the hand insisted on another way.
  bool solved = false;            ///< The goal was reached,
  double solved_s = 0.0;          ///< and when.
  double pull_max_step_n_per_ms = 0.0;  ///< Of pulls and loads alone, at all times; virtual time only.
  /// Authority that acted: time (s) and value, each 0.1 s.
  std::vector<std::pair<double, double>> authority;
};

/// State at the end of a session.
struct SessionEnd {
  bool held = false;
  EntityConfiguration configuration;
  /// External axes by name, with their configuration; empty unless they moved along.
  std::vector<std::pair<std::string, EntityConfiguration>> axes;
  Pose X_WM;                          ///< The moved frame.
  std::vector<std::string> contacts;  ///< Names of what it touches.
  std::vector<std::string> limits;    ///< Why it does not follow, as in "A5 is at its upper limit".
};

/// Results of a session.
struct SessionReport {
  double duration_s = 0.0;
  double machine_time_s = 0.0;
  double rate_haptic_hz = 0.0, rate_manipulation_hz = 0.0, rate_gui_hz = 0.0;
  std::uint64_t ticks = 0, ticks_missed = 0, steps = 0;
  SessionDelays delays;
  SessionForces forces;
  std::vector<ContactInterval> contacts;
  std::vector<LimitInterval> limits;  ///< The entity's own limits that held it, in the order of their beginning.
  std::vector<JointUse> joints;       ///< One per variable of a robot; empty for others.
  std::vector<std::string> notices;
  SessionEnd end;
  std::optional<SessionPlan> plan;  ///< With assistance only.
  double training_share = 0.0;                           ///< Completed share of the expert's path.
  trajectory::Trajectory recording;                      ///< Without frames if not requested, or if nothing was moved.
  std::vector<trajectory::Trajectory> other_recordings;  ///< Of the entities that moved besides the chosen one, on its
                                                         ///< clock.
};

/// Runs a session in virtual time, in the caller's thread: force loop and simulated device at 1 ms, the manipulation
/// step and the frames at their rates, messages delayed by the latency. The same options give exactly the same report
/// (except for machine times). Errors: the entity or the frame does not exist, an unusable mesh. What `trace` or a live
/// hand throws ends the session and is thrown here.
Expected<SessionReport> runSession(const SessionOptions& options, const TraceSink& trace = {});

}  // namespace hapticell::manipulation
