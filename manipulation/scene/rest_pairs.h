// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/scene/pair_state.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// Distances of everything that is checked against `moved` and what hangs on it, as the cell stands in the document: one
/// entry for each pair of entities, its nearest parts; nearest first. What hangs on a robot is measured against the
/// robot's other links too, as while it is held. Farther than `limit` (m): left out. Pairs that are not checked
/// (PreparedScene::isChecked) do not count. Any thread; takes as long as cold queries take.
std::vector<PairState> pairsAtRest(const PreparedScene& scene, workcell::EntityId moved, double limit);

/// Rules that leave out what touches or intersects as the cell stands in the document, part by part: pairs that are
/// checked (PreparedScene::isChecked) and not both locked; a carried part and a link that it can move against are such a
/// pair. Nearer than `tolerance` (m) counts as touching: CAD parts that stand on each other do so to
/// rounding. Nothing is changed here: who asks gives them to workcell::SetPairRules, or not. Any thread.
std::vector<workcell::PairRule> touchingAtRest(const PreparedScene& scene, double tolerance = 2e-5);

}  // namespace hapticell::manipulation
