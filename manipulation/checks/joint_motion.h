// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "manipulation/holding/held_entity.h"
#include "workcell/document/command.h"

namespace hapticell::manipulation {

/// How far a robot can move straight from its present joints to others; all joints arrive together.
struct JointMotion {
  std::vector<double> joints;  ///< End of the motion: the requested joints, or the last free ones before the obstacle.
  bool complete = true;
  double share = 1.0;           ///< Free share of the motion, 0 .. 1.
  Text reason;                  ///< If it is not complete: "link_4 would touch Fixture after 43 % of the way".
  double time_s = 0.0;          ///< Duration of the complete motion with the slowest joint at its greatest speed.
  std::string obstacle;         ///< Name of the blocking entity; empty if the motion is free.
  workcell::SetJoints command;  ///< Moves the robot to `joints`: the undo step.
};

/// Checks the motion of the entity (a robot or mechanism, with everything attached to it) from its present state in the
/// scene to `joints`, continuously: thin parts are not skipped. Parts that already touch must not go deeper. Contact
/// modes apply: pairs that pass do not stop the motion. Errors: no such entity, not a robot, locked, a wrong number of
/// joints, a joint outside its limits (the message names it). Takes milliseconds, more with many triangles; avoid it in
/// Qt's thread. Any thread.
Expected<JointMotion> checkJointMotion(std::shared_ptr<const PreparedScene> scene, workcell::EntityId entity,
                                       const std::vector<double>& joints, const config::Configuration& configuration);

/// The collision of the robot at `joints`, except those that it already has: "link_4 would touch Fixture", or empty.
/// The motion to `joints` is not checked. Errors as above, but limits are not checked.
Expected<Text> collisionAt(std::shared_ptr<const PreparedScene> scene, workcell::EntityId entity,
                                  const std::vector<double>& joints, const config::Configuration& configuration);

}  // namespace hapticell::manipulation
