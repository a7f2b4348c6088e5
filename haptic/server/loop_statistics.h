// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "haptic/protocol/messages.h"
#include "haptic/server/duration_histogram.h"

namespace hapticell::haptic {

/// The force loop's figures at one moment. A plain value.
struct LoopFigures {
  std::uint64_t ticks = 0;            ///< Done since the start.
  std::uint64_t missed = 0;           ///< Due but skipped since the start.
  double rate_hz = 0.0;               ///< Over the last second or so.
  DurationHistogram lateness;         ///< Wake-up past the deadline, since the start.
  DurationHistogram recent_lateness;  ///< The same, last 5 to 10 s.
  DurationHistogram recent_set_age;   ///< From a set's query to its adoption, last 5 to 10 s.
  std::uint64_t late_sets = 0;        ///< Adopted when older than kLateSetAge, since the start.
  std::uint64_t refused_sets = 0;     ///< Not adopted, since the start.
  std::uint64_t dropped_sets = 0;     ///< Adopted, but their numbers gave no valid proxy or force; since the start.
  std::uint64_t refused_samples = 0;  ///< Stylus samples that no hand can have caused; since the start.
};

/// Results of the controlling client's heart-beats, seconds.
struct LinkFigures {
  double round_trip = 0.0;             ///< The newest one; 0 without a client.
  std::optional<double> clock_offset;  ///< Offset from its clock to the server's; empty until measured.
};

/// Makes the statistics message from a loop's and a link's figures.
ServerStatistics statisticsOf(const LoopFigures& figures, const LinkFigures& link);

/// Counts events of the force loop and publishes figures ten times a second. Fixed memory, no allocation.
class LoopStatistics {
 public:
  explicit LoopStatistics(double rate_hz) noexcept;

  /// One tick was done at `now`, `late_ns` past its deadline, after `skipped` ones that were missed.
  void addTick(std::int64_t now, std::int64_t late_ns, std::uint32_t skipped) noexcept;
  /// A set was adopted `age_ns` after its query.
  void addSetAge(std::int64_t age_ns) noexcept;
  /// A set was not adopted; the one before stays in use.
  void addRefusedSet() noexcept { ++refused_sets_; }
  /// A set was adopted and then dropped: see RenderResult::dropped.
  void addDroppedSet() noexcept { ++dropped_sets_; }
  /// A sample of the stylus was refused: see SampleGate.
  void addRefusedSample() noexcept { ++refused_samples_; }

  /// True about ten times a second.
  bool due() const noexcept { return ticks_since_figures_ >= ticks_between_; }
  /// Fills `figures` (as of `now`) and starts the next tenth of a second.
  void collect(std::int64_t now, LoopFigures& figures) noexcept;

 private:
  struct Window {
    DurationHistogram lateness, set_age;
  };
  struct Mark {
    std::int64_t stamp = 0;
    std::uint64_t ticks = 0;
  };

  std::uint32_t ticks_between_;
  std::uint32_t ticks_since_figures_ = 0;
  std::uint64_t ticks_ = 0, missed_ = 0;
  std::uint64_t late_sets_ = 0, refused_sets_ = 0, dropped_sets_ = 0, refused_samples_ = 0;
  DurationHistogram lateness_;
  std::array<Window, 2> recent_{};  // Five seconds each; the older one is cleared when the newer is full.
  std::size_t newest_ = 0;
  std::int64_t window_start_ = 0;
  std::array<Mark, 10> marks_{};  // One at each collect(), for the rate.
  std::size_t next_mark_ = 0;
};

}  // namespace hapticell::haptic
