// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "haptic/rendering/constraint_set.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

/// A guide as rows of the constraint set over the moved frame's xi in the cell, from the reference X_WM.
///
/// `X_WM0` is the moved frame as it stood when the entity was placed: what a hinge turns and a slider slides. Points,
/// circles, hinges are exact at any distance (the square of the distance is what is curved); orientation is held to
/// first order about the reference, its gradient times kRotationLever, so that its rows are metres too. A surface guide
/// needs a query and gives nothing here. Groups are counted up from `first_group`.
///
/// Where the place decides the turn (guidedTurn) the rows are about places only: a wrist that does not turn with the
/// door is no reason to feel a resistance.
std::vector<haptic::Constraint> guideConstraints(const workcell::Guide& guide, const Pose& X_WM, const Pose& X_WM0,
                                                 std::uint32_t first_group);

/// How a guide turns its entity when it is at some place.
struct GuidedTurn {
  dquat q_WM{1.0, 0.0, 0.0, 0.0};
  dmat3 rate{0.0};  ///< Angular velocity = rate * velocity, rad/m, in the cell.
};
/// Hinges off their axis, sliders, and locks of all turning; none for the others.
std::optional<GuidedTurn> guidedTurn(const workcell::Guide& guide, const Pose& X_WM, const Pose& X_WM0);

/// Takes the turning out of a row over xi in which angular = rate * linear: gradient and curvature of what is left.
void slaveTurning(const dmat3& rate, haptic::Constraint& constraint);

}  // namespace hapticell::manipulation
