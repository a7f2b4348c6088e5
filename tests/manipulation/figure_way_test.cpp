// SPDX-License-Identifier: Apache-2.0
// A mannequin's hands drawn by the mouse, from hanging to where people reach.
#include "manipulation/figure_way.h"

#include <gtest/gtest.h>

#include "geometry/shapes.h"
#include "mannequin/figure_model.h"
#include "workcell/entity_source.h"

namespace hapticell::manipulation {
namespace {

using Kind = MovedBy::Kind;

workcell::Entity hangingFigure(const char* body) {
  Diagnostics diagnostics;
  workcell::Entity entity = *workcell::EntityLoader(".").load(body, 1.0, diagnostics);
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure, *mannequin::libraryPosture(*entity.figure, "standing"));
  entity.X_WE = model.X_WE;
  entity.joints = model.joints;
  return entity;
}

HoldOptions holding(Kind kind, bool apart = false, bool steps = false) {
  HoldOptions options;
  options.moved_by.kind = kind;
  options.moved_by.hands_apart = apart;
  options.moved_by.may_step = steps;
  return options;
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

void expectAllReached(const char* body, bool steps) {
  const workcell::Entity entity = hangingFigure(body);
  const double stature = entity.figure->body[mannequin::Dimension::kStature];
  const auto scene = PreparedScene::prepare({entity}, {}, {});
  for (const Gesture& gesture : kGestures) {
    for (const HoldOptions& hold : {holding(Kind::kBothHands, false, steps), holding(Kind::kBothHands, true, steps),
                                    holding(Kind::kRightHand, false, steps)}) {
      auto way = FigureWay::take(scene, entity.id, hold, FigureWay::Turn::kWithTheForearm, {});
      ASSERT_TRUE(way) << way.error().message();
      const FigureWay::Reach reach = drawn(**way, stature * gesture.by);
      EXPECT_LT(reach.short_m, 0.01) << body << ", " << gesture.name
                                     << (hold.moved_by.kind == Kind::kRightHand ? ", right hand"
                                         : hold.moved_by.hands_apart            ? ", both apart"
                                                                                : ", both as one");
    }
  }
}

TEST(FigureWay, ASmallWomanReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:female:5", false);
}

TEST(FigureWay, AMedianWomanReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:female:50", false);
}

TEST(FigureWay, ATallManReachesFromHangingWhereAPersonDoes) {
  expectAllReached("mannequin:male:95", false);
}

TEST(FigureWay, WithFeetThatStepItReachesAsFar) {
  expectAllReached("mannequin:male:50", true);
}

TEST(FigureWay, WhatAnotherPartHoldsUpIsNotGoneRound) {
  const workcell::Entity entity = hangingFigure("mannequin:male:50");
  workcell::Entity board;
  board.id = 8;
  board.name = "board";
  board.mesh = std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.6, 1.6, 0.03}));
  board.X_WE.p = {0.75, 0.0, 1.3};
  const auto scene = PreparedScene::prepare({entity, board}, {}, {});
  auto way = FigureWay::take(scene, entity.id, holding(Kind::kBothHands, true), FigureWay::Turn::kWithTheForearm, {});
  ASSERT_TRUE(way) << way.error().message();
  ASSERT_LT(drawn(**way, {0.35, 0.0, 0.1}).short_m, 0.01);
  const FigureWay::Reach reach = drawn(**way, {0.0, 0.0, 0.7});
  EXPECT_EQ(reach.obstacle, "board") << reach.short_m << " at " << reach.X_WM.p.z;
  EXPECT_LT(reach.X_WM.p.z, board.X_WE.p.z);
}

}  // namespace
}  // namespace hapticell::manipulation
