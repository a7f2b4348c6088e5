// SPDX-License-Identifier: Apache-2.0
// Ways to draw a mannequin besides one hand: head, both hands apart, on a seat; itself in its way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/shapes/shapes.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/manipulators/mannequin_head.h"
#include "manipulation/manipulators/mannequin_manipulator.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/shape/figure_model.h"
#include "tests/manipulation/manipulators/worker.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;
using Hands = MannequinManipulator::Hands;

std::vector<MannequinBody::Part> partsOf(const workcell::Entity& entity) {
  std::vector<MannequinBody::Part> parts;
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i) {
    if (!entity.robot()->links[i].collisions.empty()) parts.push_back({static_cast<int>(i), {}});
  }
  return parts;
}

mannequin::FigurePose poseOf(const workcell::Entity& entity, const EntityConfiguration& at) {
  return mannequin::forwardKinematics(*entity.figure(), mannequin::toPosture(*entity.figure(), {at.X_WE, at.joints}));
}

TEST(MannequinHead, FollowsAndItsDifferentialTellsHow) {
  const workcell::Entity entity = worker("standing");
  const MannequinHead head(entity.figure(), entity.robot(), false, partsOf(entity));
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  Pose wanted = head.movedFrame(start);
  wanted.p += dvec3(0.04, 0.02, -0.015);
  EntityConfiguration at = start;
  for (int i = 0; i < 10; ++i) at = head.propose(at, wanted, 1.0);
  EXPECT_LT(test::placeError(head.movedFrame(at), wanted), 1e-3);
  constexpr double kStep = 1e-3;
  const auto parts = head.differentiate(at);
  std::vector<Pose> before(parts.size()), after(parts.size());
  head.partPoses(at, before);
  Pose near = head.movedFrame(at);
  near.p.x += kStep;
  head.partPoses(head.propose(at, near, 1.0), after);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const dvec3 told = kStep * parts[k].velocity[0].linear;
    EXPECT_LT(glm::length(after[k].p - before[k].p - told), 2e-4);
  }
}

TEST(MannequinHead, ItsEndIsALimit) {
  const workcell::Entity entity = worker("standing");
  const MannequinHead head(entity.figure(), entity.robot(), true, partsOf(entity));
  EntityConfiguration at{entity.X_WE, entity.joints()};
  Pose far = head.movedFrame(at);
  far.p.x += 0.5;
  for (int i = 0; i < 40; ++i) at = head.propose(at, far, 1.0);
  EXPECT_FALSE(head.limits(at, 0.01, 0.2).empty());
}

TEST(MannequinManipulator, HandsApartGoTheSameWayAndNothingIsHeldBetween) {
  const workcell::Entity entity = worker("both_hands_forward");
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  const MannequinManipulator both(entity.figure(), entity.robot(), Hands::kBothApart, {}, start, partsOf(entity));
  Pose wanted = both.movedFrame(start);
  wanted.p += dvec3(-0.03, 0.02, 0.03);
  const EntityConfiguration moved = both.propose(start, wanted, 1.0);
  const auto before = poseOf(entity, start), after = poseOf(entity, moved);
  for (const auto side : {mannequin::Side::kLeft, mannequin::Side::kRight}) {
    const dvec3 way = mannequin::handPose(after, side).p - mannequin::handPose(before, side).p;
    EXPECT_LT(glm::length(way - dvec3(-0.03, 0.02, 0.03)), 1e-3);
  }
}

TEST(MannequinManipulator, OnASeatThePelvisStays) {
  const workcell::Entity entity = worker("seated");
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  MannequinManipulator::Locks locks;
  locks.on_seat = true;
  const MannequinManipulator hand(entity.figure(), entity.robot(), Hands::kRight, locks, start, partsOf(entity));
  Pose wanted = hand.movedFrame(start);
  wanted.p += dvec3(0.10, 0.0, 0.15);
  EntityConfiguration at = start;
  for (int i = 0; i < 20; ++i) at = hand.propose(at, wanted, 1.0);
  EXPECT_LT(test::placeError(hand.movedFrame(at), wanted), 2e-3);
  EXPECT_LT(test::placeError(at.X_WE, start.X_WE), 1e-6);
}

