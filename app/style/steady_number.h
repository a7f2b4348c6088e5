// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace hapticell::app {

/// A measured number for display: it changes only if the difference matters, so that noise in the last digit neither
/// distracts the user nor repaints the window. GUI thread.
class SteadyNumber {
 public:
  /// `share`: the least visible difference as a fraction of the shown value; `least`: its minimum.
  explicit SteadyNumber(double share, double least = 0.0) : share_(share), least_(least) {}
  /// Takes the newest value; true if the shown value changes. A change to or from zero is always shown. `patience`:
  /// factor on the least difference, for times when nobody watches.
  bool take(double now, double patience = 1.0) {
    const bool same_sign = (now == 0.0) == (shown_ == 0.0);
    if (same_sign && std::abs(now - shown_) <= patience * std::fmax(share_ * std::abs(shown_), least_)) return false;
    shown_ = now;
    return true;
  }
  double shown() const { return shown_; }
  /// The patience while the stylus is at rest: with 5 %, half of a rate. Half: an idle window repaints for rates;
  /// twice: rates are never updated.
  static constexpr double kAtRest = 10.0;

 private:
  double share_, least_, shown_ = 0.0;
};

}  // namespace hapticell::app
