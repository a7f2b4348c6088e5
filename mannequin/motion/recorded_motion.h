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

/// One moment of a recorded person in the world (Z up): where the joints are, and how the segments are turned, each
/// frame as the figure's own (skeleton.h): X forward, Y left, Z up when standing; the hands hanging. Arrays: left,
/// right.
struct RecordedBody {
  dmat3 R_root{1.0}, R_thorax{1.0}, R_head{1.0};
  std::array<dmat3, 3> R_spine{};
  std::array<dmat3, 2> R_neck{}, R_hand{}, R_foot{};
  /// Where knee and elbow bend to, for limbs that are straight: the thigh's and the upper arm's forward.
  std::array<dvec3, 2> thigh_forward{}, arm_forward{};
  dvec3 p_root{0.0};  ///< Midway between the hips.
  dvec3 neck{0.0};    ///< The neck's base.
  std::array<dvec3, 2> hip{}, knee{}, ankle{}, shoulder{}, elbow{}, hand{};
};

/// A recorded motion, whatever program recorded it.
struct RecordedMotion {
  std::vector<RecordedBody> bodies;      ///< One a frame.
  double frame_time = 0.0;               ///< s
  double metres_per_unit = 1.0;          ///< Of the file.
  UpAxis up = UpAxis::kZ;                ///< Of the file's axes.
  std::string marker_set;                ///< "Plug-in Gait", "Helen Hayes" or the table's name; empty for a skeleton.
  std::vector<Text> assumptions;  ///< What was found or taken where the file does not say, a sentence each.
};

/// What the user says of a file that does not say it itself.
struct MotionReading {
  std::optional<UpAxis> up;       ///< Else found from the posture.
  std::filesystem::path markers;  ///< Of a C3D: a table of the user's own markers (marker_set.h).
};

/// The person in a skeleton's clip. Only places of joints count: frames of segments are computed from their child
/// joints, from the rest position where that agrees with the motion, and from the motion on the whole; up is where the
/// head is over the feet. What was taken is said in `assumptions`. Errors: of mapJoints(); legs without length.
Expected<RecordedMotion> recordedMotion(const MotionClip& clip, const MotionReading& reading = {});

/// By the file's ending: .bvh, .amc next to its .asf, .c3d. Errors name the file.
Expected<RecordedMotion> readRecordedMotion(const std::filesystem::path& file, const MotionReading& reading = {});

}  // namespace hapticell::mannequin
