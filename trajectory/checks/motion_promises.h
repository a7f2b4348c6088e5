// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/timing/retiming.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory_checks {

// What edits of motions promise, measured on the file that was written: each reads the file anew and measures by
// motion_measures.h. Errors: the file cannot be read.

/// Every given frame lies within `tolerance` of the straight ways between the frames that are left.
Expected<Promises> simplifyPromises(const trajectory::Trajectory& given, const trajectory::PathTolerance& tolerance,
                                    const std::filesystem::path& written);

/// A robot's motion with the poses to which its joints bring the tool.
using PosesByJoints = std::function<Expected<trajectory::Trajectory>(const trajectory::Trajectory&)>;

/// Every frame is within `tolerance` of where it was at its time; where `poses_by_joints` is set, so is the tool as the
/// joints place it, whatever the poses in the file say.
Expected<Promises> smoothPromises(const trajectory::Trajectory& given, const trajectory::PathTolerance& tolerance,
                                  const std::filesystem::path& written, const PosesByJoints& poses_by_joints = {});

struct RetimeAsked {
  bool passes = true;            ///< False: the path was meant to leave the given one (kept free of collisions).
  bool poses_by_joints = false;  ///< A robot's poses were made from the joints, so they are measured too.
};

/// Every given frame is passed within the tolerance; derivatives of the frames keep the limits (shares of them), or the
/// speed.
Expected<Promises> retimePromises(const trajectory::Trajectory& given, const trajectory::RetimingOptions& options,
                                  const RetimeAsked& asked, const std::filesystem::path& written);

/// Every frame lies on the given motion at its time.
Expected<Promises> resamplePromises(const trajectory::Trajectory& given, const std::filesystem::path& written);

/// Every frame is there with its time (`time_tolerance`, s, the first one's time apart), its pose where `with_poses`,
/// and its joints.
Expected<Promises> copyPromises(const trajectory::Trajectory& given, bool with_poses, double time_tolerance,
                                const std::filesystem::path& written);

}  // namespace hapticell::trajectory_checks
