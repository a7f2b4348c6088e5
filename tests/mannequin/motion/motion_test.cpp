// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "bench/mannequin_recorded.h"
#include "mannequin/body/joint_names.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/motion_writer.h"
#include "mannequin/motion/retarget.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/limb_inverse.h"
#include "tests/mannequin/posture/random_postures.h"
#include "tests/support/test_data.h"

namespace hapticell::mannequin {
namespace {

constexpr const char* kSmall = R"(HIERARCHY
ROOT hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT knee
  {
    OFFSET 0 -90 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -90 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.01
0 180 0 0 0 0 0 0 0
10 180 0 90 0 0 0 90 0
)";

double angle(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kDegree;
}

TEST(Bvh, ReadsJointsChannelsAndUnit) {
  const Expected<MotionClip> clip = readBvh(kSmall, "small.bvh");
  ASSERT_TRUE(clip.has_value()) << clip.error().message();
  ASSERT_EQ(clip->joints.size(), 3u);
  EXPECT_EQ(clip->metres_per_unit, 0.01);
  EXPECT_TRUE(clip->joints[2].is_end);
  ClipPose pose;
  placeJoints(*clip, clip->frames[0], pose);
  EXPECT_NEAR(pose.p[2].y, 0.0, 1e-12);
  placeJoints(*clip, clip->frames[1], pose);
  // A quarter turn about z takes -y to +x; at the knee, a quarter turn about x of that frame takes it to -z.
  EXPECT_LT(glm::length(pose.p[1] - dvec3(1.0, 1.8, 0.0)), 1e-12);
  EXPECT_LT(glm::length(pose.p[2] - dvec3(1.0, 1.8, -0.9)), 1e-12);
}

TEST(Bvh, RefusesWhatIsBrokenWithItsLine) {
  const std::string good = kSmall;
  const auto refused = [](const std::string& text) {
    const auto clip = readBvh(text, "x.bvh");
    return clip ? std::string() : clip.error().message();
  };
  EXPECT_NE(refused("").find("HIERARCHY"), std::string::npos);
  EXPECT_NE(refused(good.substr(0, 150)).find("line"), std::string::npos);
  EXPECT_NE(refused(good.substr(0, good.size() - 6)).find("frame 2"), std::string::npos);
  std::string bad = good;
  bad.replace(bad.find("0 -90 0"), 7, "0 x90 0");
  EXPECT_NE(refused(bad).find("line 8"), std::string::npos) << refused(bad);
  bad = good;
  bad.replace(bad.find("Yrotation"), 9, "Wrotation");
  EXPECT_NE(refused(bad).find("Wrotation"), std::string::npos);
  EXPECT_FALSE(readMotionFile("/nonexistent/file.bvh").has_value());
}

bool says(const std::vector<Text>& sentences, const std::string& words) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const Text& each) { return english(each).find(words) != std::string::npos; });
}

TEST(Bvh, LosesNoFrameAndShiftsNoRow) {
  std::string text = kSmall;
  text.replace(text.find("Frames: 2"), 9, "Frames: 1");
  const auto more = readBvh(text, "more.bvh");
  ASSERT_TRUE(more);
  EXPECT_EQ(more->frames.size(), 2u);
  EXPECT_TRUE(says(more->warnings, "states 1 frames but has 2"));
  text.replace(text.find("Frames: 1"), 9, "Frames: 3");
  const auto fewer = readBvh(text, "fewer.bvh");
  ASSERT_FALSE(fewer);
  EXPECT_NE(fewer.error().message().find("ends before frame 3"), std::string::npos) << fewer.error().message();
  // One number short in the first row, one too many in the last: as many as there should be.
  std::string shifted = kSmall;
  shifted.replace(shifted.find("0 180 0 0 0 0 0 0 0"), 19, "0 180 0 0 0 0 0 0");
  shifted.insert(shifted.size() - 1, " 0");
  const auto row = readBvh(shifted, "shifted.bvh");
  ASSERT_FALSE(row);
  EXPECT_NE(row.error().message().find("8 numbers in frame 1"), std::string::npos) << row.error().message();
  EXPECT_NE(row.error().message().find("line 19"), std::string::npos) << row.error().message();
}

