// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "agents/body/moved_body.h"

namespace hapticell::agents {

/// A point of a link, and how it should move.
struct PointWish {
  int link = 0;
  dvec3 p_WQ{0.0};
  Twist velocity;          ///< m/s, rad/s
  bool with_turn = false;  ///< Whether the turn counts; else any turn will do.
};

/// Velocities of the variables (rad/s, m/s) that move a point as wished, by damped least squares (Nakamura and Hanafusa
/// 1986) weighted by readiness; a variable at its limit that would go beyond it is left out and the others are asked
/// again. `readiness`: one a variable.
std::vector<double> follow(const MovedBody& body, const PointWish& wish, std::span<const double> readiness);
/// The same with the body's own readiness.
std::vector<double> follow(const MovedBody& body, const PointWish& wish);

/// Velocity of a point of a link for velocities of the variables.
dvec3 velocityOf(const MovedBody& body, int link, const dvec3& p_WQ, std::span<const double> v);

/// Least singular value of the moved frame's Jacobian, lengths divided by 0.5 m; over all variables.
double leastSingularValue(const MovedBody& body);

}  // namespace hapticell::agents
