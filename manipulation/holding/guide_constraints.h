// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "haptic/rendering/constraint_set.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

/// A guide as rows of the constraint set over the moved frame's xi in the cell, from the reference X_WM.
///
/// `X_WM0` is the moved frame when the entity was placed; a hinge rotates and a slider moves from there. Points,
/// circles and hinges are exact at any distance (their squared distance is quadratic). Orientation is constrained to
/// first order around the reference; its gradient is multiplied by kRotationLever, so that its rows are in metres too.
/// A surface guide needs a query and gives no rows here. Groups are numbered from `first_group`.
///
/// If the position determines the rotation (guidedTurn()), the rows constrain positions only: the hand feels no
/// resistance if the wrist does not rotate with the door.
std::vector<haptic::Constraint> guideConstraints(const workcell::Guide& guide, const Pose& X_WM, const Pose& X_WM0,
                                                 std::uint32_t first_group);

/// How a guide rotates its entity, depending on its position.
struct GuidedTurn {
  dquat q_WM{1.0, 0.0, 0.0, 0.0};
  dmat3 rate{0.0};  ///< Angular velocity = rate * velocity, rad/m, in the cell.
};
/// For hinges away from their axis, sliders, and locks of all rotation; empty for others.
std::optional<GuidedTurn> guidedTurn(const workcell::Guide& guide, const Pose& X_WM, const Pose& X_WM0);

/// Eliminates the rotation from a row over xi with angular = rate * linear; gradient and curvature are then of the
/// translation only.
void slaveTurning(const dmat3& rate, haptic::Constraint& constraint);

}  // namespace hapticell::manipulation
