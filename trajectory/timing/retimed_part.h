// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/timing/frame_use.h"
#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/retiming.h"
#include "trajectory/timing/way_timing.h"

namespace hapticell::trajectory {

/// The first and last frame of a part of a motion.
struct MotionPiece {
  std::size_t first, last;
};

/// A copy of these frames with their joints.
Trajectory pieceOf(const Trajectory& trajectory, const MotionPiece& piece);

/// The error of a retiming that its options stopped.
Error retimingStopped();

/// A part of a motion from rest to rest on its path, with its timing and its frames at new times. One thread.
struct RetimedPart {
  Trajectory frames;         ///< As given.
  std::vector<double> ways;  ///< Way run at each of them.
  std::unique_ptr<MotionPath> path;
  WayTiming timing;
  std::size_t first = 0;       ///< Of the whole motion's frames.
  Trajectory samples, given;   ///< On the path, and on the given motion, at the same times.
  std::vector<double> places;  ///< Way run at each sample.

  /// Lays a path through the frames and times it. Errors: the options' stop is set; wayTimingOf().
  static Expected<RetimedPart> of(const Trajectory& motion, const MotionPiece& piece, const RetimingOptions& options,
                                  LimitedBy by);

  /// count + 1 samples, dt (s) apart, from the part's own time 0 on; rests at both ends are met to the last digit. Ends
  /// early where the options' stop is set.
  void sample(std::size_t count, double dt, const RetimingOptions& options);

  /// Given frames, by the whole motion's numbers, that the straight ways between the samples miss by more than the
  /// tolerance; the largest deviations go into `worst`.
  std::vector<std::size_t> missedFrames(const RetimingOptions& options, Deviation& worst) const;
};

}  // namespace hapticell::trajectory
