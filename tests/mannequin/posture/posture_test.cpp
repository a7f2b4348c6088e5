// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture_file.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

TEST(Posture, MirroredFiguresAreMirrorImages) {
  std::mt19937_64 random(9);
  const Figure figure = *makeFigure({Sex::kMale, 1.8});
  for (int n = 0; n < 50; ++n) {
    Posture posture = randomPosture(random);
    // Heading along x, so that the mirror is the plane y = 0 through the root.
    const dvec3 forward = posture.X_WR.rotate({1, 0, 0});
    posture.X_WR.q = quaternionFromRotationVector({0, 0, -std::atan2(forward.y, forward.x)}) * posture.X_WR.q;
    posture.X_WR.p.y = 0.0;
    const FigurePose a = forwardKinematics(figure, posture), b = forwardKinematics(figure, mirror(posture));
    const auto check = [&](Segment left, Segment right) {
      EXPECT_LT(glm::length(a[left].p_WS * dvec3(1, -1, 1) - b[right].p_WS), 1e-9) << segmentInfo(left).name;
    };
    check(Segment::kHead, Segment::kHead);
    check(Segment::kLeftHand, Segment::kRightHand);
    check(Segment::kRightForearm, Segment::kLeftForearm);
    check(Segment::kLeftToes, Segment::kRightToes);
    const Posture twice = mirror(mirror(posture));
    for (std::size_t i = 0; i < kDofCount; ++i) EXPECT_EQ(twice.angles[i], posture.angles[i]);
  }
}

TEST(Posture, SwappingHandsExchangesTheArmsOnly) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const Posture reaching = *libraryPosture(figure, "reaching");
  const Posture swapped = swapHands(reaching);
  EXPECT_EQ(swapped[Dof::kLeftShoulderFlexion], reaching[Dof::kRightShoulderFlexion]);
  EXPECT_EQ(swapped[Dof::kVt6LeftTurn], reaching[Dof::kVt6LeftTurn]);
  EXPECT_EQ(swapped[Dof::kLeftHipFlexion], reaching[Dof::kLeftHipFlexion]);
}

TEST(Posture, TheLibraryKeepsTheLimitsAndStandsOnTheFloor) {
  for (const NamedFigure& named : boundaryFigures()) {
    for (const LibraryPosture& entry : postureLibrary()) {
      const std::optional<Posture> posture = libraryPosture(named.figure, entry.name);
      ASSERT_TRUE(posture.has_value());
      EXPECT_TRUE(limitViolations(*posture).empty()) << entry.name;
      const FigurePose pose = forwardKinematics(named.figure, *posture);
      for (const SegmentPlace& place : pose.segments) EXPECT_GT(place.p_WS.z, 0.0) << entry.name;
    }
  }
  EXPECT_FALSE(libraryPosture(boundaryFigures()[0].figure, "flying").has_value());
}

TEST(Posture, StandingFeetAreFlatOnTheFloor) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.6});
  const FigurePose pose = forwardKinematics(figure, *libraryPosture(figure, "standing"));
  EXPECT_NEAR(pose[Segment::kLeftFoot].point({0.0, 0.0, figure.sole.z}).z, 0.0, 1e-12);
}

TEST(Posture, ViolatedLimitsAreNamed) {
  Posture posture;
  posture[Dof::kLeftElbowFlexion] = -0.1;
  posture[Dof::kRightShoulderFlexion] = 3.0;
  const auto found = limitViolations(posture);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(english(textOf(found[0])), "l_elbow_flexion is -5.7 deg, limit 0.0 deg");
  EXPECT_EQ(found[1].what.find("r_shoulder"), 0U);
  posture = {};
  posture.gaze = {0.7, -0.4};
  const auto gaze = limitViolations(posture);
  ASSERT_EQ(gaze.size(), 2u);
  EXPECT_EQ(english(textOf(gaze[0])), "gaze_yaw is 40.1 deg, limit 35.0 deg");
  EXPECT_EQ(english(textOf(gaze[1])), "gaze_pitch is -22.9 deg, limit -20.0 deg");
}

TEST(PostureFile, KeepsEveryBit) {
  std::mt19937_64 random(11);
  for (int n = 0; n < 20; ++n) {
    const Posture posture = randomPosture(random);
    const Expected<Posture> again = parsePosture(postureText(posture), "x");
    ASSERT_TRUE(again.has_value()) << again.error().message();
    EXPECT_EQ(again->angles, posture.angles);
    EXPECT_EQ(again->X_WR.p, posture.X_WR.p);
  }
}

TEST(PostureFile, ReadsDegreesAndRefusesWhatItDoesNotKnow) {
  const std::string head = R"({"format":"hapticell-posture","version":1,)";
  const auto read = [&](const std::string& rest) { return parsePosture(head + rest + "}", "p.json"); };
  EXPECT_NEAR(read(R"("unit":"deg","joints":{"l_elbow_flexion":90})")->angles[indexOf(Dof::kLeftElbowFlexion)],
              std::numbers::pi / 2, 1e-12);
  for (const char* bad :
       {R"("joints":{"l_tail":1})", R"("joints":{"l_elbow_flexion":"x"})", R"("joints":{"l_elbow_flexion":99})",
        R"("joints":[1])", R"("unit":"grad")", R"("root":{"position":[1,2]})", R"("root":{"orientation":[1,1,1,1]})",
        R"("root":7)", R"("gaze":[1])"}) {
    const auto posture = read(bad);
    ASSERT_FALSE(posture.has_value()) << bad;
    EXPECT_EQ(posture.error().file, "p.json");
  }
  EXPECT_FALSE(parsePosture("{", "p").has_value());
  EXPECT_FALSE(parsePosture("[]", "p").has_value());
  EXPECT_FALSE(parsePosture(R"({"format":"hapticell-posture","version":2})", "p").has_value());
}

}  // namespace
}  // namespace hapticell::mannequin
