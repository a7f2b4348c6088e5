// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::manipulation {

/// Targets of a mannequin's hands at one step.
struct HandTargets {
  double step = 0.0;
  std::array<std::optional<Pose>, 2> hands;  ///< Left, right.
};

/// Reads `hand,x,y,z,qw,qx,qy,qz` (hand: left or right) with an optional column `step`: rows of one step belong
/// together; without it, each row is a step. Metres; quaternions within 1e-3 of unit length are normalised. Errors name
/// line and column; a hand that a step names twice is an error too.
Expected<std::vector<HandTargets>> readHandTargets(const std::filesystem::path& file);

}  // namespace hapticell::manipulation
