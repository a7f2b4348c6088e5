// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// True when the tip (nearly) loses a direction at `x`: the least singular value of the Jacobian, lengths in units of
/// half the chain's reach, is under 1e-3 (about the angle in rad from the singular position). No allocation.
bool chainIsSingular(const Chain& chain, const ChainPositions& x);

/// True when the six joints behind `rails` slides leave some direction unreachable wherever they stand (three parallel
/// axes and a wrist whose pairs meet, a wrist at both ends): then a pose that is reached at all is reached by a
/// continuum of positions, of which a closed form with isolated solutions shows one, perhaps out of limits.
bool armIsDeficient(const Chain& chain, std::size_t rails);

/// In words, which branch of the inverse `x` lies on: "front, elbow up, wrist not flipped" (see ArmShape); empty for
/// chains without such branches.
std::string configurationName(const Chain& chain, const ChainPositions& x);

/// The elbow of a six-axis arm whose axes 2 and 3 are parallel: the third variable, and one of its positions where axis
/// 2, axis 3 and the wrist (its centre, or axis 4 where that is parallel too) stand in line. Every half turn from there
/// they do so again, stretched or folded; between two such positions the elbow stays on its side.
struct Elbow {
  std::size_t variable = 2;
  double straight = 0.0;  ///< rad
};
std::optional<Elbow> findElbow(const Chain& chain);

}  // namespace hapticell::kinematics
