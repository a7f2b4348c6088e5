// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::trajectory_checks {

// What each edit of a motion promises, measured on the written file: each function reads the file again and measures it
// with motion_measures.h. Errors: the file cannot be read.

/// Every given frame lies within `tolerance` of the straight segments between the remaining frames.
Expected<Promises> simplifyPromises(const trajectory::Trajectory& given, const trajectory::PathTolerance& tolerance,
                                    const std::filesystem::path& written);

/// A robot's motion together with the poses of the tool that its joints give.
using PosesByJoints = std::function<Expected<trajectory::Trajectory>(const trajectory::Trajectory&)>;

/// Every frame is within `tolerance` of the given pose at its time. If `poses_by_joints` is set, the tool pose that the
/// joints give is checked as well, independently of the poses in the file.
Expected<Promises> smoothPromises(const trajectory::Trajectory& given, const trajectory::PathTolerance& tolerance,
                                  const std::filesystem::path& written, const PosesByJoints& poses_by_joints = {});

struct RetimeAsked {
  bool passes = true;            ///< False if the path was meant to leave the given one (to avoid collisions).
  bool poses_by_joints = false;  ///< The robot's poses were computed from the joints, so they are measured too.
};

/// Every given frame is passed within the tolerance, and the derivatives of the frames respect the limits (or the set
/// shares of them), or the speed.
Expected<Promises> retimePromises(const trajectory::Trajectory& given, const trajectory::RetimingOptions& options,
                                  const RetimeAsked& asked, const std::filesystem::path& written);

/// Every frame lies on the given motion at its time.
Expected<Promises> resamplePromises(const trajectory::Trajectory& given, const std::filesystem::path& written);

/// Every frame is present with its time (within `time_tolerance`, s, relative to the first frame), its pose if
/// `with_poses`, and its joints.
Expected<Promises> copyPromises(const trajectory::Trajectory& given, bool with_poses, double time_tolerance,
                                const std::filesystem::path& written);

}  // namespace hapticell::trajectory_checks
