// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// The axes of the turning joints of an arm at zero, in the root frame of the chain, without the leading slides.
struct ArmAxes {
  std::size_t rails = 0;  ///< Leading slides.
  std::size_t count = 0;  ///< Joints after them.
  std::array<dvec3, kMaxChainVariables> rail_B;
  std::array<dvec3, kMaxChainVariables> axis_B;
  std::array<dvec3, kMaxChainVariables> origin_B;
  std::array<bool, kMaxChainVariables> prismatic{};  ///< Of the joints after the rails.
  bool simple = false;                               ///< Each joint has a variable of its own.
  double reach = 1.0;
  dmat3 R_BT{1.0};
  dvec3 p_BT{0.0};
};

/// Evaluates the chain with all variables zero.
ArmAxes armAxes(const Chain& chain);

/// Angle (rad, at most a right angle) between two axes; the least distance (m) of their lines.
double angleBetween(const ArmAxes& axes, std::size_t a, std::size_t b);
double lineDistance(const ArmAxes& axes, std::size_t a, std::size_t b);

/// The midpoint of the shortest segment between the lines of axes a and b; for parallel axes, the point of a next to
/// the origin of b.
dvec3 nearestPoint(const ArmAxes& axes, std::size_t a, std::size_t b);

/// Distance (m) of a point from the line of an axis.
double distanceFromAxis(const ArmAxes& axes, const dvec3& p_B, std::size_t axis);

}  // namespace hapticell::kinematics
