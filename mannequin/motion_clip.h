// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.h"
#include "geometry/pose.h"

namespace hapticell::mannequin {

/// One joint of a recorded skeleton. Frames of all joints are parallel at the file's rest position.
struct ClipJoint {
  std::string name;
  int parent = -1;      ///< Index before its own; -1 for the root.
  dvec3 p_Parent{0.0};  ///< In the parent's frame, m.
  bool is_end = false;  ///< The end of a bone without joints of its own.
};

/// One moment: where the root is and how each joint turns in its parent.
struct ClipFrame {
  dvec3 p_root{0.0};
  std::vector<dquat> turns;  ///< One a joint; identity for ends.
};

/// A recorded motion as its file has it: metres, but with the file's own axes (BVH and ASF: Y up).
struct MotionClip {
  std::vector<ClipJoint> joints;  ///< Parents first.
  std::vector<ClipFrame> frames;
  double frame_time = 1.0 / 120.0;  ///< s
  double metres_per_unit = 1.0;     ///< That were taken for the file's unit.

  int find(std::string_view name) const;  ///< Index or -1; upper and lower case are the same.
};

/// Places of all joints at a frame, in the clip's world.
struct ClipPose {
  std::vector<dvec3> p;
  std::vector<dquat> q;
};
void placeJoints(const MotionClip& clip, const ClipFrame& frame, ClipPose& pose);

/// Reads BVH. The file does not say its unit: `metres_per_unit` 0 guesses it from the skeleton's height at rest (a
/// person of 0.5 to 3 m: metres; 50 to 300: centimetres; inches between). Errors name the line.
Expected<MotionClip> readBvh(std::string_view text, const std::string& name, double metres_per_unit = 0.0);

/// Reads a skeleton in ASF with its motion in AMC (CMU's convention: lengths in 1/0.45 inch unless the file's unit says
/// otherwise, each bone with axes C of its own, local turn C M C^-1). A bone's joint is at its parent's end.
Expected<MotionClip> readAsfAmc(std::string_view asf, const std::string& asf_name, std::string_view amc,
                                const std::string& amc_name);

/// By the ending: .bvh, or .amc with the .asf beside it (the same stem, or its part before '_').
Expected<MotionClip> readMotionFile(const std::filesystem::path& file);

}  // namespace hapticell::mannequin
