// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/scene/prepared_scene.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/timing/retiming.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::manipulation {

/// A processed motion, moved closer to its recording where it would touch something that the recording does not.
struct KeptFree {
  trajectory::Trajectory trajectory;
  /// A stretch that was moved closer to the recording, s, and by which share (1: equal to the recording).
  struct Nearer {
    double t_in = 0.0, t_out = 0.0;
    double share = 0.0;
  };
  std::vector<Nearer> nearer;
  PathCheckResult check;  ///< Check of the result.
  int checks = 0;         ///< Number of checks of the motion.
};

/// Checks `processed` (frame for frame the times of `recording`: smoothed, edited) through the scene; where it collides
/// and the recording does not, it is blended towards the recording with soft edges, more in each round, up to the
/// recording itself. So a limit on the deviation still holds afterwards. Errors and progress as checkPath().
Expected<KeptFree> keptFree(std::shared_ptr<const PreparedScene> scene, const trajectory::Trajectory& recording,
                            const trajectory::Trajectory& processed, const PathCheckOptions& options,
                            const config::Configuration& configuration);

/// True if `poses_by_joints` gives the motion's own poses within 1e-6 m and rad, except in frames marked is_pose_apart.
/// False without poses or joints.
bool posesFollowJoints(const trajectory::Trajectory& motion, const trajectory_checks::PosesByJoints& poses_by_joints);

/// A motion with new times whose poses are computed from its joints by `poses_by_joints`. The joints are followed so
/// closely that the given poses, where they follow the joints, are kept within the tolerance too;
/// `report.max_deviation` is the deviation reached. Without joints, or without `poses_by_joints`, it is retimed().
/// Errors: those of both.
Expected<trajectory::Retimed> retimedByJoints(const trajectory::Trajectory& given, trajectory::RetimingOptions options,
                                              const trajectory_checks::PosesByJoints& poses_by_joints);

/// A motion with new times along the same path, through every given frame. Where the fit between frames would touch
/// something that the given motion does not, it stays closer to the given one. A robot's joints and poses agree. Errors
/// as retimed() and checkPath().
struct RetimedFree {
  KeptFree kept;
  trajectory::RetimingReport report;
};
Expected<RetimedFree> retimedFree(std::shared_ptr<const PreparedScene> scene, const trajectory::Trajectory& given,
                                  const trajectory::RetimingOptions& retiming, const PathCheckOptions& options,
                                  const config::Configuration& configuration);

}  // namespace hapticell::manipulation
