// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "manipulation/session/session.h"
#include "mannequin/shape/figure_model.h"
#include "planning/live/live_planner.h"
#include "planning/live/way_search.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

using manipulation::PlanView;
using mannequin::Side;
using test::gripOf;
using test::linkPose;

/// A standing worker (1) whose right hand hangs beside and below a bench (3).
std::vector<workcell::Entity> workerCell() {
  return {test::loaded("mannequin:female:50", 1, "worker", {}),
          test::loaded("box:0.75,1.5,0.04", 3, "bench", Pose::translation({0.62, 0.0, 0.93}))};
}

void expectFeetIn(const workcell::Entity& worker, const EntityConfiguration& at, double most) {
  const EntityConfiguration stands{worker.X_WE, worker.joints()};
  for (const char* foot : {"l_hindfoot", "r_hindfoot"}) {
    const Twist off = difference(linkPose(worker, at, foot), linkPose(worker, stands, foot));
    EXPECT_LT(glm::length(off.linear), most) << foot;
  }
}

/// Above the bench, fingers ahead, thumb up; the straight way there is through it.
Pose aboveTheBench() {
  return {{0.37, -0.25, 1.2}, dquat(std::sqrt(0.5), 0.0, -std::sqrt(0.5), 0.0)};
}

LiveOptions liveTo(const Pose& X_WG) {
  LiveOptions options;
  options.goal = goal::ToPose{X_WG};
  options.clearance = 0.005;
  options.period_s = 1.0;
  options.in_virtual_time = true;
  return options;
}

PlanView viewOfWorker(const std::shared_ptr<const manipulation::PreparedScene>& scene) {
  const workcell::Entity& worker = *scene->find(1);
  PlanView view;
  view.scene = scene;
  view.entity = 1;
  view.hand = Side::kRight;
  view.standing = {worker.X_WE, worker.joints()};
  view.X_WM = gripOf(worker, view.standing);
  view.trail = std::make_shared<const manipulation::Trail>(manipulation::Trail{view.standing});
  return view;
}

TEST(LivePlannerOfAMannequin, FindsPosturesOnItsFeetAroundTheBench) {
  const auto scene = manipulation::PreparedScene::prepare(workerCell(), {}, {});
  const workcell::Entity& worker = *scene->find(1);
  const PlanView view = viewOfWorker(scene);
  const Pose X_WG = aboveTheBench();
  const LiveOptions options = liveTo(X_WG);
  WaySearch search(options, {});
  const WaySearch::Found found = search.find(view, nullptr);
  ASSERT_TRUE(found.result.isSolved()) << english(found.result.failure->reason);
  ASSERT_EQ(found.postures.size(), found.X_WM.size());
  EXPECT_EQ(found.postures.front().joints, view.standing.joints);
  EXPECT_LT(glm::distance(found.X_WM.back().p, X_WG.p), 1e-3);
  for (std::size_t i = 0; i < found.postures.size(); ++i) {
    EXPECT_LT(glm::distance(gripOf(worker, found.postures[i]).p, found.X_WM[i].p), 1e-6) << i;
    expectFeetIn(worker, found.postures[i], 1e-3);
  }
}

TEST(LivePlannerOfAMannequin, AsksForAHandThatMovesIt) {
  const auto scene = manipulation::PreparedScene::prepare(workerCell(), {}, {});
  PlanView view = viewOfWorker(scene);
  view.hand.reset();
  const LiveOptions options = liveTo(aboveTheBench());
  WaySearch search(options, {});
  const WaySearch::Found found = search.find(view, nullptr);
  EXPECT_TRUE(found.X_WM.empty());
  ASSERT_TRUE(found.result.failure);
  EXPECT_NE(english(found.result.failure->reason).find("left or right hand moves it"), std::string::npos);
}

/// The way of the right hand is none for the left one, and a search for the right one is none either.
TEST(LivePlannerOfAMannequin, ForgetsItsWayWhenTheOtherHandMovesIt) {
  const auto scene = manipulation::PreparedScene::prepare(workerCell(), {}, {});
  PlanView view = viewOfWorker(scene);
  LivePlanner planner(liveTo(aboveTheBench()));
  const auto lookUntil = [&](const auto& done) {
    for (int i = 0; i < 2000 && !done(); ++i, view.time_ns += 10'000'000) planner.look(view);
    return done();
  };
  view.hold = 1;
  ASSERT_TRUE(lookUntil([&] { return planner.newest() != nullptr; }));
  EXPECT_EQ(planner.newest()->hold, 1u);
  view.hold = 2;
  view.hand = Side::kLeft;
  planner.look(view);
  EXPECT_EQ(planner.newest(), nullptr);
  view.hold = 3;
  view.hand.reset();
  EXPECT_FALSE(lookUntil([&] { return planner.newest() != nullptr; })) << "it is not moved by a hand";
}

