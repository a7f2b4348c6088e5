// SPDX-License-Identifier: Apache-2.0
// What a held entity is made of, each part by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "manipulation/holding/held_boundaries.h"
#include "manipulation/holding/held_constraints.h"
#include "manipulation/holding/held_pairs.h"
#include "manipulation/holding/held_state.h"
#include "manipulation/holding/held_way.h"
#include "manipulation/holding/hold_options.h"
#include "manipulation/holding/joint_friction.h"
#include "manipulation/holding/ways_out.h"
#include "manipulation/manipulators/manipulator_kinds.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

constexpr workcell::EntityId kTable = 1, kBox = 2, kCup = 3;

std::shared_ptr<const PreparedScene> boxScene(double height) {
  std::vector<workcell::Entity> entities = test::boxOverTable(height);
  workcell::Entity cup =
      test::solid(kCup, "cup", geometry::makeBox(dvec3(0.02)), Pose::translation({0.0, 0.0, 0.08 + height}));
  cup.attachment.to = "box";
  entities.push_back(std::move(cup));
  return PreparedScene::prepare(std::move(entities), {}, {0.001, 0.010});
}

HeldState heldBox(double height, const HoldOptions& options = {}) {
  const config::Configuration configuration;
  std::vector<Text> notes;
  const auto scene = boxScene(height);
  HeldModel model(scene, *scene->find(kBox), {}, false, notes);
  std::vector<Taking::Part> parts;
  for (const MovedPart& part : model.parts()) parts.push_back({part.link, part.X_LP});
  const Taking taking{model.form(), model.taken(),      resolved(options.moved_by, model.form()), *scene, configuration,
                      parts,        options.joints_move};
  auto manipulator = makeManipulator(taking, manipulatorKinds());
  EXPECT_TRUE(manipulator);
  HeldPairs pairs(model, **manipulator, {}, options, configuration);
  FreeMotion motion = pairs.motionCheck(model);
  motion.reset(**manipulator, model.taken());
  EntityConfiguration taken = model.taken();
  return {std::move(model), std::move(*manipulator), std::move(taken), std::move(pairs), std::move(motion), {}};
}

/// The box `z` higher than now.
EntityConfiguration lifted(const HeldState& state, double z) {
  EntityConfiguration at = state.accepted;
  at.X_WE.p.z += z;
  return at;
}

std::size_t pairOf(const HeldState& state, workcell::EntityId owner) {
  std::size_t pair = 0;
  while (pair < state.pairs.size() && state.pairs[pair].owner != owner) ++pair;
  return pair;
}

TEST(HeldModel, HasWhatHangsOnTheEntity) {
  const HeldState state = heldBox(0.02);
  const HeldModel& model = state.model;
  ASSERT_EQ(model.parts().size(), 2U);
  EXPECT_TRUE(model.isMoved(kCup));
  EXPECT_FALSE(model.isMember(kCup));
  EXPECT_FALSE(model.isMoved(kTable));
  EXPECT_TRUE(model.axes(model.taken()).empty());
  EXPECT_EQ(model.ownJoint(-1), -1);
  EntityConfiguration at = model.taken();
  at.X_WE = Pose{dvec3(1.0, 2.0, 3.0), quaternionFromRotationVector({0.0, 0.5 * std::numbers::pi, 0.0})};
  const HeldModel::Standing carried = model.carried(at);
  ASSERT_EQ(carried.size(), 1U);
  EXPECT_EQ(carried[0].first, kCup);
  EXPECT_NEAR(glm::length(carried[0].second.X_WE.p - dvec3(1.05, 2.0, 3.0)), 0.0, 1e-12) << "50 mm above, turned";
  EXPECT_EQ(model.nameOf(*model.parts()[0].part), "box");
}

TEST(HeldModel, StandsWhereThePlacementsSay) {
  const auto scene = boxScene(0.02);
  const workcell::Entity& box = *scene->find(kBox);
  EXPECT_EQ(standingOf(box, {}).X_WE.p, box.X_WE.p);
  Placements placements;
  placements[kBox].X_WE.p = {0.5, 0.0, 0.5};
  EXPECT_EQ(standingOf(box, placements).X_WE.p.x, 0.5);
}

