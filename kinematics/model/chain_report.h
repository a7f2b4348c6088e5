// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// True if the tip (nearly) cannot move in some direction at `x`: the least singular value of the Jacobian, with
/// lengths in units of half the chain's reach, is below 1e-3 (about the angle in rad from the singular position). No
/// allocation.
bool chainIsSingular(const Chain& chain, const ChainPositions& x);

/// True if the six joints after `rails` slides cannot move the tip in some direction at any position (three parallel
/// axes and a wrist whose pairs intersect; a wrist at both ends). A reachable pose then has a continuum of solutions,
/// of which a closed form with isolated solutions gives one, perhaps outside the limits.
bool armIsDeficient(const Chain& chain, std::size_t rails);

/// Describes the branch of the inverse kinematics at `x`: "front, elbow up, wrist not flipped" (see ArmShape); empty
/// for chains without such branches.
std::string configurationName(const Chain& chain, const ChainPositions& x);

/// The elbow of a six-axis arm with parallel axes 2 and 3: the third variable, and one of its positions at which axis
/// 2, axis 3 and the wrist (its centre, or axis 4 if that is parallel too) are in line. This repeats every half turn,
/// stretched or folded; between two such positions the elbow stays on one side.
struct Elbow {
  std::size_t variable = 2;
  double straight = 0.0;  ///< rad
};
std::optional<Elbow> findElbow(const Chain& chain);

}  // namespace hapticell::kinematics
