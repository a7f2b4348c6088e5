// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"
#include "kinematics/model/robot_model.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// A robot and the pose of its root B: in the file's frame F, or its model's (readSdfRobot()).
struct SdfRobot {
  kinematics::RobotModel model;
  Pose X_FB;
};

/// Reads a model of an SDF file as a robot: the one with moving joints, else the first. Reads links, visual and
/// collision shapes, joints that may close loops, and the content of models inside it ("load::base"). Frames as in
/// libsdformat (see SdfSource); meshes in any readable format.
///
/// Joints form a graph (a link may be the child of several): a LoopClosure poses the passive links. Universal and
/// revolute2 joints become two revolute ones, each with its own limits; ball joints three; screws a revolute and a
/// prismatic one. A fixed joint to the world makes its link the root; a moving one adds a root "world". A missing limit
/// on one side means no limit there. Links without a joint are fixed at their poses and reported. The tip is the link
/// named platform or end effector, else by the usual rule. `monitor` (may be null) can cancel reading meshes.
///
/// A missing mesh is left out and reported, like all that docs/user/formats.md lists as reported. Errors, one sentence
/// each with the file: see SdfSource::load(); no model, an unknown joint type, a joint to a link that does not exist,
/// reversed limits, loops that stay open.
Expected<SdfRobot> readSdf(const std::filesystem::path& file, Diagnostics& diagnostics,
                           ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
