// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace hapticell::app {

/// How long after it is felt a contact is on the screen, of the last contacts. Times in nanoseconds of any steady
/// clock, those of the contacts being of the same one.
class TouchMeter {
 public:
  /// The frame that is drawn now shows a contact that was felt then; 0: none. Each contact counts once, with the first
  /// frame that shows it.
  void drawn(std::int64_t felt_ns);
  /// What was drawn is on the screen.
  void shown(std::int64_t now_ns);
  /// Contacts that were felt before are not counted: nobody could see them.
  void skipBefore(std::int64_t now_ns) { counted_ns_ = now_ns; }

  struct Figures {
    std::size_t contacts = 0;  ///< That the others are of; 0: no contact yet.
    double last_s = 0.0, median_s = 0.0, worst_s = 0.0;
  };
  Figures figures() const;

 private:
  /// Contacts whose times are kept, for median and 90 %. Half: the 90 % is of five; twice: the past counts.
  static constexpr std::size_t kKept = 100;
  std::int64_t counted_ns_ = 0, waiting_ns_ = 0;
  std::deque<double> seconds_;
};

}  // namespace hapticell::app
