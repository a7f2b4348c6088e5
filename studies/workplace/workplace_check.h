// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/promise.h"
#include "studies/workplace/workplace_search.h"

namespace hapticell::studies {

/// The cell with the station, and everything attached to it, moved to `place`.
std::vector<workcell::Entity> movedCell(const WorkplaceQuestion& question, const WorkplaceCell& place);

/// Measures the promises of a search result on its four postures (WorkplaceCell::postures), without solving. For each
/// body: the RULA score equals that in `place`; the grips of its active hands are within 2 mm of the mannequin's, moved
/// with the station; no joint is beyond its limits; no part of it is inside anything in `after`, the resulting cell
/// (movedCell(), or a document with the moved parts). `scenes` prepares it. Any thread.
Promises workplacePromises(const WorkplaceQuestion& question, const WorkplaceCell& place,
                           const std::vector<workcell::Entity>& after, manipulation::SceneService& scenes);

}  // namespace hapticell::studies
