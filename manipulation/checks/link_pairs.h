// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::manipulation {

struct LinkPairOptions {
  int samples = 100'000;  ///< Random joint positions within the limits.
  std::uint64_t seed = 1;
};

/// How often two links of a robot touch.
struct LinkPairUse {
  int first = 0, second = 0;  ///< Links, first < second.
  bool adjacent = false;      ///< Joined by a joint, or through links without a shape.
  bool at_rest = false;       ///< They touch at the resting position.
  int contacts = 0;           ///< Samples in which they touch.
};

/// Exact contacts of all pairs of links with a shape, at the resting position and at random positions; continuous joints
/// go from -pi to pi. The same options give the same result. One thread; a few microseconds for each sample.
std::vector<LinkPairUse> linkPairUse(const kinematics::RobotModel& model, const LinkPairOptions& options);

/// The pairs that need no check, with the reasons that MoveIt's setup assistant gives: "Adjacent", "Default" (they
/// touch at rest), "Always" (in 95 % of the samples), "Never" (in none). Those that the model disables already come
/// first.
std::vector<kinematics::DisabledPair> pairsWithoutCheck(const kinematics::RobotModel& model,
                                                        const std::vector<LinkPairUse>& use, int samples);

}  // namespace hapticell::manipulation
