// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/session/force_extremes.h"
#include "manipulation/session/penetration_meter.h"
#include "manipulation/session/session.h"

namespace hapticell::manipulation {

/// The engine with everything that a session watches about it; sessions in virtual time and sessions on a server drive
/// one each. Frames and units as in SessionReport; times in s from the session's begin. One thread.
class WatchedEngine {
 public:
  /// Both must outlive it.
  WatchedEngine(haptic::HapticLink& link, const SessionOptions& options);

  /// The planner beside the hand searches in a thread of its own: before prepare().
  void searchInThread() { engine_.searchInThread(); }

  /// Sets all choices; errors are reported before the session begins: no such entity or frame, an entity that cannot be
  /// held or moved so.
  Expected<void> prepare();

  /// One step of the loop at the time t; `now_ns` by the clock of the link.
  void step(double t, std::int64_t now_ns);
  /// What a window would draw, and the penetration then.
  void showPicture(double t);
  void count(const MeteredTick& tick) { forces_.add(tick); }
  /// The report so far, with the state at the end: once.
  SessionReport finish(double duration);

  /// When the set of this number was sent, s; negative for one that was not.
  double sentAt(std::uint64_t sequence) const;
  const std::optional<haptic::HapticState>& state() const { return engine_.hapticState(); }
  const haptic::ServerStatistics& serverStatistics() const { return engine_.serverStatistics(); }
  /// The goal of the planner beside the hand was reached half a second ago.
  bool isSolved(double t) const;
  bool inContact() const { return !engine_.contacts().empty(); }
  /// Identity while nothing is held.
  Pose movedFrame() const { return engine_.held() ? engine_.held()->movedFrame() : Pose::identity(); }

 private:
  Expected<std::shared_ptr<HeldEntity>> tryHold();
  void lead();
  void notePlan(double t);
  void noteEnd();
  void takeRecordings();
  void measurePenetration(double t);

  const SessionOptions& options_;
  ManipulationEngine engine_;
  workcell::EntityId entity_ = 0;
  std::shared_ptr<HeldEntity> start_;
  std::optional<TrainingRun> training_;
  SessionReport report_;
  ForceExtremes forces_;
  ContactTracker contacts_;
  LimitTracker limits_;
  JointMeter joints_;
  PenetrationMeter penetration_;
  SceneSnapshot snapshot_;
  std::vector<double> times_;
  std::vector<double> sent_;  ///< By the set's number less one, s.
  std::uint64_t pictures_ = 0;
  double measured_ = -1.0;
};

}  // namespace hapticell::manipulation
