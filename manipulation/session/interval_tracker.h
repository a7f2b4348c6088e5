// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

namespace hapticell::manipulation {

/// s: interruptions up to this end no contact and no limit of a report; a hand that trembles at 20 Hz ends none. Half:
/// chattering contacts are several; twice: quick taps are one.
inline constexpr double kInterruption = 0.050;

/// Follows what holds for a while, by its key: contacts, limits, near misses. What is not seen for a moment goes on;
/// how long that moment may be is said where intervals are ended. A value; one thread.
template <typename Key, typename Data>
class IntervalTracker {
 public:
  struct Interval {
    double began = 0.0, seen = 0.0;  ///< s: at first, and the last time.
    Data data{};
  };

  /// Key holds at `t`: its interval, and whether it begins now (with new data).
  std::pair<Interval&, bool> see(const Key& key, double t) {
    const auto [at, begins] = open_.try_emplace(key);
    if (begins) at->second.began = t;
    at->second.seen = t;
    return {at->second, begins};
  }

  /// Ends those that were last seen more than `pause` before `t`, in the order of their keys.
  template <typename Ended>
  void endOlder(double t, double pause, const Ended& ended) {
    std::erase_if(open_, [&](const auto& entry) {
      if (t - entry.second.seen <= pause) return false;
      ended(entry.second);
      return true;
    });
  }
  void endOlder(double t, double pause) {
    endOlder(t, pause, [](const Interval&) {});
  }

  template <typename Ended>
  void endAll(const Ended& ended) {
    for (const auto& [key, interval] : open_) ended(interval);
    open_.clear();
  }

 private:
  std::map<Key, Interval> open_;
};

}  // namespace hapticell::manipulation
