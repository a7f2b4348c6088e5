// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "manipulation/manipulators/manipulator_kinds.h"
#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::manipulation {

/// True for a mannequin that has been lifted off: both soles are over the floor (z = 0) and over anything else of the
/// cell by more than 20 mm. No balance is required then. Contract: an entity with a figure.
bool hangsInTheAir(const Taking& taking);

/// The loads attached to the mannequin's hands or fingers, left and right: masses in kg, centres in the hand's frame
/// (the middle of the part's bounds; several parts are combined). Contract: an entity with a figure.
std::array<mannequin::HandLoad, 2> loadsInHands(const Taking& taking);

}  // namespace hapticell::manipulation
