// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Lets through only samples of the stylus that a hand can have made. An encoder that slips, a cable that is struck or
/// a frame that is torn give a sample far off for one tick; the force loop must not answer it, nor remember it.
///
/// A sample that lies farther from the last one than kLeap and twice the way of the fastest tick of late is *refused*:
/// the last pose stands in for it. A second sample that agrees with a refused one is believed, so a true leap costs one
/// tick; but where no hand can have made the leap (over kJump) neither it nor what follows from there is believed, only
/// what comes back, until restart(): whoever asks stops the motors first. Distances are in the proxy's metric: a turn
/// counts with kRotationLever. Force loop's thread; never allocates, locks or throws.
class SampleGate {
 public:
  static constexpr double kLeap = 0.15e-3;  ///< m from rest in a millisecond: 300 m/s2, six times what motors can do.
  static constexpr double kJump = 2e-3;     ///< m in a millisecond: 2 m/s out of nothing.

  enum class Verdict : std::uint8_t { kFollows, kRefused };

  /// Whatever comes next is believed.
  void restart() { started_ = false; }
  /// A sample that is valid, `dt` s after the last one.
  Verdict judge(const Pose& X_DS, double dt);
  /// The newest pose that was believed.
  const Pose& believed() const { return believed_; }

 private:
  Verdict believe(const Pose& X_DS);

  bool started_ = false;
  Pose believed_;
  Pose refused_;  ///< The newest one.
  bool refusing_ = false;
  bool jumped_ = false;   ///< What was refused lies beyond what a hand can do.
  double speed_ = 0.0;    ///< m/s in the metric: the greatest of late.
  double elapsed_ = 0.0;  ///< s since `believed_`.
};

}  // namespace hapticell::haptic
