// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace hapticell::app {

/// A measured number for display: it changes only if the difference matters, so that noise in the last digit neither
/// distracts the user nor repaints the window. GUI thread.
class SteadyNumber {
 public:
  /// `share`: what it must differ by, as a part of the shown value; `least`: and by this much at the least.
  explicit SteadyNumber(double share, double least = 0.0) : share_(share), least_(least) {}
  /// The newest value; true when another one is shown from now on. Zero is never held back, nor what leaves it.
  /// `patience`: it must differ by so many times as much, where nobody watches it.
  bool take(double now, double patience = 1.0) {
    const bool same_sign = (now == 0.0) == (shown_ == 0.0);
    if (same_sign && std::abs(now - shown_) <= patience * std::fmax(share_ * std::abs(shown_), least_)) return false;
    shown_ = now;
    return true;
  }
  double shown() const { return shown_; }
  /// The patience while the stylus lies still: half of a rate, with 5 %. Half: an idle window repaints for rates;
  /// twice: never updated.
  static constexpr double kAtRest = 10.0;

 private:
  double share_, least_, shown_ = 0.0;
};

}  // namespace hapticell::app
