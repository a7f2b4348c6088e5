// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/system/error.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_class.h"

namespace hapticell::kinematics {

/// What is given up if the joints of a dragged arm are too slow to follow, in particular near a wrist singularity.
enum class SingularityChoice {
  kKeepOrientation,  ///< The orientation is kept, the position lags.
  kKeepPosition,     ///< The position is kept, the orientation lags.
  kKeepJoint4,       ///< As kKeepPosition; in addition the first joint of the wrist does not move: see wristJoint().
};

struct InverseOptions {
  ClassTolerance tolerance;
  double lever_m = 0.25;  ///< If a pose cannot be met: 1 rad weighs as much as this many metres.
  SingularityChoice at_singularity = SingularityChoice::kKeepPosition;
};

/// The first of the last three joints of an arm, which turns together with the last joint if the middle one is
/// straight: joint 4 of six, joint 5 of seven; as a variable of the chain. -1 if there is no wrist: fewer than six
/// turning joints, or a slide or a coupled joint among the last three.
int wristJoint(const Chain& chain);

/// The best inverse model for the chain to `tip_link` with the tool centre point X_LT on it: a closed form if
/// classify() recognises the chain, otherwise the numeric model. InverseModel::name() is describe() of the class.
///
/// The model is read, not kept. Errors: see Chain::create().
Expected<std::unique_ptr<InverseModel>> createInverse(const RobotModel& model, int tip_link, const Pose& X_LT = {},
                                                      const InverseOptions& options = {});

}  // namespace hapticell::kinematics
