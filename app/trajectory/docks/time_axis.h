// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace hapticell::app {

/// Relates time to pixels, for the time bar and for the curves below it, so that they share the cursor. A value.
struct TimeAxis {
  double left = 0.0, right = 1.0;  ///< Pixels of the drawn range.
  double begin = 0.0, end = 1.0;   ///< Seconds at these pixels.

  double x(double t) const { return left + (t - begin) / (end - begin) * (right - left); }
  double t(double x) const { return begin + (x - left) / (right - left) * (end - begin); }
  double pixelsPerSecond() const { return (right - left) / (end - begin); }

  struct Tick {
    double t = 0.0;
    bool named = false;
  };
  /// Round times inside the range; those with a label are at least 60 pixels apart.
  std::vector<Tick> ticks() const;
  /// `factor` > 1 shows a shorter range around `t`; never less than 10 ms.
  TimeAxis zoomed(double factor, double t) const;
};

}  // namespace hapticell::app
