// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::manipulation {

/// Whether two links of a mannequin (by name) are checked against each other while it is drawn: a forearm, hand or
/// finger against pelvis, trunk, neck, head, both legs and the other arm. What one joint or a few join (a hand and its
/// own arm, the upper arm and the trunk) always overlaps and is left to the joints' limits; so are fingers among each
/// other. A tool in a hand goes by the name of that hand.
bool isOwnPairOfMannequin(const std::string& first, const std::string& second);

}  // namespace hapticell::manipulation
