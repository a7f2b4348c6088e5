// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/up_axis.h"

namespace hapticell::mannequin {

/// One frame of a recorded person in the world (Z up): the positions of the joints and the orientations of the
/// segments, with frames as in the figure (skeleton.h): X forward, Y left, Z up when standing; the hands hanging.
/// Arrays: left, right.
struct RecordedBody {
  dmat3 R_root{1.0}, R_thorax{1.0}, R_head{1.0};
  std::array<dmat3, 3> R_spine{};
  std::array<dmat3, 2> R_neck{}, R_hand{}, R_foot{};
  /// The direction in which knee and elbow bend, for straight limbs: the forward axis of the thigh and of the upper
  /// arm.
  std::array<dvec3, 2> thigh_forward{}, arm_forward{};
  dvec3 p_root{0.0};  ///< Midway between the hips.
  dvec3 neck{0.0};    ///< The neck's base.
  std::array<dvec3, 2> hip{}, knee{}, ankle{}, shoulder{}, elbow{}, hand{};
};

/// A recorded motion, independent of the program that recorded it.
struct RecordedMotion {
  std::vector<RecordedBody> bodies;  ///< One a frame.
  double frame_time = 0.0;           ///< s
  double metres_per_unit = 1.0;      ///< Of the file.
  UpAxis up = UpAxis::kZ;            ///< Of the file's axes.
  std::string marker_set;            ///< "Plug-in Gait", "Helen Hayes" or the table's name; empty for a skeleton.
  std::vector<Text> assumptions;     ///< What was found or assumed, one sentence each.
};

/// Information from the user that the file does not contain.
struct MotionReading {
  std::optional<UpAxis> up;       ///< If not given, found from the posture.
  std::filesystem::path markers;  ///< Of a C3D: a table of the user's own markers (marker_set.h).
};

/// The person in the clip of a skeleton. Only positions of joints are used: frames of segments are computed from their
/// child joints, from the rest position if that agrees with the motion, and from the motion as a whole; up is the
/// direction from feet to head. Assumptions are listed in `assumptions`. Errors: those of mapJoints(); legs without
/// length.
Expected<RecordedMotion> recordedMotion(const MotionClip& clip, const MotionReading& reading = {});

/// Chosen by the extension: .bvh, .amc next to its .asf, .c3d. Errors name the file.
Expected<RecordedMotion> readRecordedMotion(const std::filesystem::path& file, const MotionReading& reading = {});

}  // namespace hapticell::mannequin