TEST(Bvh, ReadsWhatOtherProgramsWrite) {
  const std::string plain = kSmall;
  const auto same = [&](const std::string& text, const char* what) {
    const auto clip = readBvh(text, what);
    ASSERT_TRUE(clip) << what << ": " << clip.error().message();
    ASSERT_EQ(clip->frames.size(), 2u) << what;
    ClipPose pose;
    placeJoints(*clip, clip->frames[1], pose);
    EXPECT_LT(glm::length(pose.p[2] - dvec3(1.0, 1.8, -0.9)), 1e-12) << what;
  };
  same("\xEF\xBB\xBF" + plain, "a byte order mark");
  std::string windows, mac;
  for (const char c : plain) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  same(windows, "lines of Windows");
  same(mac, "lines of an old Mac");
  std::string blanks = plain;
  blanks.replace(blanks.find("JOINT knee"), 10, "JOINT Bip01 L Calf ");
  same(blanks, "blanks in a name");
  EXPECT_EQ(readBvh(blanks, "x")->joints[1].name, "Bip01 L Calf");
  std::string capitals = plain;
  for (std::size_t at = 0; (at = capitals.find("position", at)) != std::string::npos;)
    capitals.replace(at, 8, "POSITION");
  same(capitals, "capital letters");
  std::string one_line = plain;
  one_line.replace(one_line.find("hips\n{"), 6, "hips {");
  same(one_line, "a brace behind the name");
}

TEST(Bvh, SaysClearlyWhatItDoesNotRead) {
  const auto refused = [](const std::string& text) {
    const auto clip = readBvh(text, "x.bvh");
    return clip ? std::string("read") : clip.error().message();
  };
  const std::string plain = kSmall;
  std::string comma = plain;
  comma.replace(comma.find("10 180"), 6, "10,5 180");
  EXPECT_NE(refused(comma).find("decimal points"), std::string::npos) << refused(comma);
  std::string time = plain;
  time.replace(time.find("0.01"), 4, "0,01");
  EXPECT_NE(refused(time).find("decimal points"), std::string::npos) << refused(time);
  std::string two = plain;
  two.insert(two.find("MOTION"), "ROOT other\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n");
  EXPECT_NE(refused(two).find("a second ROOT 'other'"), std::string::npos) << refused(two);
  EXPECT_NE(refused(std::string("\xFF\xFEH\0I\0", 6)).find("UTF-16"), std::string::npos);
}

TEST(Bvh, PositionsInTheChannelsReplaceOffsetsOrAreAddedToThem) {
  const std::string plain = kSmall;
  std::string moved = plain;
  moved.replace(moved.find("CHANNELS 3"), 10, "CHANNELS 6 Xposition Yposition Zposition");
  const auto with = [&](const char* offset, const char* row) {
    std::string text = moved;
    text.replace(text.find("OFFSET 0 -90 0"), 14, offset);
    text.replace(text.find("0 180 0 0 0 0 0 0 0"), 19, std::string("0 180 0 0 0 0 ") + row + " 0 0 0");
    text.replace(text.find("10 180 0 90 0 0 0 90 0"), 22, std::string("10 180 0 90 0 0 ") + row + " 0 90 0");
    const auto clip = readBvh(text, "moved.bvh", 0.01);
    EXPECT_TRUE(clip);
    ClipPose pose;
    placeJoints(*clip, clip->frames[1], pose);
    EXPECT_LT(glm::length(pose.p[2] - dvec3(1.0, 1.8, -0.9)), 1e-9) << offset << ", " << row;
    EXPECT_NEAR(clip->joints[1].p_Parent.y, -0.9, 1e-9);
  };
  with("OFFSET 0 0 0", "0 -90 0");    // All in the channels.
  with("OFFSET 0 -90 0", "0 -90 0");  // Twice the same.
  with("OFFSET 0 -90 0", "0 0 0");    // What is added.
}

constexpr const char* kAsf = R"(:version 1.10
:units
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
begin
  id 1
  name thigh
  direction 0 -1 0
  length 7
  axis 0 0 20 XYZ
  dof rx ry rz
end
:hierarchy
begin
root thigh
end
)";

