// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

// Edits of a motion. Each gives a copy; what is given is never changed. Times of a copy begin at 0 unless said. Frames
// that stay keep what was recorded with them (channels, touches); new frames do not have it.
//
// Where an edit puts the moved frame somewhere else, a robot's joints cannot be known here: the result has none
// (`joints_lost`), and manipulation/checks/motion_replay.h finds them again by the inverse model.

/// The motion from `t0` to `t1` (s of the trajectory), its ends interpolated. Errors: nothing of it lies between.
Expected<Trajectory> trimmed(const Trajectory& trajectory, double t0, double t1);

/// Before and after `t`; both contain the place at `t`. Errors: `t` is not between the first and the last frame.
Expected<std::pair<Trajectory, Trajectory>> splitAt(const Trajectory& trajectory, double t);

/// One after the other. Between the end of one and the beginning of the next the frame goes straight, in the time it
/// takes at `speed` (m/s; turning counts 0.1 m/rad), at least 1 ms. Errors: fewer than two, other entities or joints.
Expected<Trajectory> joined(std::span<const Trajectory> parts, double speed = 0.1);

/// Every `step` seconds a frame, times as recorded; frames set by hand stay besides. Errors: a step that is not
/// positive, no frames, more than ten million of them.
Expected<Trajectory> resampled(const Trajectory& trajectory, double step);

/// Backwards in time.
Trajectory reversed(const Trajectory& trajectory);

/// Mirrored on the plane through `p_W` with normal `nhat_W`: as a partner on the other side would do it. Positions are
/// reflected; the frame's own x axis is turned round besides, so that it stays right-handed. Joints are lost.
Trajectory mirrored(const Trajectory& trajectory, const dvec3& p_W, const dvec3& nhat_W);

/// The whole motion somewhere else: X_WN * X_WT. Joints are lost.
Trajectory transformed(const Trajectory& trajectory, const Pose& X_WN);

/// A frame by hand at `t`; between its neighbours it needs no more time than they leave, before and after the motion
/// the motion grows. Joints are lost. Errors: there is a frame within 1 ms of it.
Expected<Trajectory> withFrame(const Trajectory& trajectory, double t, const Pose& X_WT);

/// Frame `i` at another place, set by hand; the frames within `reach` seconds of it go along, less the farther away (by
/// a smooth bell), so that a dense recording bends and does not break. Joints are lost. Errors: no such frame.
Expected<Trajectory> withFrameAt(const Trajectory& trajectory, std::size_t i, const Pose& X_WT, double reach);

/// Without frames `first` to `last`. Errors: no such frames, or none would be left.
Expected<Trajectory> withoutFrames(const Trajectory& trajectory, std::size_t first, std::size_t last);

/// Waits `seconds` (0: goes through) at frame `i`, where a program does its work. Errors: no such frame, negative time.
Expected<Trajectory> withDwell(const Trajectory& trajectory, std::size_t i, double seconds);

/// Frame `i` with a name, or with none (empty). Errors: no such frame, a name that does not fit one line of 200 bytes,
/// or that another frame has.
Expected<Trajectory> withName(const Trajectory& trajectory, std::size_t i, const std::string& name);

/// Frame `from` at place `to` of the order; all others keep theirs. Frames keep pose, joints, wait and name. Ways that
/// stay take the time they took, also turned round; a new one goes at the motion's average speed (turning counts
/// 0.1 m/rad), at least 1 ms. What was recorded besides (channels, touches) is left out. Errors: no such frames.
Expected<Trajectory> withFrameMoved(const Trajectory& trajectory, std::size_t from, std::size_t to);

/// A straight way to the first frame or from the last one.
struct StraightWay {
  double length = 0.05;               ///< m, above 0.
  dvec3 direction_T{0.0, 0.0, -1.0};  ///< Of the far end as seen from the motion, in the moved frame's own axes.
  double speed = 0.1;                 ///< m/s, above 0.
};
/// With an approach before it (times of the motion are later by its time), or a retract after it. Joints are lost.
Expected<Trajectory> withApproach(const Trajectory& trajectory, const StraightWay& way);
Expected<Trajectory> withRetract(const Trajectory& trajectory, const StraightWay& way);

}  // namespace hapticell::trajectory
