// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/contact_search.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <thread>

#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/manipulators/solid_manipulator.h"
#include "tests/manipulation/session/hand_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::HandLink;

/// The box over the table, taken, the hand where the test puts it.
struct Hand {
  explicit Hand(bool in_thread, double height = 0.02) {
    if (in_thread) engine.searchInThread();
    engine.apply(command::SetDocument{test::boxOverTable(height), {}});
    engine.apply(command::ChooseEntity{2});
    moveTo({0, 0, 0}, 1);
    moveTo({0, 0, 0});
  }
  void moveTo(const dvec3& p, std::uint32_t buttons = 0) {
    link.state.X_DS.p = link.state.X_DP.p = p;
    link.state.buttons = buttons;
    now += 2'000'000;
    engine.step(now);
  }
  /// Rests until a set came that was not made in the step itself, or as long as it takes to be sure.
  bool awaitSet(const std::function<bool(const haptic::ConstraintSet&)>& wanted) {
    constexpr int kMost = 100'000;
    for (int i = 0; i < kMost; ++i) {
      moveTo(link.state.X_DP.p);
      if (wanted(link.set)) return true;
      std::this_thread::yield();
    }
    return false;
  }
  HandLink link;
  ManipulationEngine engine{link, {}};
  std::int64_t now = 0;
};

/// A plain set is good for 20 mm.
bool isComplete(const haptic::ConstraintSet& set) {
  return set.count > 0 && set.zone_radius > 0.021;
}

/// What the set lets the hand do: the least over its groups of their largest entries.
double valueAt(const haptic::ConstraintSet& set, const dvec3& p_D) {
  BuiltConstraints built;
  built.set = set;
  // Contacts only: rows of the entity's own (how far it may turn) have their ids beyond.
  for (const haptic::Constraint& row : set.active()) built.origins.push_back({(row.id >> 63) == 0 ? 0 : -1, -1});
  double gap = 0.0;
  pairGaps(built, {p_D, dquat(1, 0, 0, 0)}, {&gap, 1});
  return gap;
}

TEST(ContactSearch, TheStepGoesOnWithAPlainSetAndTheSearchedOneFollows) {
  Hand aside(true), at_once(false);
  // Before anything was found there is a plane at the nearest points: nothing can be run into meanwhile.
  ASSERT_GT(aside.link.set.count, 0U);
  EXPECT_NEAR(valueAt(aside.link.set, {0, 0, -0.01}), 0.009, 1e-4);
  ASSERT_TRUE(aside.awaitSet(isComplete));
  ASSERT_TRUE(isComplete(at_once.link.set));
  for (const dvec3& p : {dvec3(0, 0, 0), dvec3(0.01, 0, -0.01), dvec3(0.02, -0.02, -0.018)}) {
    EXPECT_NEAR(valueAt(aside.link.set, p), valueAt(at_once.link.set, p), 1e-9);
  }
}

TEST(ContactSearch, ASetThatComesLateIsForWhereTheEntityIsByThen) {
  Hand hand(true);
  ASSERT_TRUE(hand.awaitSet(isComplete));
  // On the move all the time: answers come for places that were left.
  for (int i = 1; i <= 200; ++i) {
    hand.moveTo({0, 0, -5e-5 * i});
    const double now = hand.engine.held()->movedFrame().p.z;
    const double shown = valueAt(hand.link.set, hand.link.state.X_DP.p);
    EXPECT_NEAR(shown, now - 0.03 - 1e-3, 1e-6) << i;
    std::this_thread::yield();
  }
}

TEST(ContactSearch, WhatWasAskedForAnotherDocumentIsForgotten) {
  Hand hand(true);
  for (int i = 0; i < 20; ++i) {
    const double height = 0.01 + 0.002 * i;
    hand.engine.apply(command::Release{});
    hand.engine.apply(command::SetDocument{test::boxOverTable(height), {}});
    hand.engine.apply(command::Grab{2});
    hand.moveTo({0, 0, 0});
    ASSERT_TRUE(hand.awaitSet(isComplete)) << i;
    EXPECT_NEAR(valueAt(hand.link.set, {0, 0, 0}), height - 1e-3, 1e-6) << i;
  }
}

