// SPDX-License-Identifier: Apache-2.0
// Ways to draw a mannequin besides one hand: head, both hands apart, on a seat, stepping; itself in its way; what it
// sees; and the search for a workplace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/shapes.h"
#include "manipulation/held_entity.h"
#include "manipulation/mannequin_head.h"
#include "manipulation/mannequin_manipulator.h"
#include "manipulation/mannequin_own_pairs.h"
#include "manipulation/mannequin_sight.h"
#include "manipulation/mannequin_steps.h"
#include "manipulation/mannequin_workplace.h"
#include "mannequin/figure_model.h"
#include "mannequin/support_polygon.h"
#include "workcell/entity_source.h"

namespace hapticell::manipulation {
namespace {

using Hands = MannequinManipulator::Hands;
using Kind = MovedBy::Kind;

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

double placeError(const Pose& a, const Pose& b) {
  const Twist off = difference(a, b);
  return std::max(glm::length(off.linear), 0.1 * glm::length(off.angular));
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
  EXPECT_LT(placeError(head.movedFrame(at), wanted), 1e-3);
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
  EXPECT_LT(placeError(hand.movedFrame(at), wanted), 2e-3);
  EXPECT_LT(placeError(at.X_WE, start.X_WE), 1e-6);
}

/// The right hand drawn by `way`, 6 mm a tick, then held there; the feet may step.
struct Walk {
  double left_out = 0.0;  ///< What placeError() leaves.
  std::array<dvec3, 2> gone{};
  double highest = 0.0, lowest = 0.0;  ///< Of any foot above where it stood.
  bool both_lifted = false;
  double nearest = 1e9;       ///< Of both feet, along the floor.
  double least_margin = 1e9;  ///< m of the centre of mass between the sole that stands and where the other one lands.
  double glided = 0.0;        ///< m that a foot went along the floor without being lifted.
  double turned = 0.0;        ///< rad of the feet's heading in the end.
};
/// The hand goes along `path` (m, from where it is), a function of 0 to 1 and of where it is, seen from between the
/// feet.
template <typename Path>
Walk walkAlong(const Path& path, int ticks) {
  const workcell::Entity entity = worker("both_hands_forward");
  const EntityConfiguration start{entity.X_WE, entity.joints};
  MannequinManipulator::Locks locks;
  locks.may_step = true;
  const MannequinManipulator hand(entity.figure, entity.robot, Hands::kRight, locks, start, partsOf(entity));
  const auto before = poseOf(entity, start);
  Pose wanted = hand.movedFrame(start);
  EntityConfiguration at = start;
  Walk walk;
  const dvec3 from = wanted.p;
  FootPlaces feet_before = {mannequin::footPose(before, mannequin::Side::kLeft),
                            mannequin::footPose(before, mannequin::Side::kRight)};
  const FootPlaces feet_taken = feet_before;
  const dvec3 arm = from - 0.5 * (feet_taken[0].p + feet_taken[1].p);
  for (int i = 1; i <= ticks + 300; ++i) {
    wanted.p = from + path(std::min(1.0, static_cast<double>(i) / ticks), arm);
    at = hand.propose(at, wanted, 1.0);
    const auto pose = poseOf(entity, at);
    const FootPlaces feet = {mannequin::footPose(pose, mannequin::Side::kLeft),
                             mannequin::footPose(pose, mannequin::Side::kRight)};
    const auto support = mannequin::supportPolygon(
        *entity.figure, {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]});
    const double margin = support.margin(glm::dvec2(mannequin::centerOfMass(*entity.figure, pose)));
    walk.least_margin = std::min(walk.least_margin, margin);
    for (std::size_t k = 0; k < 2; ++k) {
      const bool stood = feet_before[k].p.z < feet_taken[k].p.z + 1e-4 && feet[k].p.z < feet_taken[k].p.z + 1e-4;
      if (stood)
        walk.glided =
            std::max(walk.glided, std::hypot(feet[k].p.x - feet_before[k].p.x, feet[k].p.y - feet_before[k].p.y));
    }
    feet_before = feet;
    walk.turned = turnedFeet(feet_taken, feet);
    std::array<double, 2> height{};
    for (const auto side : {mannequin::Side::kLeft, mannequin::Side::kRight}) {
      const std::size_t foot = static_cast<std::size_t>(side);
      walk.gone[foot] = mannequin::footPose(pose, side).p - mannequin::footPose(before, side).p;
      height[foot] = walk.gone[foot].z;
      walk.highest = std::max(walk.highest, height[foot]);
      walk.lowest = std::min(walk.lowest, height[foot]);
    }
    walk.both_lifted = walk.both_lifted || std::min(height[0], height[1]) > 1e-3;
    const dvec3 apart =
        mannequin::footPose(pose, mannequin::Side::kLeft).p - mannequin::footPose(pose, mannequin::Side::kRight).p;
    walk.nearest = std::min(walk.nearest, std::hypot(apart.x, apart.y));
  }
  walk.left_out = placeError(hand.movedFrame(at), wanted);
  return walk;
}

Walk walkBy(const dvec3& way) {
  return walkAlong([&](double s, const dvec3&) { return s * way; }, static_cast<int>(glm::length(way) / 0.006));
}

TEST(MannequinManipulator, WithFreeFeetItWalksOneFootAfterTheOther) {
  for (const dvec3& way : {dvec3(1.44, 0.0, 0.0), dvec3(0.0, 1.2, 0.0), dvec3(0.0, -1.2, 0.0), dvec3(1.0, 0.6, 0.0)}) {
    const Walk walk = walkBy(way);  // Far beyond the reach of standing feet.
    EXPECT_LT(walk.left_out, 5e-3);
    EXPECT_GT(walk.highest, 0.03) << "it lifts its feet";
    EXPECT_GT(walk.lowest, -1e-3);
    EXPECT_FALSE(walk.both_lifted);
    EXPECT_GT(walk.nearest, 0.06) << "no foot on the other";
    EXPECT_GT(walk.least_margin, -2e-3) << "between the foot that stands and where the other one lands";
    EXPECT_LT(walk.glided, 2.5e-3);
    for (const dvec3& gone : walk.gone) {
      EXPECT_GT(glm::dot(gone, glm::normalize(way)), 0.2 * glm::length(way));
      EXPECT_LT(std::abs(gone.z), 1e-3) << "on the floor in the end";
    }
  }
}

TEST(MannequinManipulator, WithFreeFeetItStepsRoundToWhatTheHandWorksAt) {
  for (const double side : {1.0, -1.0}) {
    // At arm's length from straight ahead round to the side and a little behind.
    const auto path = [&](double s, const dvec3& arm) {
      return glm::angleAxis(side * 1.9 * s, dvec3(0.0, 0.0, 1.0)) * arm - arm;
    };
    const Walk walk = walkAlong(path, 300);
    EXPECT_LT(walk.left_out, 5e-3) << side;
    EXPECT_GT(side * walk.turned, 0.6) << "the feet came round";
    EXPECT_GT(walk.highest, 0.03);
    EXPECT_FALSE(walk.both_lifted);
    EXPECT_GT(walk.nearest, 0.06);
    EXPECT_GT(walk.least_margin, -2e-3);
    EXPECT_LT(walk.glided, 2.5e-3);
    for (const dvec3& gone : walk.gone) EXPECT_LT(std::abs(gone.z), 1e-3) << "both stand in the end";
  }
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
  options.moved_by.kind = Kind::kRightHand;
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

}  // namespace
}  // namespace hapticell::manipulation
