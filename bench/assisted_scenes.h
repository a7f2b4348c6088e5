// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "planning/problem.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/pair_policy.h"

namespace hapticell::bench {

/// A move that neither the straight way nor a hand that only knows that can make.
struct AssistedScene {
  std::string name;
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  std::string entity;       ///< What is moved.
  planning::Goal goal;
  Pose X_WG;                ///< Where the moved frame is to go, for the hand.
  double scale = 1.0;       ///< m of the cell a metre of hand.
  double clearance = 0.002; ///< m of the planner.
  double rate_hz = 250.0;   ///< Of the manipulation loop.
};

/// The exercise of the filter unit (config/exercises/extraction.hcell), with the end of the expert's recording as goal.
AssistedScene extractionScene();
/// Two equal wires that hang in each other's loops (the alpha puzzle of N. Amato, 2000, in our dimensions): a loop whose
/// ends cross each other at a distance of 1.5 times the wire; the one is to come out of the other.
AssistedScene wirePuzzleScene();
/// A pipe with two bends under the struts of a bay with a block and two cylinders in it; it is to come out at the top.
AssistedScene bentPipeScene();
/// The chain of seven links among 80 parts; `seed` chooses start and goal among free positions.
AssistedScene robotScene(std::uint64_t seed);

/// A tube of `radius` (m) along a polyline, closed at its ends.
geometry::TriangleMesh tubeAlong(const std::vector<dvec3>& middle, double radius, int segments);

}  // namespace hapticell::bench
