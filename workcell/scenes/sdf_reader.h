// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"
#include "kinematics/model/robot_model.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// A robot and where its root B stands: in the file's frame F, or its model's (readSdfRobot()).
struct SdfRobot {
  kinematics::RobotModel model;
  Pose X_FB;
};

/// Reads the model of an SDF file that has joints that move (else the first) as a robot: links, visual and collision
/// shapes, joints that may close loops, with what stands in models inside it ("load::base"). Frames as libsdformat has
/// them (see SdfSource); meshes in any readable format.
///
/// Joints form a graph (a link may be the child of several): a LoopClosure poses what is passive. Universal and
/// revolute2 joints become two turning ones, each with its own limits, ball joints three, screws a turn and a slide. A
/// fixed joint to the world makes its link the root; one that moves gives the robot a root "world". A limit that is
/// left out on one side is open there. Links that no joint reaches are fixed where they stand, and told. The tip is the
/// link named platform or end effector, else that of the usual rule. `monitor` (may be null) can end the reading of
/// meshes.
///
/// A mesh that is missing is left out and told, as is all else that docs/user/formats.md calls reported. Errors, one
/// sentence each with the file: see SdfSource::load(); no model, a joint type that is not known, a joint to a link that
/// is not there, limits reversed, loops that stay open.
Expected<SdfRobot> readSdf(const std::filesystem::path& file, Diagnostics& diagnostics,
                           ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
