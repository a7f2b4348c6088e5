// SPDX-License-Identifier: Apache-2.0
// A mannequin's hands drawn by the mouse, from hanging to where people reach.
#include "manipulation/holding/figure_way.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "geometry/shapes/shapes.h"
#include "mannequin/shape/figure_model.h"
#include "tests/support/wanted_cases.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity hangingFigure(const char* body) {
  Diagnostics diagnostics;
  workcell::Entity entity = *workcell::EntityLoader(".").load(body, 1.0, diagnostics);
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), "standing"));
  entity.X_WE = model.X_WE;
  entity.setJoints(model.joints);
  return entity;
}

HoldOptions holding(const MovedBy& moved_by) {
  HoldOptions options;
  options.moved_by = moved_by;
  return options;
}
by::Hand rightHand(bool steps = false) {
  return {.side = mannequin::Side::kRight, .may_step = steps};
}

/// Draws `by` (m) as a mouse does: some thirty places, each followed for one picture; then until it is there.
FigureWay::Reach drawn(FigureWay& way, const dvec3& by) {
  constexpr int kMoves = 30, kMostPictures = 500;
  const Pose start = way.follow().X_WM;
  FigureWay::Reach reach;
  for (int i = 1; i <= kMoves; ++i) {
    way.aim({start.p + (static_cast<double>(i) / kMoves) * by, start.q});
    reach = way.follow();
  }
  for (int i = 0; i < kMostPictures && !reach.arrived; ++i) reach = way.follow();
  return reach;
}

struct Gesture {
  const char* name;
  dvec3 by;  ///< Statures.
};
constexpr double kElbowRise = 0.15, kShoulderRise = 0.33, kOverHead = 0.58;
const std::vector<Gesture> kGestures = {
    {"up to elbow height", {0.0, 0.0, kElbowRise}}, {"up to the shoulders", {0.06, 0.0, kShoulderRise}},
    {"over head", {0.0, 0.0, kOverHead}},           {"to the front", {0.22, 0.0, 0.0}},
    {"to the front and up", {0.25, 0.0, 0.30}},     {"across to the left", {0.20, 0.10, 0.20}},
    {"across to the right", {0.20, -0.10, 0.20}},   {"to the knees", {0.15, 0.0, -0.12}}};

/// Three ways of holding times eight gestures. A body draws each gesture in one of the ways, and the next body (`number`) in
/// the next one: so each gesture is drawn in each way.
void expectAllReached(const char* body, std::size_t number, bool steps) {
  const workcell::Entity entity = hangingFigure(body);
  const double stature = entity.figure()->body[mannequin::Dimension::kStature];
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  const std::array<HoldOptions, 3> holds = {holding(by::BothHands{false, steps}), holding(by::BothHands{true, steps}),
                                            holding(rightHand(steps))};
  for (std::size_t i = 0; i < kGestures.size(); ++i) {
    const Gesture& gesture = kGestures[i];
    for (std::size_t j = 0; j < holds.size(); ++j) {
      if (!test::allCasesAreWanted() && j != (i + number) % holds.size()) continue;
      const HoldOptions& hold = holds[j];
      auto way = FigureWay::take(scene, entity.id, hold, FigureWay::Turn::kWithTheForearm, {});
      ASSERT_TRUE(way) << way.error().message();
      const FigureWay::Reach reach = drawn(**way, stature * gesture.by);
      EXPECT_LT(reach.short_m, 0.01) << body << ", " << gesture.name << ", " << wordOf(hold.moved_by, false);
    }
  }
}

TEST(FigureWay, ASmallWomanReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:female:5", 0, false);
}

TEST(FigureWay, AMedianWomanReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:female:50", 1, false);
}

TEST(FigureWay, ATallManReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:male:95", 2, false);
}

TEST(FigureWay, WithFeetThatStepItReachesAsFar) {
  expectAllReached("mannequin:male:50", 1, true);
}

/// Where a person's hands get to standing: in the box before the body from the knees to over the head, and at the most
/// an arm's length and what a trunk adds from the shoulder, by measures alone (no solver is asked).
std::vector<dvec3> reachablePlaces(const mannequin::Figure& figure, std::size_t count, std::uint64_t seed) {
  constexpr double kTrunkAdds = 0.05;  // Statures.
  const double stature = figure.body[mannequin::Dimension::kStature];
  const double arm = figure.upperArmLength() + figure.forearmLength();
  const double shoulder = figure.body[mannequin::Dimension::kAcromialHeight] - 0.04;
  std::mt19937_64 random(seed);
  const auto unit = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  std::vector<dvec3> places;
  while (places.size() < count) {
    const dvec3 p = stature * dvec3(0.12 + 0.24 * unit(), 0.2 * (2.0 * unit() - 1.0), 0.3 + 0.8 * unit());
    const bool low = p.z < shoulder - arm;  // There the whole body goes down.
    if (low || glm::length(p - dvec3(0.0, 0.0, shoulder)) < arm + kTrunkAdds * stature) places.push_back(p);
  }
  return places;
}

/// Draws one figure from place to place, as it stands after each.
void expectAllOfASweep(const char* body, const HoldOptions& hold, const char* name, std::uint64_t seed) {
  const workcell::Entity entity = hangingFigure(body);
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  auto way = FigureWay::take(scene, entity.id, hold, FigureWay::Turn::kWithTheForearm, {});
  ASSERT_TRUE(way) << way.error().message();
  for (const dvec3& p : reachablePlaces(*entity.figure(), 3, seed)) {
    const FigureWay::Reach reach = drawn(**way, p - (*way)->follow().X_WM.p);
    EXPECT_LT(reach.short_m, 0.01) << body << ", " << name << ", to " << p.x << " " << p.y << " " << p.z << " "
                                   << reach.obstacle;
  }
}

