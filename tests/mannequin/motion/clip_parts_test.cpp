// SPDX-License-Identifier: Apache-2.0
// How joints of a recorded skeleton are recognised, and how its segments lie in their frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "mannequin/motion/body_frames.h"
#include "mannequin/motion/motion_writer.h"
#include "mannequin/posture/forward_kinematics.h"
#include "tests/mannequin/body/median_man.h"
#include "tests/mannequin/motion/rewritten_motion.h"

namespace hapticell::mannequin {
namespace {

/// The written clip's axes to the world: it is Y up and faces Z.
const dmat3 kWrittenToWorld(dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 0, 0));

std::vector<Posture> somePostures(const Figure& figure) {
  std::vector<Posture> postures;
  for (const char* name : {"standing", "both_hands_forward", "stooping", "standing", "reaching", "overhead"})
    postures.push_back(*libraryPosture(figure, name));
  return postures;
}

MotionClip writtenClip(const Figure& figure, const std::vector<Posture>& postures) {
  const auto clip = readBvh(bvhText(figure, postures, 0.02), "written");
  EXPECT_TRUE(clip) << (clip ? "" : clip.error().message());
  return clip ? *clip : MotionClip{};
}

int jointOf(const MotionClip& clip, Segment segment) {
  return clip.find(segmentInfo(segment).joint);
}

void expectLimbs(const ClipMap& map, const MotionClip& written, const std::string& program) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    const auto arm = [&](Segment left) { return jointOf(written, armSegment(side, left)); };
    const auto leg = [&](Segment left) { return jointOf(written, legSegment(side, left)); };
    EXPECT_EQ(map.hip[i], leg(Segment::kLeftThigh)) << program;
    EXPECT_EQ(map.knee[i], leg(Segment::kLeftShank)) << program;
    EXPECT_EQ(map.ankle[i], leg(Segment::kLeftFoot)) << program;
    EXPECT_EQ(map.collar[i], arm(Segment::kLeftClavicle)) << program;
    EXPECT_EQ(map.shoulder[i], arm(Segment::kLeftUpperArm)) << program;
    EXPECT_EQ(map.elbow[i], arm(Segment::kLeftForearm)) << program;
    EXPECT_EQ(map.hand[i], arm(Segment::kLeftHand)) << program;
  }
  EXPECT_EQ(map.head, jointOf(written, Segment::kHead)) << program;
  EXPECT_EQ(map.root, jointOf(written, Segment::kPelvis)) << program;
  EXPECT_EQ(map.thorax, jointOf(written, Segment::kThorax)) << program << ": where arms and head part";
  EXPECT_EQ(map.neck, jointOf(written, Segment::kLowerNeck)) << program;
  EXPECT_EQ(map.spine[2], map.thorax) << program;
}

/// Names of arm and leg joints of one program: collar, upper arm, forearm, half way down it, hand, thigh, shank, foot,
/// toes; the left ones.
struct ProgramNames {
  std::string program;
  std::array<const char*, 9> left, right;
  const char* head;
};

