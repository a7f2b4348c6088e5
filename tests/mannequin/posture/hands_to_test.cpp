// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/hands_to.h"

#include <numbers>

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::mannequin {
namespace {

constexpr dvec3 kLeftwards{0.0, 1.0, 0.0}, kUpwards{0.0, 0.0, 1.0};

dvec3 grip(const Figure& figure, const Posture& posture, Side side) {
  return handPose(forwardKinematics(figure, posture), side) * figure.p_HandGrip[static_cast<std::size_t>(side)];
}

TEST(HandsTo, OppositeSidesAreOnTheSurfaceWhereALineThroughThePickedPointLeavesIt) {
  const auto box = geometry::makeBox({0.3, 0.4, 0.2});
  const Pose X_WM = Pose::translation({0.5, 0.0, 1.0});
  const auto sides = oppositeSides(box, X_WM, {0.45, 0.1, 1.1}, kUpwards, kLeftwards);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(glm::length((*sides)[0].p_W - dvec3(0.45, 0.2, 1.09)), 0.0, 1e-9) << "left";
  EXPECT_NEAR(glm::length((*sides)[1].p_W - dvec3(0.45, -0.2, 1.09)), 0.0, 1e-9) << "right";
  EXPECT_NEAR((*sides)[0].into_W.y, -1.0, 1e-9);
  EXPECT_NEAR((*sides)[1].into_W.y, 1.0, 1e-9);
  EXPECT_FALSE(oppositeSides({}, X_WM, {0.45, 0.1, 1.1}, kUpwards, kLeftwards));
}

TEST(HandsTo, ATurnedPartIsTakenAtItsOwnSidesTheLeftHandAtTheLeft) {
  const auto box = geometry::makeBox({0.4, 0.3, 0.2});
  const double turn = std::numbers::pi / 2.0 + 0.3;
  const Pose X_WM{{0.5, 0.0, 1.0}, quaternionFromRotationVector({0.0, 0.0, -turn})};
  const auto sides = oppositeSides(box, X_WM, X_WM * dvec3(0.0, 0.0, 0.1), kUpwards, kLeftwards);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(glm::length((*sides)[0].p_W - (*sides)[1].p_W), 0.4, 1e-9) << "along its length, which lies across";
  EXPECT_GT((*sides)[0].p_W.y, (*sides)[1].p_W.y);
}

TEST(HandsTo, BothHandsAreThereWithTheirPalmsInwards) {
  const Figure figure = medianMan();
  const Posture start = *libraryPosture(figure, "standing");
  const auto sides = oppositeSides(geometry::makeBox({0.3, 0.4, 0.2}), Pose::translation({0.45, 0.0, 1.05}),
                                   {0.4, 0.0, 1.15}, kUpwards, kLeftwards);
  ASSERT_TRUE(sides);
  const HandsReach reach = handsTo(figure, start, {}, {(*sides)[0], (*sides)[1]});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto i = static_cast<std::size_t>(side);
    EXPECT_LT(reach.short_m[i], 2e-3);
    EXPECT_LT(glm::length(grip(figure, reach.posture, side) - (*sides)[i].p_W), 2e-3);
    const Pose hand = handPose(forwardKinematics(figure, reach.posture), side);
    const dvec3 palm = hand.rotate({0.0, side == Side::kLeft ? -1.0 : 1.0, 0.0});
    EXPECT_GT(glm::dot(palm, (*sides)[i].into_W), 0.99);
  }
}

TEST(HandsTo, OneHandGoesAndTheOtherStaysUnasked) {
  const Figure figure = medianMan();
  const Posture start = *libraryPosture(figure, "standing");
  const HandTarget target{{0.4, -0.25, 1.1}, {1.0, 0.0, 0.0}};
  const HandsReach reach = handsTo(figure, start, {}, {std::nullopt, target});
  EXPECT_LT(reach.short_m[1], 2e-3);
  EXPECT_EQ(reach.short_m[0], 0.0);
}

TEST(HandsTo, SaysByHowMuchAFarTargetIsMissed) {
  const Figure figure = medianMan();
  const Posture start = *libraryPosture(figure, "standing");
  const HandTarget target{{2.5, -0.2, 1.2}, {1.0, 0.0, 0.0}};
  PostureTask task;
  const HandsReach reach = handsTo(figure, start, task, {std::nullopt, target});
  EXPECT_GT(reach.short_m[1], 1.0);
  EXPECT_NEAR(reach.short_m[1], glm::length(grip(figure, reach.posture, Side::kRight) - target.p_W), 1e-9);
}

}  // namespace
}  // namespace hapticell::mannequin
