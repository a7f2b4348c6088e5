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

/// m: parts that are deeper in each other do not merely touch. As deep as a plan may leave contacts (LeavingRule in
/// planning/problem.h). Half: press fits and rough triangles count as overlaps; twice: some real collisions do not.
inline constexpr double kTouchingDepth = 1e-3;

/// A pair that overlaps by more than kTouchingDepth.
struct DeepOverlap {
  workcell::PairRule rule;
  double depth = 0.0;  ///< m, the shortest translation found that frees it.
};

/// Joint positions at which a pair has to touch to touch everywhere. Half: a link that is in contact by chance may count
/// as one that always is; twice: twice the time, which is small.
inline constexpr int kTouchPlaces = 24;

/// The i-th (from 0) of joint positions that are spread all over the ranges of a robot without closed loops.
std::vector<double> jointsAllOver(const kinematics::RobotModel& robot, int i);

/// Takes from `touching`, found by touchingAtRest() in the same scene, the pairs that overlap deeply: the deepest first.
/// Whether they shall be excluded is a question of its own, as excluding them can hide a real collision. In `touching`
/// stay a link that overlaps whatever its joints are (one that turns about an axis in its foot), and a tool that
/// overlaps a link of its robot. Some ms for each pair that is deep. Any thread.
std::vector<DeepOverlap> takeDeepOverlaps(const PreparedScene& scene, std::vector<workcell::PairRule>& touching);

}  // namespace hapticell::manipulation
