// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/error.h"
#include "kinematics/robot_model.h"

namespace hapticell::workcell {

/// Reads the (first) model of an SDF file as a robot: links, visual and collision shapes, joints that may close loops.
///
/// Joints form a graph (a link may be the child of several): a LoopClosure poses what is passive. Universal and
/// revolute2 joints become two turning ones, ball joints three, screws a turn and a slide. A joint to the world fixes
/// the root. Gearboxes are passed over with a warning. Nested models and plugins are not read. The tip is the link
/// named platform or end effector, else that of the usual rule.
///
/// Errors, one sentence each with the file: what sdformat cannot read (its own first complaint), no model, a joint type
/// that is not known, limits reversed, a mesh that is missing, a link that no joint reaches, loops that stay open.
Expected<kinematics::RobotModel> readSdf(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
