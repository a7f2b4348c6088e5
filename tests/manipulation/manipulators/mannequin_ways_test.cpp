// SPDX-License-Identifier: Apache-2.0
// Ways to draw a mannequin besides one hand: head, both hands apart, on a seat; itself in its way; what it
// sees; and the search for a workplace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/shapes/shapes.h"
#include "manipulation/checks/mannequin_sight.h"
#include "manipulation/checks/mannequin_workplace.h"
#include "manipulation/checks/workplace_check.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/manipulators/mannequin_head.h"
#include "manipulation/manipulators/mannequin_manipulator.h"
#include "manipulation/scene/mannequin_own_pairs.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/shape/figure_model.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using Hands = MannequinManipulator::Hands;

workcell::Entity worker(const char* posture) {
  Diagnostics diagnostics;
  workcell::Entity entity = *workcell::EntityLoader(".").load("mannequin:male:50", 1.0, diagnostics);
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure, *mannequin::libraryPosture(*entity.figure, posture));
  entity.X_WE = model.X_WE;
  entity.joints = model.joints;
  return entity;
}

workcell::Entity box(workcell::EntityId id, const char* name, const dvec3& size, const dvec3& p_W) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.mesh = std::make_shared<geometry::TriangleMesh>(geometry::makeBox(size));
  entity.X_WE.p = p_W;
  return entity;
}

std::vector<MannequinBody::Part> partsOf(const workcell::Entity& entity) {
  std::vector<MannequinBody::Part> parts;
  for (std::size_t i = 0; i < entity.robot->links.size(); ++i) {
    if (!entity.robot->links[i].collisions.empty()) parts.push_back({static_cast<int>(i), {}});
  }
  return parts;
}

mannequin::FigurePose poseOf(const workcell::Entity& entity, const EntityConfiguration& at) {
  return mannequin::forwardKinematics(*entity.figure, mannequin::toPosture(*entity.figure, {at.X_WE, at.joints}));
}

TEST(MannequinHead, FollowsAndItsDifferentialTellsHow) {
  const workcell::Entity entity = worker("standing");
  const MannequinHead head(entity.figure, entity.robot, false, partsOf(entity));
  const EntityConfiguration start{entity.X_WE, entity.joints};
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
  const MannequinHead head(entity.figure, entity.robot, true, partsOf(entity));
  EntityConfiguration at{entity.X_WE, entity.joints};
  Pose far = head.movedFrame(at);
  far.p.x += 0.5;
  for (int i = 0; i < 40; ++i) at = head.propose(at, far, 1.0);
  EXPECT_FALSE(head.limits(at, 0.01, 0.2).empty());
}

TEST(MannequinManipulator, HandsApartGoTheSameWayAndNothingIsHeldBetween) {
  const workcell::Entity entity = worker("both_hands_forward");
  const EntityConfiguration start{entity.X_WE, entity.joints};
  const MannequinManipulator both(entity.figure, entity.robot, Hands::kBothApart, {}, start, partsOf(entity));
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
  const EntityConfiguration start{entity.X_WE, entity.joints};
  MannequinManipulator::Locks locks;
  locks.on_seat = true;
  const MannequinManipulator hand(entity.figure, entity.robot, Hands::kRight, locks, start, partsOf(entity));
  Pose wanted = hand.movedFrame(start);
  wanted.p += dvec3(0.10, 0.0, 0.15);
  EntityConfiguration at = start;
  for (int i = 0; i < 20; ++i) at = hand.propose(at, wanted, 1.0);
  EXPECT_LT(test::placeError(hand.movedFrame(at), wanted), 2e-3);
  EXPECT_LT(test::placeError(at.X_WE, start.X_WE), 1e-6);
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
  if (cell.size() > 1 && cell[1].attachment.to == figure.name) loads[1] = {cell[1].mass, {0.0, 0.0, -0.08}};
  const auto support = mannequin::supportPolygon(
      *figure.figure, {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]});
  return support.margin(glm::dvec2(mannequin::centerOfMass(*figure.figure, pose, loads)));
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
  weight.mass = 15.0;
  EXPECT_GT(marginAfter({standing, weight}, {0.45, 0.0, -0.3}), -2e-3) << "15 kg held out";
}

