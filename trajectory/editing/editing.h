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

// Edits of a motion. Each returns a copy; the input is never changed. The times of a copy begin at 0 unless stated
// otherwise. Frames that are kept retain their recorded data (channels, touches); new frames have none.
//
// If an edit changes the pose of the moved frame, the robot's joints are unknown here: the result has no joints
// (`joints_lost`), and manipulation/checks/motion_replay.h computes them again with the inverse model.

/// The part of the motion from `t0` to `t1` (s, trajectory time); both ends are interpolated. Errors: the motion does
/// not cover any of this interval.
Expected<Trajectory> trimmed(const Trajectory& trajectory, double t0, double t1);

/// Splits at `t`; both parts contain the pose at `t`. Errors: `t` is not between the first and the last frame.
Expected<std::pair<Trajectory, Trajectory>> splitAt(const Trajectory& trajectory, double t);

/// Joins motions in order. Between the end of one and the start of the next, the frame moves in a straight line at
/// `speed` (m/s; rotation counts 0.1 m/rad), for at least 1 ms. Errors: fewer than two motions, or different entities
/// or joints.
Expected<Trajectory> joined(std::span<const Trajectory> parts, double speed = 0.1);

/// One frame every `step` seconds, at unchanged speed; frames set by hand are kept in addition. Errors: `step` is not
/// positive, no frames, more than ten million frames.
Expected<Trajectory> resampled(const Trajectory& trajectory, double step);

/// The motion in reverse.
Trajectory reversed(const Trajectory& trajectory);

/// Mirrored at the plane through `p_W` with normal `nhat_W`, as a partner on the opposite side would perform it.
/// Positions are reflected; the x axis of the frame is also flipped so that the frame stays right-handed. Joints are
/// lost.
Trajectory mirrored(const Trajectory& trajectory, const dvec3& p_W, const dvec3& nhat_W);

/// The whole motion moved rigidly: X_WN * X_WT. Joints are lost.
Trajectory transformed(const Trajectory& trajectory, const Pose& X_WN);

/// Inserts a frame set by hand at `t`. Times of the neighbours do not change; before the start or after the end, the
/// motion becomes longer. Joints are lost. Errors: there is already a frame within 1 ms of `t`.
Expected<Trajectory> withFrame(const Trajectory& trajectory, double t, const Pose& X_WT);

/// Moves frame `i` to another pose, as set by hand. Frames within `reach` seconds follow, less the farther away they
/// are (by a smooth bell curve), so that a dense recording bends without a kink. Joints are lost. Errors: no such
/// frame.
Expected<Trajectory> withFrameAt(const Trajectory& trajectory, std::size_t i, const Pose& X_WT, double reach);

/// Deletes frames `first` to `last`. Errors: no such frames, or no frame would remain.
Expected<Trajectory> withoutFrames(const Trajectory& trajectory, std::size_t first, std::size_t last);

/// Sets a dwell of `seconds` (0: no stop) at frame `i`, where a program does its work. Errors: no such frame, negative
/// time.
Expected<Trajectory> withDwell(const Trajectory& trajectory, std::size_t i, double seconds);

/// Sets the name of frame `i`; an empty name removes it. Errors: no such frame, a name that is not a single line of at
/// most 200 bytes, or that another frame already has.
Expected<Trajectory> withName(const Trajectory& trajectory, std::size_t i, const std::string& name);

/// Moves frame `from` to index `to`; the order of the others does not change. Frames keep their pose, joints, dwell and
/// name. Segments that still exist keep their duration, also when reversed; a new segment is run at the average speed
/// of the motion (rotation counts 0.1 m/rad), for at least 1 ms. Recorded data (channels, touches) is dropped. Errors:
/// no such frames.
Expected<Trajectory> withFrameMoved(const Trajectory& trajectory, std::size_t from, std::size_t to);

/// A straight approach to the first frame or retract from the last one.
struct StraightWay {
  double length = 0.05;               ///< m, above 0.
  dvec3 direction_T{0.0, 0.0, -1.0};  ///< Towards the far end, in the axes of the moved frame.
  double speed = 0.1;                 ///< m/s, above 0.
};
/// Adds an approach at the start (all times of the motion shift by its duration) or a retract at the end. Joints are
/// lost.
Expected<Trajectory> withApproach(const Trajectory& trajectory, const StraightWay& way);
Expected<Trajectory> withRetract(const Trajectory& trajectory, const StraightWay& way);

}  // namespace hapticell::trajectory
