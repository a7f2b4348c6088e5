// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/error.h"
#include "kinematics/inverse_model.h"
#include "kinematics/robot_class.h"

namespace hapticell::kinematics {

/// What yields while an arm is dragged through its wrist singularity faster than its joints can turn.
enum class SingularityChoice {
  kKeepOrientation,  ///< Position and orientation share the error by the lever, joints 4 and 6 swing as fast as they
                     ///< may.
  kKeepPosition,     ///< The position is kept, the orientation yields.
  kKeepJoint4,       ///< Joint 4 stands still near the singularity, the position is kept, the orientation yields.
};

struct InverseOptions {
  ClassTolerance tolerance;
  double lever_m = 0.25;  ///< Where a pose cannot be met: 1 rad counts like this many metres.
  SingularityChoice at_singularity = SingularityChoice::kKeepPosition;
};

/// The best inverse model for the chain to `tip_link` with the tool centre point X_LT on it: a closed form where
/// classify() knows one, else the numeric one. InverseModel::name() is then describe() of the class.
///
/// The model is read, not kept. Errors: see Chain::create().
Expected<std::unique_ptr<InverseModel>> createInverse(const RobotModel& model, int tip_link, const Pose& X_LT = {},
                                                      const InverseOptions& options = {});

}  // namespace hapticell::kinematics
