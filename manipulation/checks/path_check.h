// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/checks/path_finding.h"
#include "manipulation/holding/held_entity.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::manipulation {

struct PathCheckOptions {
  HoldOptions hold{};
  /// Motions of the robot's external axes, on the same clock (the same take); an axis without a motion does not move.
  /// Used if the motion has joints.
  std::vector<std::shared_ptr<const trajectory::Trajectory>> axes{};
  double look = 0.05;            ///< m: larger clearances are not measured.
  double pose_tolerance = 1e-4;  ///< m and rad, for kOffPose.
  /// Gets the progress (0 .. 1); returning false ends the check. Called in the checking thread; may be empty.
  std::function<bool(double)> progress = {};
};

/// Moves the entity, with everything attached to it, through the frames as the manipulation loop would: by its joints
/// if the trajectory has them (by name), else by its inverse model, nearest to the frame before. The motion between
/// frames is checked continuously, so thin parts are not skipped. It checks what HeldEntity checks: the entity's parts
/// and what it carries, against the cell and against each other. Errors: no such entity, no frames, a joint that the
/// robot does not have.
Expected<PathCheckResult> checkPath(std::shared_ptr<const PreparedScene> scene, const std::string& entity,
                                    const trajectory::Trajectory& trajectory, const PathCheckOptions& options,
                                    const config::Configuration& configuration);

}  // namespace hapticell::manipulation