TEST(Amc, TheWordForTheAnglesUnitCounts) {
  const auto degrees =
      readAsfAmc(kAsf, "a.asf", ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 10 20 30\nthigh 40 50 60\n", "a.amc");
  const auto plain = readAsfAmc(kAsf, "a.asf", "1\nroot 0 0 0 10 20 30\nthigh 40 50 60\n", "a.amc");
  const auto radians = readAsfAmc(kAsf, "a.asf",
                                  ":FULLY-SPECIFIED\n:RADIANS\n1\nroot 0 0 0 0.17453293 0.34906585 0.52359878\n"
                                  "thigh 0.69813170 0.87266463 1.04719755\n",
                                  "a.amc");
  ASSERT_TRUE(degrees && plain && radians);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_GT(std::abs(glm::dot(degrees->frames[0].turns[j], plain->frames[0].turns[j])), 1.0 - 1e-12);
    EXPECT_GT(std::abs(glm::dot(degrees->frames[0].turns[j], radians->frames[0].turns[j])), 1.0 - 1e-12);
  }
  EXPECT_TRUE(says(radians->warnings, "radians, as the AMC states"));
  EXPECT_TRUE(degrees->warnings.empty());
  EXPECT_FALSE(readAsfAmc(kAsf, "a.asf", ":RADIANS\n:DEGREES\n1\nroot 0 0 0 1 2 3\n", "a.amc"));
}

TEST(Amc, FramesFollowEachOther) {
  const std::string first = "1\nroot 0 0 0 0 0 0\nthigh 1 2 3\n";
  const auto gap = readAsfAmc(kAsf, "a.asf", first + "3\nroot 0 0 0 0 0 0\nthigh 1 2 3\n", "a.amc");
  ASSERT_FALSE(gap);
  EXPECT_NE(gap.error().message().find("frame 3 after frame 1"), std::string::npos) << gap.error().message();
  const auto without = readAsfAmc(kAsf, "a.asf", first + "2\nroot 0 0 0 0 0 0\n", "a.amc");
  ASSERT_TRUE(without);
  EXPECT_TRUE(says(without->warnings, "the bone 'thigh' has no values in 1 of 2 frames"));
  EXPECT_FALSE(readAsfAmc(kAsf, "a.asf", "1\nroot 0 0 0 0 0 0\nthigh 1 2 3\nthigh 1 2 3\n", "a.amc"));
}

TEST(JointNames, AreTakenApart) {
  const std::vector<std::string> names{"mixamorig1:LeftUpLeg", "lfemur",   "l_shoulder", "upperarm_r", "RUArm",
                                       "Actor|RightForeArm",   "spine_03", "root"};
  const std::vector<JointName> found = jointNames(names);
  using Of = JointName::Of;
  const std::pair<Of, const char*> expected[] = {
      {Of::kLeft, "upleg"}, {Of::kLeft, "femur"},    {Of::kLeft, "shoulder"}, {Of::kRight, "upperarm"},
      {Of::kRight, "uarm"}, {Of::kRight, "forearm"}, {Of::kMiddle, "spine"},  {Of::kMiddle, "root"}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(found[i].side, expected[i].first) << names[i];
    EXPECT_EQ(found[i].part, expected[i].second) << names[i];
  }
  const std::vector<JointName> biped =
      jointNames({"Bip01", "Bip01 Pelvis", "Bip01 L Thigh", "Bip01 R Calf", "Bip01 Spine1", "Bip01 Head"});
  EXPECT_EQ(biped[2].part, "thigh");
  EXPECT_EQ(biped[3].side, Of::kRight);
  EXPECT_EQ(biped[5].part, "head");
}

TEST(MotionFiles, AMissingJointIsNamed) {
  const auto clip = readBvh(kSmall, "small.bvh");
  const auto motion = recordedMotion(*clip);
  ASSERT_FALSE(motion);
  EXPECT_NE(motion.error().message().find("without a joint for the head (its joints are hips, knee)"),
            std::string::npos)
      << motion.error().message();
}

TEST(MotionFiles, ASkeletonWithoutRootIsRefused) {
  const auto clip = readAsfAmc(
      ":bonedata\nbegin\nid 1 name hip direction 0 1 0 length 1 axis 0 0 0 XYZ\nend\n"
      ":hierarchy\nbegin\nroot hip\nend\n",
      "x.asf", "1\nhip 1\n", "x.amc");
  ASSERT_FALSE(clip.has_value());
  EXPECT_NE(clip.error().message().find(":root is missing"), std::string::npos) << clip.error().message();
}

