// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

namespace hapticell::manipulation {

/// s; shorter interruptions end no contact and no limit in a report: a hand that trembles at 20 Hz ends none. Half: a
/// chattering contact counts as several; twice: quick taps count as one.
inline constexpr double kInterruption = 0.050;

/// Follows states that last for a while, by key: contacts, limits, near misses. A short absence does not end one; its
/// length is given where intervals are ended. A value; one thread.
template <typename Key, typename Data>
class IntervalTracker {
 public:
  struct Interval {
    double began = 0.0, seen = 0.0;  ///< s: start, and last time seen.
    Data data{};
  };

  /// `key` is present at `t`: returns its interval, and whether it begins now (with new data).
  std::pair<Interval&, bool> see(const Key& key, double t) {
    const auto [at, begins] = open_.try_emplace(key);
    if (begins) at->second.began = t;
    at->second.seen = t;
    return {at->second, begins};
  }

  /// Ends the intervals that were last seen more than `pause` before `t`, in the order of their keys.
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
