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

/// How far a robot can go straight from its joints as they stand to others, all joints arriving together.
struct JointMotion {
  std::vector<double> joints;  ///< Where it ends: what was asked for, or the last free place before what is in the way.
  bool complete = true;
  double share = 1.0;           ///< Of the way that is free, 0 .. 1.
  Text reason;                  ///< Where it is not complete: "link_4 would touch Fixture after 43 % of the way".
  double time_s = 0.0;          ///< Of the whole way with the slowest joint at its greatest speed.
  std::string obstacle;         ///< Name of the entity in the way; empty where none is.
  workcell::SetJoints command;  ///< Takes the robot to `joints`: the undoable step.
};

/// Checks the motion of the entity (a robot or mechanism, with all that hangs on it) from where it stands in the scene
/// to `joints`, continuously: nothing thin is jumped over, what is touched already is only entered no deeper.
/// On-contact choices count: pairs that pass do not stop it. Errors: no such entity, no robot, locked, another number
/// of joints, a joint outside its limits (the message says which). Takes milliseconds, with many triangles more: not
/// for Qt's thread without thought. Any thread.
Expected<JointMotion> checkJointMotion(std::shared_ptr<const PreparedScene> scene, workcell::EntityId entity,
                                       const std::vector<double>& joints, const config::Configuration& configuration);

/// What the robot would meet if it stood at `joints`, apart from what it meets now: "link_4 would touch Fixture", or
/// empty. The way there is not looked at. Errors as above, but limits are not checked.
Expected<Text> collisionAt(std::shared_ptr<const PreparedScene> scene, workcell::EntityId entity,
                           const std::vector<double>& joints, const config::Configuration& configuration);

}  // namespace hapticell::manipulation