TEST(MotionFiles, AsfAndBvhOfTheSameClipAgree) {
  for (const char* name : {"mocap/02_01", "mocap/02_06"}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(bvh_file, std::string(name) + ".bvh");
    HAPTICELL_SHARED_DATA_OR_SKIP(amc_file, std::string(name) + ".amc");
    const Expected<MotionClip> bvh = readMotionFile(bvh_file), amc = readMotionFile(amc_file);
    ASSERT_TRUE(bvh.has_value()) << bvh.error().message();
    ASSERT_TRUE(amc.has_value()) << amc.error().message();
    const std::size_t every = (amc->frames.size() + bvh->frames.size() - 1) / bvh->frames.size();
    ClipPose a, b;
    double worst = 0.0;
    for (std::size_t f = 0; f < bvh->frames.size(); f += 7) {
      placeJoints(*bvh, bvh->frames[f], a);
      placeJoints(*amc, amc->frames[f * every], b);
      for (std::size_t i = 0; i < bvh->joints.size(); ++i) {
        const int same = amc->find(bvh->joints[i].name);
        if (same < 0 || bvh->joints[i].is_end) continue;
        worst = std::max(worst, glm::length(a.p[i] - b.p[static_cast<std::size_t>(same)]));
      }
    }
    EXPECT_LT(worst, 1e-4) << name;  // 0.01 cm
  }
}

TEST(MotionFiles, AnglesAreThoseOfTheClipsDescription) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/02_06.bvh");
  const MotionClip clip = *readMotionFile(file);
  ClipPose pose;
  const auto p = [&](const char* name) { return pose.p[static_cast<std::size_t>(clip.find(name))]; };
  double trunk_max = 0.0, knee_max = 0.0, elbow_max = 0.0, arm_max = 0.0;
  int over_20 = 0, over_60 = 0;
  for (std::size_t f = 0; f < clip.frames.size(); ++f) {
    placeJoints(clip, clip.frames[f], pose);
    const dvec3 trunk = p("lowerneck") - 0.5 * (p("lfemur") + p("rfemur"));
    const double inclination = angle(trunk, {0, 1, 0});
    trunk_max = std::max(trunk_max, inclination);
    over_20 += inclination > 20.0 ? 1 : 0;
    over_60 += inclination > 60.0 ? 1 : 0;
    arm_max = std::max(arm_max, angle(p("rradius") - p("rhumerus"), -trunk));
    elbow_max = std::max(elbow_max, angle(p("rradius") - p("rhumerus"), p("rhand") - p("rradius")));
    knee_max = std::max(knee_max, angle(p("rtibia") - p("rfemur"), p("rfoot") - p("rtibia")));
    if (f == 559) {
      EXPECT_NEAR(inclination, 65.7, 0.2);
      EXPECT_NEAR(angle(p("rradius") - p("rhumerus"), -trunk), 58.0, 0.2);
    }
  }
  EXPECT_NEAR(trunk_max, 72.2, 0.2);
  EXPECT_NEAR(arm_max, 136.3, 0.2);
  EXPECT_NEAR(elbow_max, 121.6, 0.2);
  EXPECT_NEAR(knee_max, 125.4, 0.2);
  EXPECT_EQ(over_20, 492);
  EXPECT_EQ(over_60, 175);
}

TEST(Retarget, KeepsTheAnglesOfTheClipAndTheFloor) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/02_06.bvh");
  const MotionClip clip = *readMotionFile(file);
  const Figure figure = *makeFigure({Sex::kFemale, 1.55});
  const Expected<RetargetedMotion> motion = retarget(figure, clip);
  ASSERT_TRUE(motion.has_value()) << motion.error().message();
  ASSERT_EQ(motion->postures.size(), clip.frames.size());
  const RecordedMotion recorded = *recordedMotion(clip);
  double lowest = 1e9;
  for (std::size_t f = 0; f < clip.frames.size(); f += 11) {
    const RecordedBody& body = recorded.bodies[f];
    const FigurePose pose = forwardKinematics(figure, motion->postures[f]);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      const auto at = [&](Segment left) { return pose[armSegment(side, left)].p_WS; };
      EXPECT_LT(angle(at(Segment::kLeftForearm) - at(Segment::kLeftUpperArm), body.elbow[i] - body.shoulder[i]), 0.2);
      EXPECT_LT(angle(at(Segment::kLeftHand) - at(Segment::kLeftForearm), body.hand[i] - body.elbow[i]), 0.2);
      const auto leg = [&](Segment left) { return pose[legSegment(side, left)].p_WS; };
      EXPECT_LT(angle(leg(Segment::kLeftFoot) - leg(Segment::kLeftShank), body.ankle[i] - body.knee[i]), 0.2);
      lowest = std::min(lowest, leg(Segment::kLeftFoot).z + figure.sole.z);
    }
  }
  EXPECT_GT(lowest, -0.2);
  EXPECT_LT(lowest, 0.1);
}

