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

/// A processed motion, kept nearer to its recording where it would have touched something that the recording did not.
struct KeptFree {
  trajectory::Trajectory trajectory;
  /// Where it was drawn to the recording, s, and how far (1: it is the recording there).
  struct Nearer {
    double t_in = 0.0, t_out = 0.0;
    double share = 0.0;
  };
  std::vector<Nearer> nearer;
  PathCheckResult check;  ///< Of the result.
  int checks = 0;         ///< How many times the way was checked.
};

/// Checks `processed` (frame for frame the times of `recording`: smoothed, edited) through the scene; where it collides
/// and the recording does not, it is blended to the recording with soft edges, more with each round, at last the
/// recording itself, so that a deviation that was kept before is kept after. Errors and progress as checkPath().
Expected<KeptFree> keptFree(std::shared_ptr<const PreparedScene> scene, const trajectory::Trajectory& recording,
                            const trajectory::Trajectory& processed, const PathCheckOptions& options,
                            const config::Configuration& configuration);

/// True where `poses_by_joints` gives the poses that a motion has, within 1e-6 m and rad in frames that do not say
/// otherwise (is_pose_apart). False without poses or joints.
bool posesFollowJoints(const trajectory::Trajectory& motion, const trajectory_checks::PosesByJoints& poses_by_joints);

/// A motion with new times whose poses are those that `poses_by_joints` makes of its joints. The joints are passed so
/// closely that the given poses, where they follow the joints, are passed within the tolerance too; `report.max_deviation` says how nearly that came
/// out. Without joints, or without `poses_by_joints`, it is retimed(). Errors as of both.
Expected<trajectory::Retimed> retimedByJoints(const trajectory::Trajectory& given, trajectory::RetimingOptions options,
                                              const trajectory_checks::PosesByJoints& poses_by_joints);

/// A motion with new times along the same way, through every given frame, kept nearer to the given one where the fit
/// between its frames would touch something that the given motion does not. Joints and poses of a robot agree. Errors as
/// retimed() and checkPath().
struct RetimedFree {
  KeptFree kept;
  trajectory::RetimingReport report;
};
Expected<RetimedFree> retimedFree(std::shared_ptr<const PreparedScene> scene, const trajectory::Trajectory& given,
                                  const trajectory::RetimingOptions& retiming, const PathCheckOptions& options,
                                  const config::Configuration& configuration);

}  // namespace hapticell::manipulation
