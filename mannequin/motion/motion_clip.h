// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::mannequin {

/// One joint of a recorded skeleton. The orientation of its frame at rest depends on the recording program: only the
/// positions of joints are used from a clip (body_frames.h).
struct ClipJoint {
  std::string name;
  int parent = -1;      ///< Index of its parent; -1 for the root.
  dvec3 p_Parent{0.0};  ///< In the parent's frame, m; the mean where the file moves it.
  bool is_end = false;  ///< The end of a bone without further joints.
};

/// One frame: the pose of the root and the rotation of each joint in its parent.
struct ClipFrame {
  dvec3 p_root{0.0};
  std::vector<dquat> turns;          ///< One per joint; identity for ends.
  std::vector<dvec3> p_Parent = {};  ///< One per joint, instead of the clip's; empty if no joint moves in its parent.
};

/// A recorded motion as in its file: metres, but with the file's own axes.
struct MotionClip {
  std::vector<ClipJoint> joints;  ///< Parents first.
  std::vector<ClipFrame> frames;
  double frame_time = 1.0 / 120.0;  ///< s
  double metres_per_unit = 1.0;     ///< Assumed for the file's unit.
  std::vector<Text> warnings = {};  ///< Assumptions and contradictions in the file, one sentence each.

  int find(std::string_view name) const;  ///< Index or -1; case does not matter.
};

/// Positions of all joints at a frame, in the clip's world.
struct ClipPose {
  std::vector<dvec3> p;
  std::vector<dquat> q;
};
void placeJoints(const MotionClip& clip, const ClipFrame& frame, ClipPose& pose);

/// Reads BVH. Each line of the motion is one row; every line must have one number per channel, and all lines are read,
/// also beyond the stated number of frames (with a warning); fewer lines are an error. Names may have blanks. Positions
/// in the channels of a joint replace its OFFSET, or are added to it if they stay near zero. The file does not state
/// its unit: with `metres_per_unit` 0 it is estimated from the length of the legs (a person's are about 0.82 m), else
/// from the height at rest. Errors name the line: two roots, a decimal comma, UTF-16, truncated files.
Expected<MotionClip> readBvh(std::string_view text, const std::string& name, double metres_per_unit = 0.0);

/// Reads a skeleton in ASF with its motion in AMC (CMU's convention: lengths in 1/0.45 inch unless the file's unit says
/// otherwise, each bone with its own axes C, local rotation C M C^-1). A bone's joint is at its parent's end.
/// `:RADIANS` and `:DEGREES` of the AMC override the ASF's unit. A frame number that does not follow its predecessor is
/// an error.
Expected<MotionClip> readAsfAmc(std::string_view asf, const std::string& asf_name, std::string_view amc,
                                const std::string& amc_name);

/// Chosen by the extension: .bvh, or .amc with the .asf next to it (the same stem, or its part before '_').
Expected<MotionClip> readMotionFile(const std::filesystem::path& file);

}  // namespace hapticell::mannequin
