// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <tuple>

#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/session/interval_tracker.h"

namespace hapticell::app {

/// An event between two entities while one of them was moved.
struct ContactEvent {
  enum class Kind { kNearMissBegan, kContactBegan, kContactEnded, kNearMissEnded };
  Kind kind = Kind::kContactBegan;
  double time_s = 0.0;  ///< Since the start of the loop.
  std::string moved, other;
  double distance = 0.0;    ///< m at that time; at an end: the smallest one during the event.
  double force_n = 0.0;     ///< On the hand at that time; at an end: the largest one during the event.
  double duration_s = 0.0;  ///< At an end only.
};

/// "Contact began", "Near miss ended" ...
std::string eventName(ContactEvent::Kind kind);

/// Derives events from snapshots, in the order of RobotStudio's collision sets: near miss begins, contact begins,
/// contact ends, near miss ends. An interruption shorter than kPause does not end a contact. Beyond kMost, the oldest
/// events are dropped and counted. A value; one thread; no Qt.
class ContactLog {
 public:
  /// s; an interruption shorter than this does not end a contact: hand tremor (8 to 12 Hz) interrupts it for less.
  /// Half: a held contact fills the log; twice: two knocks count as one.
  static constexpr double kPause = 0.15;
  /// Number of events kept, to limit memory. Half, twice: the oldest are dropped earlier or later.
  static constexpr std::size_t kMost = 5000;
  using Namer = std::function<std::string(workcell::EntityId, const std::string& part)>;

  /// Takes a snapshot; ignores one of the same time as the last. An older one starts the time of a new loop.
  void take(const manipulation::SceneSnapshot& snapshot, const Namer& name_of);
  const std::deque<ContactEvent>& events() const { return events_; }
  std::size_t dropped() const { return dropped_; }
  /// Number of events so far, including dropped ones.
  std::size_t count() const { return dropped_ + events_.size(); }
  void clear();

  /// The events as CSV: `t,event,moved,against,distance,force,duration` in s, m and N, `.` as decimal point.
  std::string csv() const;

 private:
  using Key = std::tuple<workcell::EntityId, std::string, workcell::EntityId, std::string>;
  struct State {
    std::string moved, other;
    double least_distance = 0.0, greatest_force = 0.0;
  };
  using Tracker = manipulation::IntervalTracker<Key, State>;
  struct Now {
    const manipulation::PairState* pair = nullptr;
    double time_s = 0.0, force_n = 0.0;
  };
  void follow(Tracker& tracker, const Key& key, const Now& now, const Namer& name_of, ContactEvent::Kind began);
  void endThose(Tracker& tracker, double time_s, bool all, ContactEvent::Kind ended);
  void add(ContactEvent event);
  std::deque<ContactEvent> events_;
  Tracker near_, touching_;
  std::size_t dropped_ = 0;
  double last_s_ = -1.0;
};

}  // namespace hapticell::app
