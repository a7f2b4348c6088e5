// SPDX-License-Identifier: Apache-2.0
// The parts that an engine is made of, each by itself.
#include <gtest/gtest.h>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/result_log.h"
#include "manipulation/engine/step_clock.h"
#include "manipulation/engine/stylus_grip.h"
#include "manipulation/engine/stylus_input.h"
#include "tests/manipulation/session/hand_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

TEST(StepClock, CountsFromTheFirstStepAndDoesNotCatchUp) {
  StepClock clock;
  EXPECT_EQ(clock.sinceStart(), 0.0);
  clock.tick(5'000'000'000);
  EXPECT_EQ(clock.sinceStart(), 0.0);
  EXPECT_EQ(clock.stepTime(), 1e-4) << "the first step has no step before it";
  clock.tick(5'010'000'000);
  EXPECT_NEAR(clock.sinceStart(), 0.01, 1e-12);
  EXPECT_NEAR(clock.stepTime(), 0.01, 1e-12);
  clock.tick(9'010'000'000);
  EXPECT_EQ(clock.stepTime(), 0.1) << "a loop that was held up";
  EXPECT_EQ(clock.steps(), 3U);
}

TEST(ResultLog, TellsInOrderAndOnceWhereAsked) {
  ResultLog log;
  log.notice(Text("a"));
  log.noticeOnce(Text("b"));
  log.noticeOnce(Text("b"));
  log.notice(Text("a"));
  const std::vector<Result> told = log.take();
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(std::get<result::Notice>(told[1]).sentence, Text("b"));
  EXPECT_TRUE(log.take().empty());
}

TEST(CellState, KnowsWhereThingsStandAndWhatHangsOnWhat) {
  CellState cell({});
  EXPECT_EQ(cell.find(1), nullptr) << "no scene yet";
  std::vector<workcell::Entity> entities = test::boxOverTable(0.02);
  entities[1].attachment.to = entities[0].name;
  const workcell::EntityId table = entities[0].id, box = entities[1].id;
  const dvec3 p_WBox = entities[1].X_WE.p;
  cell.setScene(PreparedScene::prepare(std::move(entities), {}, {}), {});
  EXPECT_EQ(cell.placement(box).X_WE.p, p_WBox);
  cell.place(box, {Pose::translation({1.0, 2.0, 3.0}), {}});
  EXPECT_EQ(cell.placement(box).X_WE.p, dvec3(1.0, 2.0, 3.0));
  EXPECT_TRUE(cell.standsOn(box, table));
  EXPECT_TRUE(cell.standsOn(table, table));
  EXPECT_FALSE(cell.standsOn(table, box));
  cell.tick(7);
  cell.tick(7);
  EXPECT_EQ(cell.clock().steps(), 1U) << "two styluses at one time are one step";
}

TEST(HandMapping, DriftsOnlyAtTheEdgeAndTellsWhenTheSpeedChanges) {
  haptic::DeviceDescription device;
  device.workspace_min = dvec3(-0.1);
  device.workspace_max = dvec3(0.1);
  HandMapping hand;
  EXPECT_FALSE(hand.drift(&device, dvec3(0.05, 0.0, 0.0), 0.1, 10'000'000));
  EXPECT_EQ(hand.drift_D(), dvec3(0.0));
  EXPECT_TRUE(hand.drift(&device, dvec3(-0.1, 0.0, 0.0), 0.1, 20'000'000));
  EXPECT_EQ(hand.drift_D(), dvec3(-0.1, 0.0, 0.0));
  EXPECT_NEAR(hand.mapping().toCell(Pose::identity()).p.x, -0.001, 1e-12) << "it went on for a step";
  EXPECT_FALSE(hand.drift(&device, dvec3(-0.1, 0.0, 0.0), 0.1, 30'000'000));
  EXPECT_TRUE(hand.drift(nullptr, dvec3(-0.1, 0.0, 0.0), 0.1, 40'000'000)) << "nothing is held any more";
}

TEST(HandMapping, ClutchAndScaleTellWhetherTheyChangeAnything) {
  HandMapping hand;
  const config::Configuration::Scale levels;
  hand.update({}, std::nullopt, levels);
  EXPECT_FALSE(hand.update({}, std::nullopt, levels));
  hand.setScale({ScaleLevel::kFine, 1.0});
  EXPECT_TRUE(hand.update({}, std::nullopt, levels));
  EXPECT_EQ(hand.mapping().scale(), levels.fine);
  EXPECT_TRUE(hand.setClutched(true));
  EXPECT_FALSE(hand.setClutched(true));
}

TEST(StylusInput, ButtonsArePressedAndLetGoOnce) {
  test::HandLink link;
  StylusInput input(link, {});
  EXPECT_TRUE(input.watchLink());
  EXPECT_FALSE(input.watchLink());
  link.state.buttons = 3;
  input.takeNewest();
  EXPECT_EQ(input.takeButtons().pressed, 3U);
  link.state.buttons = 2;
  input.takeNewest();
  const StylusInput::Buttons buttons = input.takeButtons();
  EXPECT_EQ(buttons.pressed, 0U);
  EXPECT_EQ(buttons.let_go, 1U);
  EXPECT_EQ(buttons.down, 2U);
}

TEST(StylusGrip, TakesWhatIsFreeAndPutsItDownWhereItIs) {
  CellState cell({});
  ResultLog log;
  StylusGrip grip(cell, log);
  EXPECT_FALSE(grip.take(2)) << "no scene yet";
  cell.setScene(PreparedScene::prepare(test::boxOverTable(0.02), {}, {}), {});
  grip.setOther(2, {});
  EXPECT_FALSE(grip.heldElsewhere(2).empty());
  grip.setOther(0, {});
  EXPECT_TRUE(grip.heldElsewhere(2).empty());
  ASSERT_TRUE(grip.take(2));
  EXPECT_TRUE(grip.holds(2));
  EXPECT_TRUE(grip.placeOther(1, {Pose::translation({0.0, 0.0, -0.1}), {}}));
  EXPECT_FALSE(grip.placeOther(1, {Pose::translation({0.0, 0.0, -0.1}), {}})) << "told before";
  EXPECT_EQ(grip.placement(1).X_WE.p.z, -0.1);
  const Pose X_WE = grip.placement(2).X_WE;
  grip.putDown();
  EXPECT_EQ(grip.held(), nullptr);
  EXPECT_EQ(cell.placement(2).X_WE.p, X_WE.p);
}

}  // namespace
}  // namespace hapticell::manipulation