TEST(HeldPairs, AreThoseOfAllThatMovesWithAllThatDoesNot) {
  const HeldState state = heldBox(0.02);
  ASSERT_EQ(state.pairs.size(), 2U);
  EXPECT_EQ(state.pairs.firstOwn(), 2U) << "a solid meets nothing of its own";
  ASSERT_EQ(state.pairs.obstacles().size(), 1U);
  for (const workcell::EntityId owner : {kBox, kCup}) {
    const std::size_t pair = pairOf(state, owner);
    ASSERT_LT(pair, 2U);
    EXPECT_EQ(state.pairs[pair].other, kTable);
    EXPECT_EQ(state.pairs[pair].safety_distance, 0.001);
    EXPECT_EQ(state.pairs[pair].near_miss, 0.010);
    EXPECT_TRUE(state.pairs[pair].feel.felt);
  }
  EXPECT_TRUE(state.pairs.leftOutNote().empty());
}

TEST(HeldPairs, FollowTheUsersChoiceOfWhatContactsDo) {
  HoldOptions options;
  options.on_contact = workcell::OnContact::kPass;
  const HeldState passing = heldBox(0.02, options);
  EXPECT_FALSE(passing.pairs.feel()[0].felt);
  options.on_contact = workcell::OnContact::kStop;
  const HeldState stopping = heldBox(0.02, options);
  EXPECT_TRUE(stopping.pairs.feel()[0].felt);
  EXPECT_GT(stopping.pairs.feel()[0].friction, 100.0) << "it sticks";
}

TEST(HeldWay, GoesAsFarAsTheWayIsFree) {
  HeldState state = heldBox(0.02);
  HeldWay way(state);
  const HeldWay::Gone gone = way.goTo(lifted(state, -0.05));
  EXPECT_TRUE(gone.blocked);
  EXPECT_EQ(gone.pair, pairOf(state, kBox)) << "not the cup";
  EXPECT_NEAR(gone.share, 0.02 / 0.05, 1e-3);
  EXPECT_GE(state.accepted.X_WE.p.z, 0.03) << "never inside";
  EXPECT_NEAR(state.accepted.X_WE.p.z, 0.03, HeldState::kSkin);
  const HeldWay::Gone up = way.goTo(lifted(state, 0.10));
  EXPECT_FALSE(up.blocked);
  EXPECT_EQ(up.share, 1.0);
  EXPECT_NEAR(state.movedFrame().p.z, 0.13, HeldState::kSkin);
}

TEST(HeldWay, GivesWayToWhatMoves) {
  HeldState state = heldBox(0.01);
  HeldWay way(state);
  EXPECT_EQ(way.moveOther(kTable, {0.0, 0.0, 0.005}), 1.0);
  EXPECT_NEAR(state.accepted.X_WE.p.z, 0.04, 1e-12) << "it is not touched";
  EXPECT_EQ(way.moveOther(kTable, {0.0, 0.0, 0.02}), 1.0);
  EXPECT_GE(state.accepted.X_WE.p.z, 0.025 + 0.03);
  EXPECT_LE(state.accepted.X_WE.p.z, 0.04 + 0.02 + 1e-9) << "not farther than what pushes";
  way.placeOther(kTable, {Pose::translation({0.0, 0.0, -0.05}), {}});
  const HeldWay::Gone down = way.goTo(lifted(state, -0.02));
  EXPECT_FALSE(down.blocked) << "the table is where it was";
}

TEST(HalfSpaces, MoveWithTheHand) {
  HalfSpaces spaces;
  haptic::SolverRow row;
  row.normal = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  row.slack = 0.02;
  for (std::size_t i = 0; i < haptic::kMaxRows + 3; ++i) spaces.add(row);
  EXPECT_EQ(spaces.all().size(), haptic::kMaxRows) << "more are ignored";
  spaces.moveBy({0.5, 0.1, -0.015, 0.0, 0.0, 0.0});
  EXPECT_NEAR(spaces.all().front().slack, 0.005, 1e-15);
}