/// How far the feet of two configurations are from each other, m.
double feetMoved(const workcell::Entity& entity, const EntityConfiguration& from, const EntityConfiguration& to) {
  double worst = 0.0;
  for (const auto side : {mannequin::Side::kLeft, mannequin::Side::kRight})
    worst = std::max(worst, glm::distance(mannequin::footPose(poseOf(entity, from), side).p,
                                          mannequin::footPose(poseOf(entity, to), side).p));
  return worst;
}

TEST(PostureFinder, SolvesAnewWithTheHandAtThePlaceAndTheFeetWhereTheyAre) {
  const workcell::Entity entity = worker("standing");
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  const MannequinManipulator hand(entity.figure(), entity.robot(), Hands::kRight, {}, start, partsOf(entity));
  const PostureFinder* const finder = hand.postureFinder();
  ASSERT_NE(finder, nullptr);
  const mannequin::Posture stands = mannequin::toPosture(*entity.figure(), {start.X_WE, start.joints});
  const dvec3 place = hand.movedFrame(start).p + dvec3(0.35, 0.05, 0.45);
  for (const auto from : {PostureFinder::StartFrom::kPresent, PostureFinder::StartFrom::kUpright}) {
    const auto found = finder->solvedFrom(start, place, from, {});
    ASSERT_FALSE(found.empty());
    double before = 0.0;
    for (const EntityConfiguration& each : found) {
      EXPECT_LT(glm::distance(hand.movedFrame(each).p, place), 1e-3);
      EXPECT_LT(feetMoved(entity, start, each), 3e-4);
      const mannequin::Posture posture = mannequin::toPosture(*entity.figure(), {each.X_WE, each.joints});
      EXPECT_TRUE(mannequin::limitViolations(posture, 1e-4).empty());
      double turns = 0.0;
      for (const double turn : mannequin::turnsBetween(stands, posture)) turns += turn * turn;
      EXPECT_GE(turns, before - 1e-6) << "the nearest first";
      before = turns;
    }
    EXPECT_TRUE(finder->solvedFrom(start, place, from, [] { return true; }).empty()) << "interrupted";
    EXPECT_TRUE(finder->solvedFrom(start, place + dvec3(5.0, 0.0, 0.0), from, {}).empty()) << "out of reach";
  }
}

TEST(PostureFinder, StandsUprightOnTheSameFeetAndBeforeAPlace) {
  const workcell::Entity entity = worker("reaching");
  EntityConfiguration start{entity.X_WE, entity.joints()};
  const double yaw = 0.8;
  const Pose turned{{1.0, -2.0, 0.0}, glm::angleAxis(yaw, dvec3(0.0, 0.0, 1.0))};
  start.X_WE = turned * start.X_WE;
  const MannequinManipulator hand(entity.figure(), entity.robot(), Hands::kRight, {}, start, partsOf(entity));
  const PostureFinder& finder = *hand.postureFinder();
  EXPECT_LT(glm::distance(finder.facing_W(start), dvec3(std::cos(yaw), std::sin(yaw), 0.0)), 0.05);
  const auto upright = finder.upright(start);
  ASSERT_EQ(upright.size(), 2u);
  for (const EntityConfiguration& each : upright) {
    const auto pose = poseOf(entity, each);
    EXPECT_LT(glm::distance(0.5 * (mannequin::footPose(pose, mannequin::Side::kLeft).p +
                                   mannequin::footPose(pose, mannequin::Side::kRight).p),
                            0.5 * (mannequin::footPose(poseOf(entity, start), mannequin::Side::kLeft).p +
                                   mannequin::footPose(poseOf(entity, start), mannequin::Side::kRight).p)),
              1e-3)
        << "between the same feet";
    EXPECT_GT(pose[mannequin::Segment::kThorax].R_WS[2].z, 0.98) << "the trunk is upright";
  }
  const dvec3 place(4.0, 3.0, 1.1);
  const auto before = finder.uprightBefore(start, place);
  ASSERT_EQ(before.size(), 2u);
  for (const EntityConfiguration& each : before) {
    const dvec3 hips = mannequin::middleOfHips(poseOf(entity, each)), facing = finder.facing_W(each);
    const dvec3 way = place - hips;
    EXPECT_GT(glm::dot(dvec3(way.x, way.y, 0.0), facing), 0.2) << "the place is in front";
    EXPECT_LT(glm::length(dvec3(way.x, way.y, 0.0)), 0.8) << "within an arm's length";
    EXPECT_NEAR(each.X_WE.p.z, start.X_WE.p.z, 1e-9) << "on the floor";
  }
  EXPECT_LT(glm::distance(finder.facing_W(before[1]), finder.facing_W(start)), 1e-6) << "or facing as before";
}

