// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/system/error.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_class.h"

namespace hapticell::kinematics {

/// What yields if a dragged arm's joints are too slow to follow, above all at a wrist singularity.
enum class SingularityChoice {
  kKeepOrientation,  ///< The orientation is kept, the position yields.
  kKeepPosition,     ///< The position is kept, the orientation yields.
  kKeepJoint4,       ///< As kKeepPosition; the first joint of the wrist does not move: see wristJoint().
};

struct InverseOptions {
  ClassTolerance tolerance;
  double lever_m = 0.25;  ///< Where a pose cannot be met: 1 rad counts like this many metres.
  SingularityChoice at_singularity = SingularityChoice::kKeepPosition;
};

/// The first of the last three joints of an arm, the one that swings round with the last where the middle one is
/// straight: joint 4 of six joints, joint 5 of seven; as a variable of the chain. -1 where there is no wrist: under six
/// turning joints, or a slide or a coupled joint among the last three.
int wristJoint(const Chain& chain);

/// The best inverse model for the chain to `tip_link` with the tool centre point X_LT on it: a closed form where
/// classify() knows one, else the numeric one. InverseModel::name() is then describe() of the class.
///
/// The model is read, not kept. Errors: see Chain::create().
Expected<std::unique_ptr<InverseModel>> createInverse(const RobotModel& model, int tip_link, const Pose& X_LT = {},
                                                      const InverseOptions& options = {});

}  // namespace hapticell::kinematics