TEST(HeldBoundaries, RiseAsThePairComesApartAndNeverFall) {
  HeldState state = heldBox(0.0004);
  HeldBoundaries boundaries(state);
  HeldWay way(state);
  const std::size_t pair = pairOf(state, kBox);
  const auto boundary = [&] { return state.pairs.feel()[pair].boundary; };
  EXPECT_NEAR(boundary(), 0.0004, 1e-9) << "nearer than its safety distance: it is not pushed out";
  EXPECT_NEAR(state.pairs.feel()[pairOf(state, kCup)].boundary, 0.001, 1e-12);
  way.goTo(lifted(state, 0.0003));
  boundaries.raise();
  EXPECT_NEAR(boundary(), 0.0007, 1e-9);
  way.goTo(lifted(state, -0.0002));
  boundaries.raise();
  EXPECT_NEAR(boundary(), 0.0007, 1e-9) << "it has been farther away";
  way.goTo(lifted(state, 0.01));
  boundaries.raise();
  EXPECT_NEAR(boundary(), 0.001, 1e-12);
  EXPECT_TRUE(boundaries.freeingPlanes().empty());
}

TEST(WaysOut, LeadOutWhatBeganInside) {
  HeldState state = heldBox(-0.004);
  const std::size_t pair = pairOf(state, kBox);
  std::vector<FreeMotion::PairDistance> near;
  state.motion.distances(0.001, near);
  ASSERT_EQ(near.size(), 1U);
  WaysOut ways;
  ways.find(state, near);
  ways.update(state);
  ASSERT_EQ(ways.planes().size(), 1U);
  EXPECT_EQ(ways.planes()[0].pair, pair);
  EXPECT_NEAR(ways.planes()[0].nhat_W.z, 1.0, 1e-6);
  EXPECT_NEAR(ways.planes()[0].gap, 0.0, 1e-12);
  EXPECT_FALSE(state.pairs.feel()[pair].felt) << "the plane stands for it";
  ASSERT_EQ(state.notes.size(), 1U);
  EXPECT_NE(english(state.notes[0]).find("box starts inside table"), std::string::npos) << english(state.notes[0]);
  HeldWay way(state);
  way.goTo(lifted(state, 0.002));
  ways.update(state);
  ASSERT_EQ(ways.planes().size(), 1U) << "still inside";
  way.goTo(lifted(state, 0.01));
  ways.update(state);
  EXPECT_TRUE(ways.planes().empty());
  EXPECT_TRUE(state.pairs.feel()[pair].felt) << "felt as any other";
}

TEST(WaysOut, AHairsBreadthIsNotInside) {
  HeldState state = heldBox(-0.00005);
  std::vector<FreeMotion::PairDistance> near;
  state.motion.distances(0.001, near);
  WaysOut ways;
  ways.find(state, near);
  ways.update(state);
  EXPECT_TRUE(ways.planes().empty());
  EXPECT_TRUE(state.notes.empty());
}

TEST(HeldConstraints, TellTheHandWhereTheTableIs) {
  HeldState state = heldBox(0.02);
  HeldConstraints constraints(state);
  MotionMapping mapping;
  mapping.anchor({}, state.movedFrame());
  const BuiltConstraints built = constraints.make(mapping, {}, {});
  EXPECT_FALSE(built.pending);
  EXPECT_FALSE(constraints.hasAnswer()) << "nothing is searched for elsewhere";
  std::vector<double> gaps(state.pairs.size());
  for (const double z : {0.0, -0.01, -0.019}) {
    pairGaps(built, Pose::translation({0.0, 0.0, z}), gaps);
    EXPECT_NEAR(gaps[pairOf(state, kBox)], 0.019 + z, 1e-9) << "up to the safety distance";
  }
  EXPECT_EQ(constraints.jointFriction(), 0.0);
}

TEST(HeldConstraints, ASurfaceIsFollowedAtItsOffset) {
  HeldState state = heldBox(0.02);
  HeldConstraints constraints(state);
  const auto row = constraints.surface(kTable, 0.005);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->kind, haptic::ConstraintKind::kEquality);
  EXPECT_NEAR(row->gap, 0.015, 1e-9);
  EXPECT_NEAR(row->gradient[2], 1.0, 1e-9);
  EXPECT_FALSE(constraints.surface(kCup, 0.005)) << "it goes along";
  EXPECT_FALSE(constraints.surface(77, 0.005)) << "it does not exist";
  HeldState far = heldBox(0.7);
  HeldConstraints from_far(far);
  EXPECT_FALSE(from_far.surface(kTable, 0.005)) << "farther than half a metre";
}

TEST(JointFriction, OfASolidIsNone) {
  HeldState state = heldBox(0.02);
  JointFriction friction(state.model);
  friction.update(*state.manipulator, state.accepted);
  EXPECT_EQ(friction.felt(), 0.0);
}

}  // namespace
}  // namespace hapticell::manipulation