TEST(FigureWay, ASweepFromPlaceToPlaceLeavesNoneShort) {
  expectAllOfASweep("mannequin:female:5", holding(by::BothHands{}), "both as one", 1);
  expectAllOfASweep("mannequin:female:5", holding(rightHand()), "right hand", 3);
  expectAllOfASweep("mannequin:male:50", holding(by::BothHands{.apart = true}), "both apart", 5);
}

/// Draws one figure that may step to places at random on the floor round it, as it stands after each; how many it left
/// short.
int leftShortOfWalks(const char* body, bool apart, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  const workcell::Entity entity = hangingFigure(body);
  const double stature = entity.figure()->body[mannequin::Dimension::kStature];
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  auto way =
      FigureWay::take(scene, entity.id, holding(by::BothHands{apart, true}), FigureWay::Turn::kWithTheForearm, {});
  int left_short = 0;
  const int places = test::allCasesAreWanted() ? 4 : 2;
  for (int i = 0; i < places; ++i) {
    const dvec3 p = stature * dvec3(2.0 * unit() - 1.0, 2.0 * unit() - 1.0, 0.35 + 0.45 * unit());
    const FigureWay::Reach reach = drawn(**way, p - (*way)->follow().X_WM.p);
    if (reach.short_m < 0.01) continue;
    ++left_short;
    std::printf("%s left %.0f mm short of %.2f %.2f %.2f\n", body, 1000.0 * reach.short_m, p.x, p.y, p.z);
  }
  return left_short;
}

TEST(FigureWay, AManWhoMayStepWalksToAnyPlaceAndOutOfAnyPosture) {
  EXPECT_EQ(leftShortOfWalks("mannequin:male:95", true, 6), 0);
}

TEST(FigureWay, AWomanWhoMayStepWalksToAnyPlaceAndOutOfAnyPosture) {
  EXPECT_EQ(leftShortOfWalks("mannequin:female:5", false, 7), 0);
}

TEST(FigureWay, ItEndsWhereItCameNearest) {
  const workcell::Entity entity = hangingFigure("mannequin:male:50");
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  for (const bool steps : {false, true}) {
    auto way =
        FigureWay::take(scene, entity.id, holding(by::BothHands{false, steps}), FigureWay::Turn::kWithTheForearm, {});
    ASSERT_TRUE(way) << way.error().message();
    (*way)->aim({{-0.2, -0.6, 2.6}, (*way)->follow().X_WM.q});  // Higher than anybody gets.
    FigureWay::Reach reach;
    double least = 1e9;
    int pictures = 0;
    for (; pictures < 500 && !reach.arrived; ++pictures) {
      reach = (*way)->follow();
      least = std::min(least, reach.short_m);
    }
    EXPECT_LT(pictures, 500);
    EXPECT_GT(reach.short_m, 0.2);
    EXPECT_LT(reach.short_m, least + 0.006);
  }
}

TEST(FigureWay, ASearchForAWayRoundIsGivenUpForSomethingNewer) {
  const workcell::Entity entity = hangingFigure("mannequin:male:50");
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  auto way = FigureWay::take(scene, entity.id, holding(by::BothHands{}), FigureWay::Turn::kWithTheForearm, {});
  ASSERT_TRUE(way) << way.error().message();
  const Pose start = (*way)->follow().X_WM;
  const Pose over_head{start.p + dvec3(0.0, 0.0, 1.0), start.q};
  bool is_newer = true;
  int asked = 0;
  (*way)->setInterrupted([&] { return ++asked, is_newer; });
  (*way)->aim(over_head);
  FigureWay::Reach reach;
  for (int i = 0; i < 200; ++i) reach = (*way)->follow();
  EXPECT_GT(asked, 0);
  EXPECT_FALSE(reach.arrived) << "it is still to be looked for";
  EXPECT_GT(reach.short_m, 0.1) << "the straight way gets stuck";
  is_newer = false;
  for (int i = 0; i < 200 && !reach.arrived; ++i) reach = (*way)->follow();
  EXPECT_LT(reach.short_m, 0.01);
}

TEST(FigureWay, WhatAnotherPartHoldsUpIsNotGoneRound) {
  const workcell::Entity entity = hangingFigure("mannequin:male:50");
  workcell::Entity board;
  board.id = 8;
  board.name = "board";
  board.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.6, 1.6, 0.03}))};
  board.X_WE.p = {0.75, 0.0, 1.3};
  const auto scene = PreparedScene::prepare({entity, board}, {}, {});
  auto way =
      FigureWay::take(scene, entity.id, holding(by::BothHands{.apart = true}), FigureWay::Turn::kWithTheForearm, {});
  ASSERT_TRUE(way) << way.error().message();
  ASSERT_LT(drawn(**way, {0.35, 0.0, 0.1}).short_m, 0.01);
  const FigureWay::Reach reach = drawn(**way, {0.0, 0.0, 0.7});
  EXPECT_EQ(reach.obstacle, "board") << reach.short_m << " at " << reach.X_WM.p.z;
  EXPECT_LT(reach.X_WM.p.z, board.X_WE.p.z);
}

}  // namespace
}  // namespace hapticell::manipulation
