// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/scene/pair_state.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// Distances of everything that is checked against `moved` and the entities attached to it, with the placements of the
/// document: one entry for each pair of entities, with its nearest parts; nearest first. Entities attached to a robot
/// are also measured against the robot's other links, as while it is held. Farther than `limit` (m): left out. Pairs
/// that are not checked (PreparedScene::isChecked) do not count. Any thread; takes as long as cold queries take.
std::vector<PairState> pairsAtRest(const PreparedScene& scene, workcell::EntityId moved, double limit);

/// Rules that exclude pairs of parts that touch or intersect with the placements of the document: pairs that are
/// checked (PreparedScene::isChecked) and not both locked; a carried part and a link that it can move against are such
/// a pair. Nearer than `tolerance` (m) counts as touching: CAD parts that touch do so only up to rounding. Nothing is
/// changed here; the caller may pass the rules to workcell::SetPairRules. Any thread.
std::vector<workcell::PairRule> touchingAtRest(const PreparedScene& scene, double tolerance = 2e-5);

}  // namespace hapticell::manipulation
