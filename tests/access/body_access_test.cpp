// SPDX-License-Identifier: Apache-2.0
#include "access/body_access.h"

#include "access/grasp_places.h"
#include "access/hand_sweep.h"
#include "tests/access/access_cell.h"

namespace hapticell::access {
namespace {

SweptShape ball(double radius, const dvec3& p_W) {
  return {collision::MeshCollider::build(geometry::makeSphere(radius)), Pose::translation(p_W)};
}

TEST(HandSweep, AHandMustFitThroughTheOpeningWithItsGlove) {
  // A block in a shaft that is 0.14 m wide, carried out at the top by a ball above it.
  const RemovalScene scene = boxedIn(0.02, false).removal("block");
  const auto way = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.3);
  const auto slim = sweepHand(scene, 0, 0, way, {ball(0.04, {0.0, 0.0, 0.04})}, 0.005);
  EXPECT_TRUE(slim.fits);
  EXPECT_NEAR(slim.clearance_m, 0.07 - 0.04 - 0.005, 1e-6);
  const auto wide = sweepHand(scene, 0, 0, way, {ball(0.0655, {0.0, 0.0, 0.04})}, 0.005);
  EXPECT_FALSE(wide.fits);
  EXPECT_EQ(wide.blocked_by.substr(0, 4), "wall");
  EXPECT_LT(wide.clearance_m, 0.0);
}

TEST(HandSweep, MeetsAThinBarOnTheWay) {
  AccessCell cell = boxedIn(0.02, false);
  // A wire beside the block's way, 8 mm from it, in the way of the hand.
  cell.box("wire", {0.3, 1e-3, 1e-3}, {0.0, 0.06, 0.2}, true);
  const RemovalScene scene = cell.removal("block");
  const auto way = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.4);
  const auto sweep = sweepHand(scene, 0, 0, way, {ball(0.02, {0.0, 0.06, 0.08})}, 0.002);
  EXPECT_FALSE(sweep.fits);
  EXPECT_EQ(sweep.blocked_by, "wire");
  EXPECT_NEAR(sweep.at_m, 0.2 - 0.0005 - 0.02 - 0.002 - 0.08, 1e-4);
}

TEST(GraspPlaces, LieOnTheSurfaceAndAToolKeepsTheHandAway) {
  const RemovalScene scene = boxedIn(0.02, false).removal("block");
  const auto places = graspPlaces(scene.units()[0], {});
  EXPECT_EQ(places.size(), 6u);
  EXPECT_NEAR(places[0].p_WPart.z, 0.05, 1e-9);
  EXPECT_NEAR(places[0].target.into_W.z, -1.0, 1e-9);
  const auto far = graspPlaces(scene.units()[0], {.length = 0.25, .radius = 0.005});
  EXPECT_NEAR(far[0].target.p_W.z, 0.30, 1e-9);
  EXPECT_EQ(graspFor(scene.units()[0], {}), "flat");
}

BodyQuestion fourPersons() {
  BodyQuestion question;
  question.bodies = mannequin::boundaryFigures();
  return question;
}

TEST(BodyAccess, EverybodyTakesABlockFromATableAndNobodyFromTheCeiling) {
  const std::atomic<bool> cancel{false};
  for (const double height : {1.0, 3.0}) {
    AccessCell cell;
    cell.box("block", {0.08, 0.08, 0.08}, {0.0, 0.0, height + 0.04});
    cell.box("table", {0.3, 0.3, 0.04}, {0.0, 0.0, height - 0.02}, true);
    const RemovalScene scene = cell.removal("block");
    const auto way = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.15);
    BodyQuestion question = fourPersons();
    if (height > 2.0) question.bodies = {question.bodies.back()};  // The tallest.
    const auto people = bodyAccess(scene, 0, 0, way, question, cancel);
    ASSERT_EQ(people.size(), question.bodies.size());
    for (const BodyAccess& person : people) {
      EXPECT_EQ(person.reached, height < 2.0) << person.name << ": " << person.why;
      if (!person.reached) {
        // At least from the longest reach upwards of anybody, 2.3 m, to the block.
        EXPECT_GT(person.short_m, 0.3);
        continue;
      }
      // The grip is where it was sent, found by the joints alone.
      const auto pose = mannequin::forwardKinematics(person.figure, person.posture);
      const auto side = static_cast<std::size_t>(person.hand);
      const dvec3 p_W = mannequin::handPose(pose, person.hand) * person.figure.p_HandGrip[side];
      EXPECT_LT(glm::length(p_W - person.place.target.p_W), 2.1e-3) << person.name;
      EXPECT_TRUE(mannequin::limitViolations(person.posture, 1e-6).empty());
      EXPECT_GT(person.sight.seen, 0.5);
      EXPECT_GE(person.scores.rula(), 1);
      EXPECT_GT(person.along, 0.0);
    }
  }
}

TEST(BodyAccess, AShieldHidesThePart) {
  const std::atomic<bool> cancel{false};
  AccessCell cell;
  cell.box("block", {0.08, 0.08, 0.08}, {0.0, 0.0, 1.0});
  // A narrow shaft of 0.5 m around it, open at the bottom: nobody looks in from the side.
  for (const double s : {-1.0, 1.0}) {
    cell.box(s < 0.0 ? "west" : "east", {0.01, 0.3, 0.6}, {0.15 * s, 0.0, 1.1}, true);
    cell.box(s < 0.0 ? "south" : "north", {0.3, 0.01, 0.6}, {0.0, 0.15 * s, 1.1}, true);
  }
  const RemovalScene scene = cell.removal("block");
  const auto way = straightAsWay(scene, 0, {0.0, 0.0, -1.0}, scene.wayOut(0, {0.0, 0.0, -1.0}));
  BodyQuestion question = fourPersons();
  question.bodies.resize(1);
  const auto people = bodyAccess(scene, 0, 0, way, question, cancel);
  ASSERT_EQ(people.size(), 1u);
  EXPECT_LT(people[0].sight.seen, 0.5);
  EXPECT_FALSE(people[0].sight.hidden_by.empty());
}

}  // namespace
}  // namespace hapticell::access