TEST(MotionWriter, WhatIsWrittenAsBvhIsReadBackWithEveryJointInPlace) {
  std::mt19937_64 random(17);
  const Figure figure = *makeFigure({Sex::kMale, 1.82});
  std::vector<Posture> postures;
  for (int n = 0; n < 5; ++n) postures.push_back(randomPosture(random));
  const Expected<MotionClip> clip = readBvh(bvhText(figure, postures, 0.02), "written");
  ASSERT_TRUE(clip.has_value()) << clip.error().message();
  ASSERT_EQ(clip->frames.size(), postures.size());
  EXPECT_EQ(clip->metres_per_unit, 0.01);
  EXPECT_NEAR(clip->frame_time, 0.02, 1e-12);
  for (std::size_t f = 0; f < postures.size(); ++f) {
    ClipPose pose;
    placeJoints(*clip, clip->frames[f], pose);
    const FigurePose ours = forwardKinematics(figure, postures[f]);
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const int joint = clip->find(segmentInfo(static_cast<Segment>(i)).joint);
      ASSERT_GE(joint, 0);
      const dvec3 p = pose.p[static_cast<std::size_t>(joint)];
      EXPECT_LT(glm::length(dvec3(p.z, p.x, p.y) - ours.segments[i].p_WS), 1e-6)
          << segmentInfo(static_cast<Segment>(i)).name;
    }
  }
}

TEST(MotionWriter, WhatIsWrittenComesBackWithItsHands) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  for (const char* name : {"standing", "both_hands_forward", "stooping"}) {
    const Posture posture = *libraryPosture(figure, name);
    const auto clip = readBvh(bvhText(figure, std::vector{posture}, 0.1), "written");
    ASSERT_TRUE(clip);
    const auto motion = retarget(figure, *clip);
    ASSERT_TRUE(motion);
    EXPECT_TRUE(motion->frames_beyond_limit.empty()) << name << ", " << motion->frames_beyond_limit.begin()->first;
    const FigurePose before = forwardKinematics(figure, posture),
                     after = forwardKinematics(figure, motion->postures[0]);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const dmat3 off = glm::transpose(before[armSegment(side, Segment::kLeftHand)].R_WS) *
                        after[armSegment(side, Segment::kLeftHand)].R_WS;
      EXPECT_LT(glm::length(rotationVector(glm::quat_cast(off))), 0.02) << name;
    }
  }
}

TEST(MotionWriter, AnUnusualPostureComesBackToo) {
  // One frame, in which the motion on the whole is nothing usual: the rest position tells how frames lie.
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  Posture posture = *libraryPosture(figure, "standing");
  posture[Dof::kLeftElbowFlexion] = posture[Dof::kRightElbowFlexion] = 0.6;
  posture[Dof::kSkullbaseLeftTurn] = 38.0 * kDegree;
  posture[Dof::kVc7LeftTurn] = posture[Dof::kVc4LeftTurn] = 12.0 * kDegree;
  posture[Dof::kLeftWristFlexion] = 2.0;
  posture[Dof::kRightPronation] = 70.0 * kDegree;
  posture[Dof::kRightClavicleProtraction] = 15.0 * kDegree;
  posture[Dof::kVl1Flexion] = 25.0 * kDegree;
  const auto clip = readBvh(bvhText(figure, std::vector{posture}, 0.1), "written");
  const auto motion = retarget(figure, *clip);
  ASSERT_TRUE(motion);
  const FigurePose before = forwardKinematics(figure, posture), after = forwardKinematics(figure, motion->postures[0]);
  for (const Segment segment : {Segment::kPelvis, Segment::kUpperBack, Segment::kThorax, Segment::kHead,
                                Segment::kLeftHand, Segment::kRightHand, Segment::kLeftFoot, Segment::kRightFoot}) {
    const dmat3 off = glm::transpose(before[segment].R_WS) * after[segment].R_WS;
    EXPECT_LT(glm::length(rotationVector(glm::quat_cast(off))), 0.02) << segmentInfo(segment).name;
  }
}

