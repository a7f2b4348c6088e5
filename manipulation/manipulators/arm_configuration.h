// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "kinematics/model/chain.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// Which branch a six-axis arm stands on: 1 back, 2 elbow down, 4 wrist flipped, added. Nothing for chains without.
std::optional<int> configurationNumber(const kinematics::Chain& chain, std::span<const double> joints);
/// The chain of a robot's six joints to its tip; nothing where there are others.
std::optional<kinematics::Chain> sixAxisChain(const workcell::Entity& entity);

}  // namespace hapticell::manipulation
