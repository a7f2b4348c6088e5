// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/shapes/vector.h"

namespace hapticell::agents {

/// Recognises a deadlock: for one second the least remaining distance has not decreased and the moved frame has hardly
/// moved, or for five seconds it has moved without coming nearer.
class DeadlockWatch {
 public:
  /// s without progress at one place. Half: gives up while it turns round a corner; twice: a person has long seen it.
  static constexpr double kPatience = 1.0;
  /// s without progress while it moves. Half: a detour counts as a deadlock; twice: circles twice as long.
  static constexpr double kLongPatience = 5.0;
  /// m in that time that count as progress, or 0.5 % of the remaining way. Half: creeping goes on for long; twice: slow
  /// work near a surface counts as none.
  static constexpr double kLeastProgress = 1e-3, kLeastShare = 5e-3;
  /// m within which it counts as being at one place. Half: trembling counts as moving; twice: slow sliding as staying.
  static constexpr double kPlace = 0.01;

  /// At the time `t` (s): the place of the moved frame, and the remaining way (m, with turns at a lever). True once for
  /// each deadlock; then it begins to wait again.
  bool update(double t, const dvec3& p_WM, double remaining) {
    const bool nearer = remaining < least_ - std::max(kLeastProgress, kLeastShare * least_);
    if (nearer || least_ == std::numeric_limits<double>::infinity()) {
      least_ = remaining;
      nearer_at_ = t;
    }
    if (nearer || glm::length(p_WM - place_) > kPlace) {
      place_ = p_WM;
      moved_at_ = t;
    }
    if (t - std::max(nearer_at_, moved_at_) < kPatience && t - nearer_at_ < kLongPatience) return false;
    nearer_at_ = moved_at_ = t;
    return true;
  }
  /// An agent resolves the deadlock: the entity may first move back, for `patience` s.
  void restart(double t, double remaining, double patience) {
    least_ = remaining;
    nearer_at_ = moved_at_ = t + patience;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double nearer_at_ = 0.0, moved_at_ = 0.0;
  dvec3 place_{0.0};
};

}  // namespace hapticell::agents