TEST(ClipMap, KnowsTheNamesOfOtherPrograms) {
  const MotionClip written = writtenClip(medianMan(), somePostures(medianMan()));
  const auto plain = mapJoints(written);
  ASSERT_TRUE(plain) << plain.error().message();
  expectLimbs(*plain, written, "H-Anim");
  EXPECT_EQ(plain->toe[0], jointOf(written, Segment::kLeftToes));
  const ProgramNames programs[] = {
      {"Mixamo",
       {"mixamorig:LeftShoulder", "mixamorig:LeftArm", "mixamorig:LeftForeArm", "mixamorig:LeftTwist",
        "mixamorig:LeftHand", "mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot",
        "mixamorig:LeftToeBase"},
       {"mixamorig:RightShoulder", "mixamorig:RightArm", "mixamorig:RightForeArm", "mixamorig:RightTwist",
        "mixamorig:RightHand", "mixamorig:RightUpLeg", "mixamorig:RightLeg", "mixamorig:RightFoot",
        "mixamorig:RightToeBase"},
       "mixamorig:Head"},
      {"CMU",
       {"lclavicle", "lhumerus", "lradius", "lwrist", "lhand", "lfemur", "ltibia", "lfoot", "ltoes"},
       {"rclavicle", "rhumerus", "rradius", "rwrist", "rhand", "rfemur", "rtibia", "rfoot", "rtoes"},
       "head"},
      {"Biovision",
       {"LeftCollar", "LeftShoulder", "LeftElbow", "LeftTwist", "LeftWrist", "LeftHip", "LeftKnee", "LeftAnkle",
        "LeftToe"},
       {"RightCollar", "RightShoulder", "RightElbow", "RightTwist", "RightWrist", "RightHip", "RightKnee", "RightAnkle",
        "RightToe"},
       "Head"},
      {"Unreal",
       {"clavicle_l", "upperarm_l", "lowerarm_l", "twist_l", "hand_l", "thigh_l", "calf_l", "foot_l", "ball_l"},
       {"clavicle_r", "upperarm_r", "lowerarm_r", "twist_r", "hand_r", "thigh_r", "calf_r", "foot_r", "ball_r"},
       "head"},
      {"Biped",
       {"Bip01 L Clavicle", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Twist", "Bip01 L Hand", "Bip01 L Thigh",
        "Bip01 L Calf", "Bip01 L Foot", "Bip01 L Toe"},
       {"Bip01 R Clavicle", "Bip01 R UpperArm", "Bip01 R Forearm", "Bip01 R Twist", "Bip01 R Hand", "Bip01 R Thigh",
        "Bip01 R Calf", "Bip01 R Foot", "Bip01 R Toe"},
       "Bip01 Head"}};
  constexpr std::array kLimbs = {Segment::kLeftClavicle, Segment::kLeftUpperArm, Segment::kLeftForearm,
                                 Segment::kLeftWrist,    Segment::kLeftHand,     Segment::kLeftThigh,
                                 Segment::kLeftShank,    Segment::kLeftFoot,     Segment::kLeftToes};
  for (const ProgramNames& names : programs) {
    MotionClip clip = written;
    for (std::size_t k = 0; k < kLimbs.size(); ++k) {
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const Segment segment = k < 5 ? armSegment(side, kLimbs[k]) : legSegment(side, kLimbs[k]);
        clip.joints[static_cast<std::size_t>(jointOf(written, segment))].name =
            side == Side::kLeft ? names.left[k] : names.right[k];
      }
    }
    clip.joints[static_cast<std::size_t>(jointOf(written, Segment::kHead))].name = names.head;
    const auto map = mapJoints(clip);
    ASSERT_TRUE(map) << names.program << ": " << map.error().message();
    expectLimbs(*map, written, names.program);
    EXPECT_EQ(map->toe[1], jointOf(written, Segment::kRightToes)) << names.program;
  }
}

TEST(ClipMap, SaysWhichJointIsMissing) {
  MotionClip clip = writtenClip(medianMan(), somePostures(medianMan()));
  clip.joints[static_cast<std::size_t>(jointOf(clip, Segment::kRightShank))].name = "frobnicator";
  const auto map = mapJoints(clip);
  ASSERT_FALSE(map);
  EXPECT_NE(map.error().message().find("right knee"), std::string::npos) << map.error().message();
  EXPECT_NE(map.error().message().find(segmentInfo(Segment::kPelvis).joint), std::string::npos)
      << "and which there are";
}

TEST(BodyFrames, TheNecksBaseIsThatOfTheLowestJointThereIs) {
  ClipPose pose;
  pose.p = {{0, 0, 0}, {1, 0, 0}, {0, 4, 0}, {0, 0, 8}, {0, 2, 2}};
  ClipMap map;
  map.shoulder = {1, 2};
  EXPECT_EQ(neckBase(map, pose), dvec3(0.5, 2.0, 0.0));
  map.collar = {2, 3};
  EXPECT_EQ(neckBase(map, pose), dvec3(0.0, 2.0, 4.0));
  map.neck = 4;
  EXPECT_EQ(neckBase(map, pose), dvec3(0.0, 2.0, 2.0));
}