/// The centre of mass inside the soles' edge (m; negative: outside) after the right hand was drawn `way`, held as a
/// user takes it.
double marginAfter(const std::vector<workcell::Entity>& cell, const dvec3& way) {
  const auto scene = PreparedScene::prepare(cell, {}, {});
  HoldOptions options;
  options.moved_by = by::Hand{mannequin::Side::kRight};
  auto held = HeldEntity::take(scene, cell.front().id, {}, options, config::Configuration{});
  EXPECT_TRUE(held) << held.error().message();
  MotionMapping mapping;
  const Pose start = (*held)->movedFrame();
  mapping.anchor(start, start);
  for (int i = 1; i <= 60; ++i) (*held)->follow({start.p + (i / 60.0) * way, start.q}, mapping, nullptr);
  const workcell::Entity& figure = cell.front();
  const auto pose = poseOf(figure, (*held)->accepted());
  std::array<mannequin::HandLoad, 2> loads{};
  if (cell.size() > 1 && cell[1].attachment.to == figure.name) loads[1] = {cell[1].contact.mass, {0.0, 0.0, -0.08}};
  const auto support = mannequin::supportPolygon(
      *figure.figure(), {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]});
  return support.margin(glm::dvec2(mannequin::centerOfMass(*figure.figure(), pose, loads)));
}

TEST(HeldMannequin, LiftedFreeItIsNotHeldToBalanceOverFeetThatNothingBears) {
  const dvec3 far_ahead(0.7, 0.0, -0.5);
  workcell::Entity standing = worker("both_hands_forward");
  EXPECT_GT(marginAfter({standing}, far_ahead), -2e-3) << "on the floor";
  workcell::Entity lifted = standing;
  lifted.X_WE.p.z += 0.5;
  EXPECT_LT(marginAfter({lifted}, far_ahead), -0.03) << "in the air";
  EXPECT_GT(marginAfter({lifted, box(8, "platform", {2.0, 2.0, 0.1}, {0.0, 0.0, 0.45})}, far_ahead), -2e-3)
      << "on a platform as high";
}

TEST(HeldMannequin, WhatItsHandCarriesCountsInTheBalance) {
  workcell::Entity standing = worker("both_hands_forward");
  workcell::Entity weight = box(9, "weight", dvec3(0.06), {0.0, 0.0, 0.0});
  weight.attachment = {standing.name, "r_hand", Pose::translation({0.0, 0.0, -0.08})};
  weight.contact.mass = 15.0;
  EXPECT_GT(marginAfter({standing, weight}, {0.45, 0.0, -0.3}), -2e-3) << "15 kg held out";
}

TEST(HeldMannequin, TheHandStopsAtTheOwnChestAndAtATable) {
  const workcell::Entity entity = worker("both_hands_forward");
  const auto scene = PreparedScene::prepare({entity, box(8, "table", {0.6, 0.8, 0.04}, {0.75, 0.0, 0.80})}, {}, {});
  const config::Configuration configuration;
  HoldOptions options;
  options.moved_by = by::Hand{mannequin::Side::kRight};
  // Chest, table, own hip.
  for (const dvec3& way : {dvec3(-0.6, 0.25, 0.0), dvec3(0.1, 0.0, -0.6), dvec3(-0.6, 0.15, -0.18)}) {
    auto held = HeldEntity::take(scene, entity.id, {}, options, configuration);
    ASSERT_TRUE(held) << held.error().message();
    MotionMapping mapping;
    const Pose start = (*held)->movedFrame();
    mapping.anchor(start, start);
    bool blocked = false;
    for (int i = 1; i <= 60; ++i) {
      Pose wanted = start;
      wanted.p += (i / 60.0) * way;
      blocked = (*held)->follow(wanted, mapping, nullptr).blocked || blocked;
    }
    EXPECT_TRUE(blocked);
    std::vector<FreeMotion::PairDistance> near;
    (*held)->distances(1.0, near);
    for (const auto& pair : near) EXPECT_FALSE(pair.result.colliding);
  }
}

}  // namespace
}  // namespace hapticell::manipulation
