// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/planned_way.h"

#include <gtest/gtest.h>

#include "collision/queries/proximity_query.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using test::boxBeforeWall;

/// Least distance of the box from the wall on the straight lines between stops, by single queries.
double leastDistance(const AgentCell& cell, const Pose& X_WFrom, const FollowedWay& way) {
  const auto box = cell.scene()->partsOf(1), wall = cell.scene()->partsOf(2);
  double least = 1.0;
  Pose from = X_WFrom;
  for (const FollowedWay::Stop& stop : way.stops()) {
    for (int k = 0; k <= 20; ++k) {
      const double share = k / 20.0;
      const Pose X_WM{glm::mix(from.p, stop.X_WM.p, share), glm::slerp(from.q, stop.X_WM.q, share)};
      const auto found = collision::distance(box.front().mesh.collider, X_WM, wall.front().mesh.collider,
                                             cell.scene()->find(2)->X_WE, 1.0);
      least = std::min(least, found.colliding ? 0.0 : std::min(1.0, found.distance));
    }
    from = stop.X_WM;
  }
  return least;
}

TEST(PlannedWay, LeadsRoundAWallAndKeepsTheClearance) {
  const auto cell = boxBeforeWall(false);
  const PlannedWay planned = planWay(*cell, cell->start(), cell->task().goal, 7);
  ASSERT_TRUE(planned.way) << english(planned.why);
  ASSERT_FALSE(planned.way->stops().empty());
  EXPECT_LE(glm::length(planned.way->stops().back().X_WM.p - cell->task().goal.p_WG), cell->task().goal.tolerance);
  EXPECT_GE(leastDistance(*cell, cell->start().handle(), *planned.way), cell->task().clearance - 1e-6);
}

TEST(PlannedWay, TheSeedDecides) {
  const auto cell = boxBeforeWall(false);
  const PlannedWay one = planWay(*cell, cell->start(), cell->task().goal, 7);
  const PlannedWay again = planWay(*cell, cell->start(), cell->task().goal, 7);
  ASSERT_TRUE(one.way && again.way);
  ASSERT_EQ(one.way->stops().size(), again.way->stops().size());
  for (std::size_t i = 0; i < one.way->stops().size(); ++i)
    EXPECT_EQ(one.way->stops()[i].X_WM.p, again.way->stops()[i].X_WM.p);
}

TEST(PlannedWay, AGoalInsideTheWallGetsAReason) {
  const auto cell = boxBeforeWall(false, {0.4, 0.0, 0.0});
  const PlannedWay planned = planWay(*cell, cell->start(), cell->task().goal, 7);
  EXPECT_FALSE(planned.way);
  EXPECT_NE(english(planned.why).find("wall"), std::string::npos) << english(planned.why);
}

TEST(PlannedWay, StopsWhenItIsTold) {
  const auto cell = boxBeforeWall(false);
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(planWay(*cell, cell->start(), cell->task().goal, 7, &stop).way);
}

}  // namespace
}  // namespace hapticell::agents