TEST(MannequinOwnPairs, HandsMeetTheBodyButNotTheirOwnArm) {
  EXPECT_TRUE(isOwnPairOfMannequin("l_hand", mannequin::segmentInfo(mannequin::Segment::kThorax).name));
  EXPECT_TRUE(isOwnPairOfMannequin(mannequin::segmentInfo(mannequin::Segment::kHead).name, "r_hand"));
  EXPECT_TRUE(isOwnPairOfMannequin("l_hand", "r_hand"));
  for (const auto segment :
       {mannequin::Segment::kPelvis, mannequin::Segment::kLeftThigh, mannequin::Segment::kRightFoot}) {
    EXPECT_TRUE(isOwnPairOfMannequin("l_hand", mannequin::segmentInfo(segment).name));
    EXPECT_TRUE(isOwnPairOfMannequin(mannequin::segmentInfo(segment).name, "l_index3"));
  }
  EXPECT_TRUE(isOwnPairOfMannequin("l_index3", "r_hand"));
  EXPECT_FALSE(isOwnPairOfMannequin("l_index3", "l_hand"));
  EXPECT_FALSE(isOwnPairOfMannequin("l_index3", "r_index3"));
  const char* upper = mannequin::segmentInfo(mannequin::Segment::kLeftUpperArm).name;
  EXPECT_FALSE(isOwnPairOfMannequin("l_hand", upper));
  EXPECT_FALSE(isOwnPairOfMannequin(upper, mannequin::segmentInfo(mannequin::Segment::kThorax).name));
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

TEST(TargetSight, AWallHidesWhatIsBehindIt) {
  const workcell::Entity entity = worker("standing");
  const workcell::Entity target = box(8, "target", dvec3(0.2), {2.0, 0.0, 1.6});
  const auto posture = mannequin::toPosture(*entity.figure, {entity.X_WE, entity.joints});
  const auto free = PreparedScene::prepare({entity, target}, {}, {});
  const TargetSight seen = sightOfTarget(*free, entity, posture, 8);
  EXPECT_NEAR(seen.seen, 1.0, 1e-12);
  EXPECT_NEAR(seen.distance, 1.9, 0.15);
  EXPECT_NE(seen.zone, mannequin::VisionZone::kOutside);
  const auto walled =
      PreparedScene::prepare({entity, target, box(9, "wall", {0.02, 2.0, 2.0}, {1.0, 0.0, 1.5})}, {}, {});
  const TargetSight hidden = sightOfTarget(*walled, entity, posture, 8);
  EXPECT_NEAR(hidden.seen, 0.0, 1e-12);
  EXPECT_EQ(hidden.hidden_by, "wall");
  EXPECT_EQ(hidden.clearance, 0.0);
}

TEST(WorkplaceSearch, MovesTheChosenPartsWithWhatIsAttachedAndNothingElse) {
  WorkplaceQuestion question;
  workcell::Entity vise = box(9, "vise", {0.1, 0.1, 0.1}, {0.8, 0.0, 0.66}),
                   jaw = box(10, "jaw", {0.02, 0.1, 0.02}, {});
  vise.attachment.to = "table";
  jaw.attachment.to = "vise";
  question.entities = {jaw, worker("both_hands_forward"), vise, box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60}),
                       box(11, "shelf", {0.5, 0.1, 0.04}, {1.20, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9, 8}));
  question.station = {9};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9}));
  question.station = {7};
  const std::atomic<bool> cancel{false};
  EXPECT_FALSE(searchWorkplace(question, {}, cancel)) << "the mannequin does not move itself";
}

TEST(WorkplaceSearch, FindsAPlaceRefusesNonsenseAndCanBeCancelled) {
  WorkplaceQuestion question;
  question.entities = {worker("both_hands_forward"), box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  question.rise_from = question.away_from = -0.1;
  question.rise_to = question.away_to = 0.1;
  question.rise_step = question.away_step = 0.1;
  std::atomic<bool> cancel{false};
  std::atomic<int> told{0};
  const auto map = searchWorkplace(
      question, [&](double) { ++told; }, cancel);
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(map->cells.size(), 9u);
  EXPECT_EQ(told, 9);
  EXPECT_TRUE(map->is_complete);
  ASSERT_GE(map->best, 0);
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  for (const WorkplaceCell& cell : map->cells) {
    if (cell.worst > 0) {
      EXPECT_LE(best.worst, cell.worst);
    } else {
      EXPECT_FALSE(cell.why.empty());
    }
  }
  const auto again = searchWorkplace(question, {}, cancel);
  EXPECT_EQ(again->best, map->best) << "whatever thread took which cell";
  cancel = true;
  EXPECT_FALSE(searchWorkplace(question, {}, cancel)->is_complete);
  cancel = false;
  question.station = {99};
  EXPECT_FALSE(searchWorkplace(question, {}, cancel));
  question.station = {8};
  question.rise_step = 0.0;
  EXPECT_FALSE(searchWorkplace(question, {}, cancel));
}

TEST(WorkplaceSearch, WhatItPromisesIsMeasuredOnThePostures) {
  WorkplaceQuestion question;
  question.entities = {worker("both_hands_forward"), box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  question.rise_from = question.away_from = -0.1;
  question.rise_to = question.away_to = 0.1;
  question.rise_step = question.away_step = 0.2;
  const std::atomic<bool> cancel{false};
  const auto map = searchWorkplace(question, {}, cancel);
  ASSERT_TRUE(map && map->best >= 0);
  for (const WorkplaceCell& cell : map->cells) {
    EXPECT_EQ(cell.postures.size(), cell.worst > 0 ? 4u : 0u);
    if (cell.worst == 0) continue;
    const Promises kept = workplacePromises(question, cell, movedCell(question, cell));
    EXPECT_TRUE(kept.areKept()) << kept.missed("").message();
    EXPECT_EQ(kept.list.size(), 16u);
  }
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  const auto worstOf = [&](const WorkplaceCell& place, const std::vector<workcell::Entity>& after) {
    const Promises promises = workplacePromises(question, place, after);
    return promises.areKept() ? std::string() : promises.worst()->name + ' ' + promises.worst()->place;
  };
  const auto after = movedCell(question, best);
  WorkplaceCell place = best;
  place.rula[2] -= 1;
  EXPECT_EQ(worstOf(place, after), "rula_P50M P50M");
  place = best, place.rise += 0.01;
  EXPECT_NE(worstOf(place, after).find("hands_"), std::string::npos);
  place = best, place.postures[3].X_WR.p.x -= 0.01;
  EXPECT_EQ(worstOf(place, after), "hands_P95M P95M");
  place = best, place.postures.pop_back();
  EXPECT_EQ(worstOf(place, after), "bodies ");
  auto blocked = after;  // A post where the trunk is.
  blocked.push_back(box(12, "post", {0.1, 0.1, 2.0}, {best.postures[0].X_WR.p.x, best.postures[0].X_WR.p.y, 1.0}));
  EXPECT_NE(worstOf(best, blocked).find(" in post"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::manipulation
