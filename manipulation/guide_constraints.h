// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "haptic/rendering/constraint_set.h"
#include "workcell/guide.h"

namespace hapticell::manipulation {

/// A guide as rows of the constraint set over the moved frame's xi in the cell, from the reference X_WM.
///
/// `X_WM0` is the moved frame as it stood when the entity was placed: what a hinge turns and a slider slides. Points,
/// circles, hinges are exact at any distance (the square of the distance is what is curved); orientation is held to
/// first order about the reference, its gradient times kRotationLever, so that its rows are metres too. A surface guide
/// needs a query and gives nothing here. Groups are counted up from `first_group`.
std::vector<haptic::Constraint> guideConstraints(const workcell::Guide& guide, const Pose& X_WM, const Pose& X_WM0,
                                                 std::uint32_t first_group);

}  // namespace hapticell::manipulation
