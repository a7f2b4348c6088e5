// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "haptic/rendering/energy_account.h"
#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// What one tick of the force loop tells the meter. Device frame, SI.
struct MeteredTick {
  double t = 0.0;
  dvec3 force_D{0.0};               ///< Commanded, N.
  haptic::MetricVector coupling_D;  ///< What of it (and of the torque) is no load's: what is booked, N.
  haptic::MetricVector step_D;  ///< The stylus's way since the last tick, as measured, as seen from what it touches.
  double stiffness = 1000;      ///< Of the coupling, N/m.
};

/// Force, slew and energy over a session.
///
/// Energy: the worst fall of haptic::EnergyAccount's balance within a second (docs/dev/feel.md). What a held part's
/// weight and inertia do is no part of it.
class ForceMeter {
 public:
  /// `delay_ticks` of the device, where it is known.
  explicit ForceMeter(int delay_ticks = 0) : energy_(delay_ticks) {}
  void add(const MeteredTick& tick);
  double maxForce() const { return max_force_; }
  double maxStep() const { return max_step_; }            ///< N per ms.
  double leastEnergy() const { return energy_.worst(); }  ///< J, 0 or negative.

 private:
  bool started_ = false;
  MeteredTick last_;
  double max_force_ = 0.0, max_step_ = 0.0;
  haptic::EnergyLossMeter energy_;
};

/// One contact of two entities.
struct ContactEvent {
  workcell::EntityId entity = 0;
  workcell::EntityId other = 0;
  std::string moved_part, other_part;
  double time_in = 0.0, time_out = 0.0;
  double max_force = 0.0;
  bool open = true;
};

/// Which entities touched, when and how hard. Interruptions under 50 ms do not end a contact.
class ContactLog {
 public:
  void add(double t, const ManipulationEngine& engine, double force);
  void finish(double t);
  const std::vector<ContactEvent>& events() const { return events_; }

 private:
  std::vector<ContactEvent> events_;
  std::map<std::pair<workcell::EntityId, workcell::EntityId>, std::size_t> open_;
  std::map<std::size_t, double> last_seen_;
};

/// A limit that held the entity for a while.
struct LimitEvent {
  std::string text;  ///< As it was when it held first.
  LimitKind kind = LimitKind::kJoint;
  int joint = -1;
  double time_in = 0.0, time_out = 0.0;
};

/// Which limits held the entity, and when. Interruptions under 50 ms (or two steps) do not end one.
class LimitLog {
 public:
  void add(double t, const ManipulationEngine& engine);
  const std::vector<LimitEvent>& events() const { return events_; }

 private:
  std::vector<LimitEvent> events_;
  std::map<std::pair<LimitKind, int>, std::size_t> open_;
  double t_before_ = 0.0;
};

/// How far and how fast one joint moved while it was held.
struct JointUse {
  int joint = -1;  ///< Index among the robot's joints.
  double lowest = 0.0, highest = 0.0;
  double max_speed = 0.0;       ///< rad/s or m/s, from one step to the next.
  double greatest_speed = 0.0;  ///< Allowed.
};

/// Follows the joints of what is held from step to step.
class JointMeter {
 public:
  void add(double t, const ManipulationEngine& engine);
  const std::vector<JointUse>& joints() const { return joints_; }

 private:
  std::vector<JointUse> joints_;
  std::vector<double> before_;
  double t_before_ = 0.0;
  workcell::EntityId id_ = 0;
};

/// Measures how deep the shown entity is in anything, by exact distance queries of its own that share nothing with the
/// engine but the meshes.
class PenetrationMeter {
 public:
  /// Depth of the held entity now, m: 0 when it is free; else an upper bound (the shortest translation found that frees
  /// it).
  double measure(const ManipulationEngine& engine);
  double worst() const { return worst_; }
  /// Of pairs that must not pass through each other.
  double worstBlocked() const { return worst_blocked_; }

 private:
  double worst_ = 0.0, worst_blocked_ = 0.0, last_ = 0.0;
  workcell::EntityId measured_id_ = 0;
  EntityConfiguration measured_;
};

}  // namespace hapticell::manipulation
