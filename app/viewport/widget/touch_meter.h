// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace hapticell::app {

/// Delay from feeling a contact to its picture on the screen, for the last contacts. Times in nanoseconds of any steady
/// clock, the same for contacts and frames.
class TouchMeter {
 public:
  /// The frame being drawn shows a contact that was felt at this time; 0: none. Each contact counts once, with the
  /// first frame that shows it.
  void drawn(std::int64_t felt_ns);
  /// The drawn frame is on the screen.
  void shown(std::int64_t now_ns);
  /// Ignores contacts that were felt before this time: they could not be seen.
  void skipBefore(std::int64_t now_ns) { counted_ns_ = now_ns; }

  struct Figures {
    std::size_t contacts = 0;  ///< Number of contacts in the other values; 0: none yet.
    double last_s = 0.0, median_s = 0.0, worst_s = 0.0;
  };
  Figures figures() const;

 private:
  /// Contacts whose times are kept, for median and 90 %. Half: 90 % rests on five contacts; twice: the past counts.
  static constexpr std::size_t kKept = 100;
  std::int64_t counted_ns_ = 0, waiting_ns_ = 0;
  std::deque<double> seconds_;
};

}  // namespace hapticell::app
