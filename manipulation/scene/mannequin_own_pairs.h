// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::manipulation {

/// Whether two links of a mannequin (by name) are checked against each other while it is dragged: a forearm, hand or
/// finger against pelvis, trunk, neck, head, both legs and the other arm. Links connected by one joint or a few (a hand
/// and its own arm, the upper arm and the trunk) always overlap and are left to the joint limits; so are fingers among
/// each other. A tool in a hand counts as that hand.
bool isOwnPairOfMannequin(const std::string& first, const std::string& second);

}  // namespace hapticell::manipulation