TEST(BodyFrames, TheRestPoseOfAStandingPersonTellsForwardLeftAndUp) {
  const MotionClip written = writtenClip(medianMan(), somePostures(medianMan()));
  const ClipMap map = *mapJoints(written);
  const auto expectFrame = [&](const MotionClip& clip, const dmat3& expected) {
    const auto frame = restFrame(clip, map);
    ASSERT_TRUE(frame);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length((*frame)[c] - expected[c]), 1e-9) << c;
  };
  const dmat3 forward_z(dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(0, 1, 0));
  expectFrame(written, forward_z);
  const dmat3 turn = test::turnAbout(0, 90.0) * test::turnAbout(2, 180.0);
  expectFrame(test::turnedWhole(written, turn), turn * forward_z);
  MotionClip tangle = written;
  for (ClipJoint& joint : tangle.joints) joint.p_Parent = {0.1, 0.0, 0.0};
  EXPECT_FALSE(restFrame(tangle, map)) << "all bones along x: no person stands like that";
}

TEST(BodyFrames, AreThoseOfTheFigureThatTheClipWasWrittenFrom) {
  const Figure figure = medianMan();
  const std::vector<Posture> postures = somePostures(figure);
  const MotionClip clip = writtenClip(figure, postures);
  const ClipMap map = *mapJoints(clip);
  const BodyFrames frames(clip, map, kWrittenToWorld);
  for (std::size_t f = 0; f < postures.size(); ++f) {
    ClipPose placed;
    placeJoints(clip, clip.frames[f], placed);
    const RecordedBody body = frames.bodyAt(placed);
    const FigurePose pose = forwardKinematics(figure, postures[f]);
    const auto expectSame = [&](const dmat3& R, Segment segment) {
      for (int c = 0; c < 3; ++c)
        EXPECT_LT(glm::length(R[c] - pose[segment].R_WS[c]), 0.02) << segmentInfo(segment).name << " " << f;
    };
    expectSame(body.R_root, Segment::kPelvis);
    expectSame(body.R_thorax, Segment::kThorax);
    expectSame(body.R_head, Segment::kHead);
    EXPECT_LT(glm::length(body.p_root - middleOfHips(pose)), 1e-6);
    EXPECT_LT(glm::length(body.neck - pose[Segment::kLowerNeck].p_WS), 1e-6);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      expectSame(body.R_hand[i], armSegment(side, Segment::kLeftHand));
      expectSame(body.R_foot[i], legSegment(side, Segment::kLeftFoot));
      EXPECT_LT(glm::length(body.knee[i] - pose[legSegment(side, Segment::kLeftShank)].p_WS), 1e-6);
      EXPECT_LT(glm::length(body.elbow[i] - pose[armSegment(side, Segment::kLeftForearm)].p_WS), 1e-6);
      EXPECT_LT(glm::length(body.hand[i] - pose[armSegment(side, Segment::kLeftHand)].p_WS), 1e-6);
    }
  }
}

TEST(BodyFrames, DoNotDependOnHowAProgramTurnsItsJoints) {
  const Figure figure = medianMan();
  const std::vector<Posture> postures = somePostures(figure);
  const MotionClip clip = writtenClip(figure, postures);
  std::vector<dmat3> turns(clip.joints.size(), dmat3(1.0));
  for (std::size_t j = 0; j < turns.size(); ++j) {
    if (!clip.joints[j].is_end) turns[j] = test::turnAbout(static_cast<int>(j % 3), 90.0 * static_cast<double>(j % 4));
  }
  const MotionClip turned = test::reframed(clip, turns);
  const BodyFrames frames(turned, *mapJoints(turned), kWrittenToWorld);
  EXPECT_FALSE(frames.assumptions().empty()) << "the bones at rest are no person's";
  for (std::size_t f = 0; f < postures.size(); ++f) {
    ClipPose placed;
    placeJoints(turned, turned.frames[f], placed);
    const RecordedBody body = frames.bodyAt(placed);
    const FigurePose pose = forwardKinematics(figure, postures[f]);
    EXPECT_LT(glm::length(body.elbow[1] - pose[Segment::kRightForearm].p_WS), 1e-6);
    for (const auto& [R, segment] : {std::pair(body.R_root, Segment::kPelvis), {body.R_thorax, Segment::kThorax}}) {
      for (int c = 0; c < 3; ++c)
        EXPECT_LT(glm::length(R[c] - pose[segment].R_WS[c]), 12.0 * kDegree) << segmentInfo(segment).name << " " << f;
    }
  }
}

}  // namespace
}  // namespace hapticell::mannequin
