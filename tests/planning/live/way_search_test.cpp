// SPDX-License-Identifier: Apache-2.0
#include "planning/live/way_search.h"

#include <gtest/gtest.h>

#include "tests/planning/live/window_cell.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {
namespace {

using manipulation::PlanView;
using test::prepared;
using test::throughWindow;
using test::viewOf;

/// The poses' way, as WaySearch::Found::length says it: 0.1 m a radian.
double lengthOf(const std::vector<Pose>& X_WM) {
  double length = 0.0;
  for (std::size_t i = 1; i < X_WM.size(); ++i) {
    const trajectory::PoseDistance way = trajectory::distanceBetween(X_WM[i - 1], X_WM[i]);
    length += way.position + 0.1 * way.angle;
  }
  return length;
}

TEST(WaySearch, LeadsTheMovedFrameThroughTheWindow) {
  WaySearch search(throughWindow(), {});
  EXPECT_EQ(search.space(), nullptr);
  PlanView view = viewOf(prepared());
  const Pose X_EM{{0.0, 0.01, 0.03}, quaternionFromRotationVector({0.0, 0.0, 0.4})};  // Held beside its origin.
  view.X_WM = view.standing.X_WE * X_EM;
  view.insistences = 3;
  const WaySearch::Found found = search.find(view, nullptr);
  ASSERT_TRUE(found.result.isSolved()) << english(found.result.failure->reason);
  EXPECT_EQ(found.answers, 3u);
  ASSERT_GE(found.X_WM.size(), 3u) << "the window is beside the straight way";
  EXPECT_LT(glm::distance(found.X_WM.front().p, view.X_WM.p), 1e-12);
  EXPECT_LT(glm::distance(found.X_WM.back().p, dvec3(0.1, 0.0, 0.0) + X_EM.p), 1e-6) << "the box at the goal";
  EXPECT_NEAR(found.length, lengthOf(found.X_WM), 1e-12);
  std::vector<Pose> X_WE;
  for (const Pose& X_WM : found.X_WM) X_WE.push_back(X_WM * X_EM.inverse());
  test::expectFree(X_WE);
  ASSERT_TRUE(search.space());
  EXPECT_EQ(search.space()->entity().id, 1u);
}

TEST(WaySearch, KeepsItsSpaceWhileTheSceneIsTheSame) {
  WaySearch search(throughWindow(), {});
  const PlanView view = viewOf(prepared());
  search.find(view, nullptr);
  const geometry::Bounds before = search.space()->obstacleBounds();
  auto entities = test::windowCell();
  entities.push_back(manipulation::test::solid(6, "far", geometry::makeBox(dvec3(0.02)), Pose::translation({0.0, 0.0, 3.0})));
  search.find(viewOf(manipulation::PreparedScene::prepare(entities, {}, {})), nullptr);
  EXPECT_LT(before.max.z, 1.0);
  EXPECT_GT(search.space()->obstacleBounds().max.z, 2.9) << "another scene, another space";
}

TEST(WaySearch, EndsWithoutAWayWhenStopped) {
  WaySearch search(throughWindow(), {});
  const std::atomic<bool> stop{true};
  const WaySearch::Found found = search.find(viewOf(prepared()), &stop);
  EXPECT_TRUE(found.X_WM.empty());
  ASSERT_TRUE(found.result.failure);
  EXPECT_EQ(found.result.failure->kind, Failure::Kind::kCancelled);
}

TEST(WaySearch, SaysWhyThereIsNone) {
  WaySearch search(throughWindow(), {});
  PlanView view = viewOf(prepared());
  view.entity = 77;
  const WaySearch::Found unknown = search.find(view, nullptr);
  EXPECT_TRUE(unknown.X_WM.empty());
  ASSERT_TRUE(unknown.result.failure);
  EXPECT_EQ(unknown.result.failure->kind, Failure::Kind::kStart);
  view = viewOf(prepared());
  view.standing.X_WE = view.X_WM = Pose::translation({0.0, -0.04, 0.0});  // Within the wall's left part.
  const WaySearch::Found inside = search.find(view, nullptr);
  ASSERT_TRUE(inside.result.failure);
  EXPECT_NE(english(inside.result.failure->reason).find("no room around"), std::string::npos);
}

/// Beyond a closed wall, the hand's own way in pieces that nothing joins.
TEST(WaySearch, EndsWithAFewTimesItsChecksWhereThereIsNoWay) {
  auto entities = test::windowCell();
  entities.push_back(manipulation::test::solid(6, "closed", geometry::makeBox({0.02, 2.0, 2.0}), Pose::translation({0.05, 0.0, 0.0})));
  entities.push_back(manipulation::test::solid(7, "back", geometry::makeBox({0.02, 2.0, 2.0}), Pose::translation({-0.2, 0.0, 0.0})));
  for (const double side : {-1.0, 1.0}) {
    const auto id = static_cast<workcell::EntityId>(9.0 + side);
    entities.push_back(manipulation::test::solid(id, "side", geometry::makeBox({0.3, 0.02, 2.0}), Pose::translation({-0.08, side * 0.2, 0.0})));
    entities.push_back(manipulation::test::solid(id + 10, "end", geometry::makeBox({0.3, 0.4, 0.02}), Pose::translation({-0.08, 0.0, side * 0.2})));
  }
  LiveOptions options = throughWindow();
  options.most_checks = 1000;
  PlanView view = viewOf(manipulation::PreparedScene::prepare(entities, {}, {}));
  manipulation::Trail trail;
  for (int i = 0; i < 32; ++i) {
    trail.push_back({Pose::translation({0.12, 0.1 * i - 1.6, 0.0}), {}});  // Beyond the wall,
    trail.push_back({Pose::translation({0.05, 0.0, 0.0}), {}});            // and within it.
  }
  trail.push_back(view.standing);
  view.trail = std::make_shared<const manipulation::Trail>(std::move(trail));
  WaySearch search(options, {});
  const WaySearch::Found found = search.find(view, nullptr);
  ASSERT_TRUE(found.result.failure);
  EXPECT_EQ(found.result.failure->kind, Failure::Kind::kNoWay) << english(found.result.failure->reason);
  EXPECT_LT(found.result.checks, 10 * options.most_checks);
}

}  // namespace
}  // namespace hapticell::planning
