// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "kinematics/closed_form/closed_form.h"

namespace hapticell::kinematics {

/// Arms of class kSphericalWrist (`from_base` false) and kSphericalBase (true), up to 8 solutions.
///
/// The first three joints place the wrist centre: joint 3 from a trigonometric polynomial of at most second degree
/// (Pieper 1968), then joints 2 and 1. The last three orient the tip, as subproblems (Paden 1986, Elias and Wen 2025).
/// An arm whose first three axes intersect in a point is solved from the tip to the base.
std::unique_ptr<const ClosedForm> makeSphericalArm(const ArmAxes& axes, bool from_base);

}  // namespace hapticell::kinematics