TEST(MoveReference, KeepsEveryRowsValue) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 200; ++i) {
    BuiltConstraints built;
    built.set.count = 1;
    haptic::Constraint& row = built.set.constraints[0];
    row.gap = 0.01 * unit(random);
    for (double& a : row.gradient) a = unit(random);
    for (double& b : row.curvature) b = 20.0 * unit(random);
    row.has_trim = true;
    row.trim_gap = unit(random);
    for (double& a : row.trim_gradient) a = unit(random);
    built.set.X_DR = {any(), quaternionFromRotationVector(any())};
    built.set.zone_radius = 0.06;
    const haptic::ConstraintSet before = built.set;
    const Pose X_DNow{before.X_DR.p + 0.01 * any(), before.X_DR.q};
    moveReference(built, before.X_DR, X_DNow);
    const Pose X_DThere{X_DNow.p + 0.02 * any(), before.X_DR.q};
    EXPECT_NEAR(valueAt(built.set, X_DThere.p), valueAt(before, X_DThere.p), 1e-9);
    EXPECT_NEAR(built.set.zone_radius, 0.06 - glm::distance(X_DNow.p, before.X_DR.p), 1e-12);
  }
}

/// Balls over a cylinder that moves meanwhile: as if it had been found there.
TEST(Completed, TakesWhereAnObstacleHasGoneIntoAccount) {
  const auto ball = collision::SurfaceModel::build(geometry::makeSphere(0.02, 32));
  const auto ball_pieces = collision::ConvexPieces::build(geometry::makeSphere(0.02, 32));
  const auto rod_mesh = geometry::makeCylinder(0.05, 0.4, 96);
  const auto rod = collision::SurfaceModel::build(rod_mesh);
  const auto rod_pieces = collision::ConvexPieces::build(rod_mesh);
  const SolidManipulator solid(Pose::identity(), {Pose::identity()});
  const EntityConfiguration at{Pose::translation({0.075, 0.0, 0.0}), {}};
  MotionMapping mapping;
  mapping.anchor(at.X_WE, at.X_WE);
  const collision::ConvexPieces* parts[] = {ball_pieces.get()};
  const collision::SurfaceModel* surfaces[] = {ball.get()};
  const std::vector<MotionPair> pairs{{0, 0, true}};
  const std::vector<PairFeel> feel{{true, 1e-3, 0, 0, 0}};
  const dvec3 gone_W(-0.004, 0.012, 0.0);
  const auto setOf = [&](const dvec3& p_WRod, const dvec3& gone) {
    const std::vector<collision::ZonePart> obstacles{{rod_pieces.get(), Pose::translation(p_WRod), 1, 0.0, rod.get()}};
    collision::ContactFinder finder;
    ConstraintInputs inputs{solid, at, mapping, at.X_WE, 0.02, 0.1, parts, obstacles, pairs, feel};
    inputs.finder = &finder;
    inputs.surfaces = surfaces;
    ConstraintDraft draft = draftConstraints(inputs);
    draft.options.pair_mask = draft.mask;
    return completed(draft, finder.find(draft.moving, obstacles, draft.options), {&gone, 1});
  };
  const BuiltConstraints moved = setOf(dvec3(0.0), gone_W), there = setOf(gone_W, dvec3(0.0));
  ASSERT_GT(moved.set.count, 0U);
  // A round entry's value is a distance only where it is 0: where the ball is at the safety distance.
  for (const double angle : {-0.1, 0.0, 0.08}) {
    for (const double height : {-0.01, 0.005}) {
      const dvec3 p_W = gone_W + dvec3(0.071 * std::cos(angle), 0.071 * std::sin(angle), height);
      EXPECT_NEAR(valueAt(there.set, p_W), 0.0, 6e-5);
      EXPECT_NEAR(valueAt(moved.set, p_W), 0.0, 6e-5);
    }
  }
}

}  // namespace
}  // namespace hapticell::manipulation
