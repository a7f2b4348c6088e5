// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "mannequin/body/skeleton.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The angles A, B, C of a rotation in degrees: turn by A about z, by B about the new y, by C about the newest x.
///
/// A and C lie in (-180, 180], B in [-90, 90]; at B = ±90 (gimbal lock) C is 0. `q` is a unit quaternion.
std::array<double, 3> abcDegrees(const dquat& q);
/// The rotation for three such angles of any size.
dquat fromAbcDegrees(const std::array<double, 3>& abc);

/// Converts a pose to the numbers that fields show: X, Y, Z in millimetres and A, B, C in degrees; and back.
std::array<double, 6> poseNumbers(const Pose& X);
Pose poseFromNumbers(const std::array<double, 6>& numbers);

/// The pose of a robot's tool centre point in the world, with its root at X_WB and its joint variables at `joints`.
/// Returns the root's pose if the robot has no such tip link.
Pose tcpPose_W(const workcell::Entity& robot, const Pose& X_WB, const std::vector<double>& joints);
/// The grip of a mannequin's hand in the world (as by::Hand moves it), with its root at X_WE and its joint variables at
/// `joints`. Contract: a mannequin.
Pose gripPose_W(const workcell::Entity& entity, mannequin::Side side, const Pose& X_WE,
                const std::vector<double>& joints);

}  // namespace hapticell::app
