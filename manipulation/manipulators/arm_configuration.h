// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "kinematics/model/chain.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// The configuration of a six-axis arm as a sum: 1 back, 2 elbow down, 4 wrist flipped. Empty for chains without these
/// branches.
std::optional<int> configurationNumber(const kinematics::Chain& chain, std::span<const double> joints);
/// The chain of a robot's six joints to its tip; empty if the robot has other joints.
std::optional<kinematics::Chain> sixAxisChain(const workcell::Entity& entity);

}  // namespace hapticell::manipulation
