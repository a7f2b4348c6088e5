// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/closed_form/span.h"
#include "kinematics/kernels/kernels.h"

namespace hapticell::kinematics {

/// Proves for a seven-axis arm and one pose that no joint positions within limits reach it, by intervals over what the
/// pose leaves free: the triangle of shoulder, elbow and wrist, then each joint that it fixes.
///
/// A value; no heap, thread-safe. The closed form is that of kernels/seven_lanes.h, whose letters are used.
class SevenReach {
 public:
  /// Plain data, read while the object lives: `arm`, `bounds` (rad) and `pose` in the arm's canonical frames. `srs`:
  /// the free parameter is the swivel (rad), otherwise joint 7.
  SevenReach(const kernels::SevenArm& arm, const kernels::JointBounds& bounds, const kernels::ArmPose& pose, bool srs);

  /// True: proven that nothing within limits has the free parameter in `from` to `to`, by halves. False: not decided.
  bool provesNone(double from, double to) const;

 private:
  struct Directions {
    Span x, y, z;
  };

  const kernels::SevenArm& arm_;
  const kernels::JointBounds& bounds_;
  const kernels::ArmPose& pose_;
  bool srs_;
  double L1_ = 0.0, L2_ = 0.0, at_shoulder_ = 0.0, at_wrist_ = 0.0;

  bool excludes(const Span& piece) const { return srs_ ? excludesSwivel(piece) : excludesLast(piece); }
  bool mayBe(int joint, const Span& theta) const;
  bool shoulderMayBe(const Span& theta_1, const Span& theta_2, const Span& theta_3) const;
  bool excludesLast(const Span& q_7) const;
  bool excludesElbow(const Span& theta_7, const Directions& wrist, double bend, const Span& between) const;
  bool excludesWrist(const Span& theta_7, const Directions& wrist, const Span& theta_4, const Span& wx, const Span& wz,
                     double side) const;
  bool excludesSwivel(const Span& swivel) const;
};

}  // namespace hapticell::kinematics
