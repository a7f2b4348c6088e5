// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Passes only samples of the stylus that a hand can have caused. A slipping encoder, a knocked cable or a torn frame
/// gives a distant sample for one tick; the force loop must neither react to it nor store it.
///
/// A sample farther from the last one than kLeap plus twice the motion of the fastest recent tick is *refused*, and the
/// last pose is used instead. If a second sample agrees with the refused one, it is accepted, so a true leap costs one
/// tick. But if no hand can have made the leap (over kJump), neither that sample nor those near it are accepted, only
/// samples near the old pose, until restart(). Stop the motors before calling restart(). Distances are in the proxy's
/// metric: a rotation counts with kRotationLever. Force loop's thread; never allocates, locks or throws.
class SampleGate {
 public:
  /// m from rest in a millisecond: 300 m/s2, six times what motors can do. Half: a struck stylus is refused for a tick;
  /// twice: a wrong sample of 0.3 mm is answered with 0.3 N at 1 N/mm.
  static constexpr double kLeap = 0.15e-3;
  /// m in a millisecond: 2 m/s within one tick, which no hand can do. Half: a hard blow on the stylus counts as a jump
  /// and trips; twice: slipped encoders of up to 4 mm are believed after one tick.
  static constexpr double kJump = 2e-3;

  enum class Verdict : std::uint8_t { kFollows, kRefused };

  /// Accepts the next sample, whatever it is.
  void restart() { started_ = false; }
  /// Judges a valid sample, `dt` s after the last one.
  Verdict judge(const Pose& X_DS, double dt);
  /// The newest accepted pose.
  const Pose& believed() const { return believed_; }

 private:
  Verdict believe(const Pose& X_DS);

  bool started_ = false;
  Pose believed_;
  Pose refused_;  ///< The newest refused pose.
  bool refusing_ = false;
  bool jumped_ = false;   ///< The refused leap is beyond what a hand can do.
  double speed_ = 0.0;    ///< m/s in the metric: the recent maximum.
  double elapsed_ = 0.0;  ///< s since `believed_`.
};

}  // namespace hapticell::haptic
