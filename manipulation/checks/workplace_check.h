// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/promise.h"
#include "manipulation/checks/mannequin_workplace.h"

namespace hapticell::manipulation {

/// The cell as it is once the station was put where `place` says, along with what is attached to it.
std::vector<workcell::Entity> movedCell(const WorkplaceQuestion& question, const WorkplaceCell& place);

/// Measures what a search promises of a place on its four postures (WorkplaceCell::postures), without solving anything:
/// of each body its RULA as `place` says it, the grips of its active hands within 2 mm of where the mannequin's are,
/// moved along with the station, no joint beyond its limits, and no part of it inside anything of `after`, the cell as it
/// then is (movedCell(), or a document in which the parts were put there).
Promises workplacePromises(const WorkplaceQuestion& question, const WorkplaceCell& place,
                           const std::vector<workcell::Entity>& after);

}  // namespace hapticell::manipulation
