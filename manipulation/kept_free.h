// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "config/configuration.h"
#include "geometry/error.h"
#include "manipulation/path_check.h"
#include "manipulation/prepared_scene.h"
#include "trajectory/retiming.h"
#include "trajectory/trajectory.h"

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
