// SPDX-License-Identifier: Apache-2.0
// A mannequin that stands on a floor: its soles touch it as it is taken, and that is no contact which could stop it.
#include <gtest/gtest.h>

#include "manipulation/holding/held_entity.h"
#include "mannequin/shape/figure_model.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity worker() {
  Diagnostics notes;
  workcell::Entity entity = *workcell::EntityLoader(".").load("mannequin:male:50", 1.0, notes);
  entity.id = 7;
  entity.name = "worker";
  return entity;
}

workcell::Entity block(workcell::EntityId id, const char* name, const dvec3& size, const dvec3& p_WE) {
  workcell::Entity entity = test::solid(id, name, geometry::makeBox(size));
  entity.X_WE = Pose::translation(p_WE);
  return entity;
}

/// A floor whose top is `z` m below the soles.
workcell::Entity floorAt(double z) {
  return block(8, "floor", {4.0, 4.0, 0.1}, {0.0, 0.0, -0.05 - z});
}

SessionReport moved(const MovedBy& moved_by, std::vector<workcell::Entity> cell, const dvec3& way) {
  SessionOptions options = test::sessionOf(std::move(cell), "worker", test::handThrough({{0.0, {}}, {0.5, {}}, {2.5, way}, {3.5, way}}), 100.0, 0.0);
  options.axes.mode = AxesMode::kCell;
  options.moved_by = moved_by;
  auto report = runSession(options);
  EXPECT_TRUE(report.has_value()) << report.error().message();
  return report ? std::move(*report) : SessionReport{};
}

TEST(StandingFeet, AHandMovesAsWithoutTheFloor) {
  const MovedBy ways[] = {by::Hand{mannequin::Side::kRight}, by::Hand{mannequin::Side::kLeft}, by::BothHands{}, by::Head{}};
  for (const MovedBy& way : ways) {
    const dvec3 there(0.05, 0.0, -0.03);
    const SessionReport alone = moved(way, {worker()}, there), on_floor = moved(way, {worker(), floorAt(0.0)}, there);
    EXPECT_LT(test::placeError(on_floor.end.X_WM, alone.end.X_WM), 1e-6) << way.index();
    EXPECT_GT(glm::distance(alone.end.X_WM.p, worker().X_WE.p), 0.0);
    EXPECT_TRUE(on_floor.contacts.empty()) << "standing is no contact";
    ASSERT_FALSE(on_floor.notices.empty());
    EXPECT_NE(on_floor.notices.front().find("stands on floor"), std::string::npos) << on_floor.notices.front();
  }
}

TEST(StandingFeet, TheWholeFigureIsStoppedByTheFloor) {
  const SessionReport report = moved(by::Whole{}, {worker(), floorAt(0.0)}, {0.0, 0.0, -0.05});
  EXPECT_GT(report.end.configuration.X_WE.p.z, worker().X_WE.p.z - 1e-4);
  EXPECT_LE(report.forces.penetration_blocked_m, 2e-5);
}

/// A wall before the worker is checked against all of it.
TEST(StandingFeet, WhatIsNotUnderThemStillStops) {
  HoldOptions options;
  options.moved_by = by::Hand{mannequin::Side::kRight};
  std::vector<workcell::Entity> cell{worker(), floorAt(0.0), block(9, "wall", {0.02, 2.0, 1.0}, {0.3, 0.0, 0.5})};
  const auto scene = PreparedScene::prepare(cell, {}, {});
  const auto held = HeldEntity::take(scene, 7, {}, options, {});
  ASSERT_TRUE(held) << held.error().message();
  int on_floor = 0, on_wall = 0, feet_on_wall = 0;
  for (const HeldPair& pair : (*held)->pairs()) {
    on_floor += pair.other == 8 ? 1 : 0;
    on_wall += pair.other == 9 ? 1 : 0;
    feet_on_wall += pair.other == 9 && pair.moved_part.ends_with("foot") ? 1 : 0;
  }
  EXPECT_GT(on_floor, 20) << "all but the feet";
  EXPECT_EQ(feet_on_wall, 4);
  EXPECT_EQ(on_wall, on_floor + 4);
}

}  // namespace
}  // namespace hapticell::manipulation