/// With the clock of the machine: what was searched for the worker is not laid into the way of a solid.
TEST(LivePlanner, GivesUpASearchWhenAnotherEntityIsTaken) {
  auto entities = workerCell();
  entities.push_back(test::loaded("box:0.1,0.1,0.1", 4, "part", Pose::translation({-1.0, 0.0, 0.5})));
  const auto scene = manipulation::PreparedScene::prepare(entities, {}, {});
  LiveOptions options = liveTo(aboveTheBench());
  options.in_virtual_time = false;
  options.period_s = 0.001;
  LivePlanner planner(options);
  PlanView of_part;
  of_part.scene = scene;
  of_part.entity = 4;
  of_part.standing = {scene->find(4)->X_WE, {}};
  of_part.X_WM = of_part.standing.X_WE;
  of_part.trail = std::make_shared<const manipulation::Trail>(manipulation::Trail{of_part.standing});
  PlanView of_worker = viewOfWorker(scene);
  for (std::uint64_t hold = 1; hold <= 20; ++hold) {
    PlanView& view = hold % 2 == 0 ? of_part : of_worker;
    view.hold = hold;
    planner.look(view);
    std::this_thread::sleep_for(std::chrono::milliseconds(5 * hold));
    const auto way = planner.newest();
    if (way == nullptr) continue;
    EXPECT_EQ(way->hold, hold);
    EXPECT_EQ(way->postures.empty(), &view == &of_part);
  }
}

manipulation::SessionReport leadHand(double authority, std::vector<workcell::Entity> cell) {
  manipulation::SessionOptions options;
  options.entities = std::move(cell);
  options.entity = "worker";
  options.moved_by = manipulation::by::Hand{Side::kRight};
  options.configuration.manipulation.rate_hz = 50.0;
  options.configuration.manipulation.edge_drift = 0.1;
  options.axes.mode = manipulation::AxesMode::kCell;
  const workcell::Entity& worker = options.entities.front();
  const Pose X_WG = aboveTheBench();
  const dvec3 way = X_WG.p - gripOf(worker, {worker.X_WE, worker.joints()}).p;
  const double scale = glm::length(way) / 0.05;
  options.scale = {manipulation::ScaleLevel::kNumber, scale};
  options.straight_hand = manipulation::seededHand(1);
  options.straight_hand->X_WG = X_WG;
  options.straight_hand->scale = scale;
  const Pose X_DStart = Pose::translation(-0.5 * way / scale);
  options.hand = haptic::HandPath({{0.0, X_DStart, 0}, {12.0, X_DStart, 0}});
  options.assistance = {std::make_shared<LivePlanner>(liveTo(X_WG)), authority};
  auto report = manipulation::runSession(options);
  EXPECT_TRUE(report.has_value()) << report.error().message();
  return report ? std::move(*report) : manipulation::SessionReport{};
}

TEST(LivePlannerOfAMannequin, LeadsTheHandOntoTheBench) {
  const manipulation::SessionReport led = leadHand(1.0, workerCell());
  ASSERT_TRUE(led.plan.has_value());
  EXPECT_TRUE(led.plan->solved) << led.end.X_WM.p.x << " " << led.end.X_WM.p.y << " " << led.end.X_WM.p.z;
  EXPECT_LE(led.forces.penetration_blocked_m, 1e-6);
  EXPECT_LE(led.plan->pull_max_step_n_per_ms, 0.05);
  const auto entities = workerCell();
  expectFeetIn(entities.front(), led.end.configuration, 2e-3);
  const manipulation::SessionReport alone = leadHand(0.0, workerCell());
  ASSERT_TRUE(alone.plan.has_value());
  EXPECT_FALSE(alone.plan->solved) << "straight on there is the bench";
}

/// The usual cell: the soles stand on a floor, which the exact check keeps free of them.
TEST(LivePlannerOfAMannequin, LeadsTheHandOfAWorkerOnAFloor) {
  auto cell = workerCell();
  cell.push_back(test::loaded("box:4,4,0.1", 5, "floor", Pose::translation({0.0, 0.0, -0.05})));
  const manipulation::SessionReport led = leadHand(1.0, cell);
  ASSERT_TRUE(led.plan.has_value());
  EXPECT_TRUE(led.plan->solved) << led.end.X_WM.p.x << " " << led.end.X_WM.p.y << " " << led.end.X_WM.p.z;
  EXPECT_LE(led.forces.penetration_blocked_m, 1e-5);
  expectFeetIn(cell.front(), led.end.configuration, 2e-3);
}

}  // namespace
}  // namespace hapticell::planning
