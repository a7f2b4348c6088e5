// SPDX-License-Identifier: Apache-2.0
// What a recorded body's frames and joints are found with, each part by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mannequin/body/rotations.h"
#include "mannequin/motion/body_frame_finder.h"
#include "mannequin/motion/body_frames.h"
#include "mannequin/motion/frame_vectors.h"
#include "mannequin/motion/joint_centres.h"
#include "mannequin/motion/marker_ways.h"

namespace hapticell::mannequin {
namespace {

TEST(FrameVectors, AFrameIsRightHandedWhateverItIsMadeFrom) {
  for (const dvec3& left : {dvec3(0.0, 1.0, 0.0), dvec3(0.3, 1.0, 0.4), dvec3(0.0, 0.0, 2.0)}) {
    const dmat3 R = frameOf({0.0, 0.0, 2.0}, left);
    EXPECT_NEAR(glm::determinant(R), 1.0, 1e-12);
    EXPECT_LT(glm::length(R[2] - dvec3(0.0, 0.0, 1.0)), 1e-12);
  }
  EXPECT_EQ(nearestAxis({0.1, -0.9, 0.2}), dvec3(0.0, -1.0, 0.0));
  EXPECT_EQ(unit(dvec3(0.0)), dvec3(0.0));
  EXPECT_NEAR(glm::dot(across({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}), dvec3(0.0, 0.0, 1.0)), 0.0, 1e-12);
}

TEST(JointCentres, AKneeLiesInsideItsMarkerSquareToBothBones) {
  const dvec3 hip(0.0, 0.1, 0.9), ankle(0.05, 0.1, 0.1), knee(0.12, 0.1, 0.5);
  constexpr double kOffset = 0.059;
  const dvec3 marker = knee + dvec3(0.0, kOffset, 0.0);
  // A left knee bends backwards.
  const dvec3 outward = hingeOutward(hip, marker, ankle, kOffset, 1.0);
  EXPECT_LT(glm::length(marker - kOffset * outward - knee), 1e-9);
  const dvec3 left = hingeAxis(hip, knee, ankle, -1.0, {0.0, 1.0, 0.0});
  EXPECT_LT(glm::length(left - dvec3(0.0, 1.0, 0.0)), 1e-9);
  // A straight leg has its axis from elsewhere.
  const dvec3 straight = hingeAxis({0, 0, 1}, {0, 0, 0.5}, {0, 0, 0}, -1.0, {0.0, 1.0, 0.3});
  EXPECT_LT(glm::length(straight - dvec3(0.0, 1.0, 0.0)), 1e-9);
  const dvec3 centre = centreInside(hip, {0.0, 0.159, 0.5}, {0.0, 0.2, 0.7}, kOffset);
  EXPECT_NEAR(glm::length(centre - dvec3(0.0, 0.159, 0.5)), kOffset, 1e-12);
  EXPECT_NEAR(glm::dot(centre - hip, centre - dvec3(0.0, 0.159, 0.5)), 0.0, 1e-9);
  EXPECT_LT(glm::length(fromUp({0, 0, 1}, {0, 1, 0})[0] - dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(fromForward({1, 0, 0}, {0, 1, 0})[2] - dvec3(0, 0, 1)), 1e-12);
}

TEST(MarkerWays, AGapIsAStraightLineAndIsTold) {
  MarkerClip clip;
  clip.names = {"A", "B"};
  clip.frame_time = 0.01;
  for (int f = 0; f < 5; ++f) {
    const bool seen = f != 2 && f != 3;
    clip.places.push_back(seen ? std::optional(dvec3(0.1 * f + 0.1, 0.0, 0.0)) : std::nullopt);
    clip.places.emplace_back(dvec3(0.0, 1.0, 0.0));
  }
  const MarkerSet set{.name = "two", .markers = {{"left_finger", {0}}, {"left_toe", {0, 1}}}};
  MarkerWays ways(clip, set);
  ASSERT_TRUE(ways.find().has_value());
  EXPECT_TRUE(ways.has("left_finger"));
  EXPECT_FALSE(ways.has("left_heel"));
  EXPECT_LT(glm::length(ways.at("left_finger", 2) - dvec3(0.3, 0.0, 0.0)), 1e-12);
  EXPECT_LT(glm::length(ways.at("left_toe", 4) - dvec3(0.25, 0.5, 0.0)), 1e-12) << "the mean of both";
  ASSERT_EQ(ways.assumptions().size(), 2u);
  EXPECT_NE(english(ways.assumptions()[0]).find("2 of 5 frames, for at most 0.02 s"), std::string::npos)
      << english(ways.assumptions()[0]);
}

/// A person of bones only, at rest, with every joint's frame turned by R.
MotionClip standing() {
  MotionClip clip;
  const auto joint = [&](const char* name, int parent, const dvec3& p) {
    clip.joints.push_back({name, parent, p});
    return static_cast<int>(clip.joints.size()) - 1;
  };
  const int hips = joint("Hips", -1, {});
  const int chest = joint("Chest", hips, {0.0, 0.0, 0.3});
  const int neck = joint("Neck", chest, {0.0, 0.0, 0.2});
  joint("Head", neck, {0.0, 0.0, 0.1});
  for (const auto& [side, y] : {std::pair{std::string("Left"), 1.0}, {"Right", -1.0}}) {
    int at = joint((side + "UpLeg").c_str(), hips, {0.0, 0.1 * y, 0.0});
    at = joint((side + "Leg").c_str(), at, {0.0, 0.0, -0.4});
    joint((side + "Foot").c_str(), at, {0.0, 0.0, -0.4});
    at = joint((side + "Arm").c_str(), chest, {0.0, 0.2 * y, 0.15});
    at = joint((side + "ForeArm").c_str(), at, {0.0, 0.3 * y, 0.0});
    joint((side + "Hand").c_str(), at, {0.0, 0.25 * y, 0.0});
  }
  ClipFrame frame;
  frame.p_root = {0.0, 0.0, 0.85};
  frame.turns.assign(clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
  clip.frames.assign(3, frame);
  return clip;
}

TEST(BodyFrameFinder, AtARestPositionOfAPersonTheFramesAreItsOwn) {
  const MotionClip clip = standing();
  const auto map = mapJoints(clip);
  ASSERT_TRUE(map.has_value()) << map.error().message();
  const auto rest = restFrame(clip, *map);
  ASSERT_TRUE(rest.has_value());
  EXPECT_LT(glm::length((*rest)[0] - dvec3(1.0, 0.0, 0.0)), 1e-12) << "forwards";
  const SegmentFrames frames = BodyFrameFinder(clip, *map, dmat3(1.0)).find();
  for (const dmat3& R : {frames.root, frames.thorax, frames.head, frames.foot[0], frames.foot[1]}) {
    EXPECT_LT(glm::length(R[0] - dvec3(1.0, 0.0, 0.0)), 1e-9);
    EXPECT_LT(glm::length(R[2] - dvec3(0.0, 0.0, 1.0)), 1e-9);
  }
  EXPECT_FALSE(frames.assumptions.empty()) << "there are no toes";
  ClipPose pose;
  placeJoints(clip, clip.frames[0], pose);
  EXPECT_LT(glm::length(neckBase(*map, pose) - dvec3(0.0, 0.0, 1.35)), 1e-12);
  const BodyFrames body_frames(clip, *map, dmat3(1.0));
  const RecordedBody body = body_frames.bodyAt(pose);
  EXPECT_LT(glm::length(body.p_root - dvec3(0.0, 0.0, 0.85)), 1e-12);
  EXPECT_LT(glm::length(body.knee[0] - dvec3(0.0, 0.1, 0.45)), 1e-12);
  EXPECT_EQ(body_frames.assumptions().size(), frames.assumptions.size());
}

}  // namespace
}  // namespace hapticell::mannequin