TEST(MotionWriter, HAnimHasEveryJointOnceWithItsCentre) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.6});
  const std::string text = hanimText(figure, *libraryPosture(figure, "seated"), "worker");
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const std::string define = std::string("DEF=\"") + segmentInfo(static_cast<Segment>(i)).joint + "\"";
    const std::size_t found = text.find(define);
    ASSERT_NE(found, std::string::npos) << define;
    EXPECT_EQ(text.find(define, found + 1), std::string::npos) << define;
  }
  const std::size_t elbow = text.find("center=\"", text.find("DEF=\"l_elbow\"")) + 8;
  double x = 0.0, y = 0.0, z = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str() + elbow, "%lf %lf %lf", &x, &y, &z), 3);
  EXPECT_NEAR(y, measuresOf(figure).at("elbow_height"), 1e-5);
  EXPECT_GT(x, 0.1);  // The left is +x in a figure that faces +z.
}

struct SwivelError {
  double mean_deg = 0.0, elbow_mm = 0.0;
  int samples = 0;
};

/// Shoulder, wrist and hand orientation from the recording, the elbow from our rule.
SwivelError swivelError(const MotionClip& clip) {
  const RecordedMotion recorded = *recordedMotion(clip);
  SwivelError error;
  Figure figure = *makeFigure({Sex::kMale, 1.755});
  const int every = std::max(1, static_cast<int>(std::lround(1.0 / 30.0 / clip.frame_time)));
  for (std::size_t f = 0; f < clip.frames.size(); f += static_cast<std::size_t>(every)) {
    const RecordedBody& body = recorded.bodies[f];
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      const double upper = glm::length(body.elbow[i] - body.shoulder[i]);
      const double fore = glm::length(body.hand[i] - body.elbow[i]);
      if (angle(body.elbow[i] - body.shoulder[i], body.hand[i] - body.elbow[i]) < 20.0) continue;
      figure.p_PS[indexOf(Segment::kLeftForearm)] = {0, 0, -upper};
      figure.p_PS[indexOf(Segment::kLeftWrist)] = figure.p_PS[indexOf(Segment::kLeftHand)] = {0, 0, -0.5 * fore};
      figure.p_PS[indexOf(armSegment(side, Segment::kLeftUpperArm))] = dvec3(0.0);
      const SegmentPlace thorax{body.R_thorax, body.shoulder[i]}, hand{body.R_hand[i], body.hand[i]};
      const ArmProblem problem(figure, side, thorax, thorax, hand);
      const double real = problem.swivelOf(body.elbow[i]), ours = problem.preferredSwivel(48);
      const double off = std::abs(std::remainder(ours - real, 2.0 * std::numbers::pi));
      const dvec3 along = glm::normalize(body.hand[i] - body.shoulder[i]);
      const dvec3 arm = body.elbow[i] - body.shoulder[i];
      const double radius = glm::length(arm - glm::dot(arm, along) * along);
      error.mean_deg += off / kDegree;
      error.elbow_mm += 2000.0 * radius * std::sin(0.5 * off);
      ++error.samples;
    }
  }
  error.mean_deg /= error.samples;
  error.elbow_mm /= error.samples;
  return error;
}

TEST(Swivel, ElbowsAreWhereRecordedPeopleHoldThem) {
  for (const char* name : {"mocap/02_01.bvh", "mocap/02_06.bvh"}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(file, name);
    const SwivelError error = swivelError(*readMotionFile(file));
    EXPECT_GT(error.samples, 50);
    EXPECT_LT(error.mean_deg, 8.0) << name;
    EXPECT_LT(error.elbow_mm, 35.0) << name;
    RecordProperty(std::string(name) + " swivel deg", std::to_string(error.mean_deg));
    std::printf("%s: swivel %.1f deg, elbow %.0f mm, %d samples\n", name, error.mean_deg, error.elbow_mm,
                error.samples);
  }
}

TEST(Recorded, PosturesOfWhichOnlyHandsAndFeetAreToldComeNearTheRealOnes) {
  struct Asked {
    const char* file;
    double swivel_deg, trunk_deg;
  };
  for (const Asked& asked : {Asked{"mocap/02_01.bvh", 10.0, 5.0}, Asked{"mocap/02_06.bvh", 20.0, 15.0}}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(file, asked.file);
    const auto error = bench::replayHandsAndFeet(*makeFigure({Sex::kMale, 1.755}), *readMotionFile(file));
    EXPECT_LT(error.swivel_deg, asked.swivel_deg) << asked.file;
    EXPECT_LT(error.trunk_deg, asked.trunk_deg) << asked.file;
    EXPECT_LT(error.worst_hand_mm, 1.5) << asked.file;
  }
}

}  // namespace
}  // namespace hapticell::mannequin
