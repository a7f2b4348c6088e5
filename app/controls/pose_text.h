// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The angles A, B, C of a rotation in degrees: turn by A about z, by B about the new y, by C about the newest x.
///
/// A and C lie in (-180, 180], B in [-90, 90]; at B = ±90 (gimbal lock) C is 0. `q` is a unit quaternion.
std::array<double, 3> abcDegrees(const dquat& q);
/// The rotation of three such angles, any size.
dquat fromAbcDegrees(const std::array<double, 3>& abc);

/// X, Y, Z in millimetres and A, B, C in degrees, as fields show a pose; and back.
std::array<double, 6> poseNumbers(const Pose& X);
Pose poseFromNumbers(const std::array<double, 6>& numbers);

/// The tool centre point of a robot in the world, with its root at X_WB and its variables at `joints`.
/// The root's pose where the robot has no such tip link.
Pose tcpPose_W(const workcell::Entity& robot, const Pose& X_WB, const std::vector<double>& joints);

}  // namespace hapticell::app
