// SPDX-License-Identifier: Apache-2.0
// One motion, written as different programs do: the scores are those of the person, not of the program.
#include <gtest/gtest.h>

#include "mannequin/ergonomics/advice/motion_scores.h"
#include "mannequin/ergonomics/scores/figure_measurement.h"
#include "mannequin/motion/retarget.h"
#include "tests/mannequin/motion/rewritten_motion.h"
#include "tests/support/test_data.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::MotionClip;
using mannequin::MotionReading;
using mannequin::Side;
using namespace hapticell::test;

struct Written {
  std::string how;
  std::string text;
  bool same_places = true;  ///< No joint is left out.
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Names of CMU's joints in another program's words.
std::string named(const std::map<std::string, std::string>& words, const std::string& name) {
  const std::string small = lower(name);
  const auto whole = words.find(small);
  if (whole != words.end()) return whole->second;
  const auto part = words.find(small.substr(1));
  if (part == words.end() || (small[0] != 'l' && small[0] != 'r')) return name;
  std::string result = part->second;
  const std::string side = small[0] == 'l' ? words.at("@l") : words.at("@r");
  return result.replace(result.find('@'), 1, side);
}

const std::map<std::string, std::string> kMixamo{{"@l", "Left"},
                                                 {"@r", "Right"},
                                                 {"root", "Hips"},
                                                 {"lowerback", "Spine"},
                                                 {"upperback", "Spine1"},
                                                 {"thorax", "Spine2"},
                                                 {"lowerneck", "Neck"},
                                                 {"upperneck", "Neck1"},
                                                 {"head", "Head"},
                                                 {"femur", "@UpLeg"},
                                                 {"tibia", "@Leg"},
                                                 {"foot", "@Foot"},
                                                 {"toes", "@ToeBase"},
                                                 {"clavicle", "@Shoulder"},
                                                 {"humerus", "@Arm"},
                                                 {"radius", "@ForeArm"},
                                                 {"wrist", "@ForeArmRoll"},
                                                 {"hand", "@Hand"},
                                                 {"fingers", "@HandMiddle1"},
                                                 {"thumb", "@HandThumb1"}};
const std::map<std::string, std::string> kMotive{{"@l", "L"},
                                                 {"@r", "R"},
                                                 {"root", "Hip"},
                                                 {"lowerback", "Ab"},
                                                 {"upperback", "Ab2"},
                                                 {"thorax", "Chest"},
                                                 {"lowerneck", "Neck"},
                                                 {"upperneck", "Neck2"},
                                                 {"head", "Head"},
                                                 {"femur", "@Thigh"},
                                                 {"tibia", "@Shin"},
                                                 {"foot", "@Foot"},
                                                 {"toes", "@Toe"},
                                                 {"clavicle", "@Shoulder"},
                                                 {"humerus", "@UArm"},
                                                 {"radius", "@FArm"},
                                                 {"wrist", "@FArmTwist"},
                                                 {"hand", "@Hand"},
                                                 {"fingers", "@Middle1"},
                                                 {"thumb", "@Thumb1"}};
const std::map<std::string, std::string> kBiovision{
    {"@l", "Left"},         {"@r", "Right"},         {"root", "Hips"},         {"lowerback", "LowerBack"},
    {"upperback", "Chest"}, {"thorax", "Chest2"},    {"lowerneck", "Neck"},    {"upperneck", "Neck1"},
    {"head", "Head"},       {"femur", "@Hip"},       {"tibia", "@Knee"},       {"foot", "@Ankle"},
    {"toes", "@Toe"},       {"clavicle", "@Collar"}, {"humerus", "@Shoulder"}, {"radius", "@Elbow"},
    {"wrist", "@Forearm"},  {"hand", "@Wrist"},      {"fingers", "@Fingers"},  {"thumb", "@Thumb"}};
const std::map<std::string, std::string> kBiped{{"@l", "L"},
                                                {"@r", "R"},
                                                {"root", "Pelvis"},
                                                {"lowerback", "Spine"},
                                                {"upperback", "Spine1"},
                                                {"thorax", "Spine2"},
                                                {"lowerneck", "Neck"},
                                                {"upperneck", "Neck1"},
                                                {"head", "Head"},
                                                {"femur", "@ Thigh"},
                                                {"tibia", "@ Calf"},
                                                {"foot", "@ Foot"},
                                                {"toes", "@ Toe0"},
                                                {"clavicle", "@ Clavicle"},
                                                {"humerus", "@ UpperArm"},
                                                {"radius", "@ Forearm"},
                                                {"wrist", "@ ForeTwist"},
                                                {"hand", "@ Hand"},
                                                {"fingers", "@ Finger2"},
                                                {"thumb", "@ Finger0"}};
const std::map<std::string, std::string> kUnreal{{"@l", "l"},
                                                 {"@r", "r"},
                                                 {"root", "pelvis"},
                                                 {"lowerback", "spine_01"},
                                                 {"upperback", "spine_02"},
                                                 {"thorax", "spine_03"},
                                                 {"lowerneck", "neck_01"},
                                                 {"upperneck", "neck_02"},
                                                 {"head", "head"},
                                                 {"femur", "thigh_@"},
                                                 {"tibia", "calf_@"},
                                                 {"foot", "foot_@"},
                                                 {"toes", "ball_@"},
                                                 {"clavicle", "clavicle_@"},
                                                 {"humerus", "upperarm_@"},
                                                 {"radius", "lowerarm_@"},
                                                 {"wrist", "lowerarm_twist_01_@"},
                                                 {"hand", "hand_@"},
                                                 {"fingers", "middle_01_@"},
                                                 {"thumb", "thumb_01_@"}};

const std::map<std::string, std::string> kSmpl{{"@l", "L"},
                                               {"@r", "R"},
                                               {"root", "Pelvis"},
                                               {"lowerback", "Spine1"},
                                               {"upperback", "Spine2"},
                                               {"thorax", "Spine3"},
                                               {"lowerneck", "Neck"},
                                               {"upperneck", "Neck2"},
                                               {"head", "Head"},
                                               {"femur", "@_Hip"},
                                               {"tibia", "@_Knee"},
                                               {"foot", "@_Ankle"},
                                               {"toes", "@_Foot"},
                                               {"clavicle", "@_Collar"},
                                               {"humerus", "@_Shoulder"},
                                               {"radius", "@_Elbow"},
                                               {"wrist", "@_ElbowTwist"},
                                               {"hand", "@_Wrist"},
                                               {"fingers", "@_Hand"},
                                               {"thumb", "@_Thumb"}};
const std::map<std::string, std::string> kXsens{{"@l", "Left"},
                                                {"@r", "Right"},
                                                {"root", "Hips"},
                                                {"lowerback", "L5"},
                                                {"upperback", "L3"},
                                                {"thorax", "T8"},
                                                {"lowerneck", "Neck"},
                                                {"upperneck", "Neck2"},
                                                {"head", "Head"},
                                                {"femur", "@UpperLeg"},
                                                {"tibia", "@LowerLeg"},
                                                {"foot", "@Foot"},
                                                {"toes", "@Toe"},
                                                {"clavicle", "@Shoulder"},
                                                {"humerus", "@UpperArm"},
                                                {"radius", "@ForeArm"},
                                                {"wrist", "@ForeArmTwist"},
                                                {"hand", "@Hand"},
                                                {"fingers", "@Fingers"},
                                                {"thumb", "@Thumb"}};
const std::map<std::string, std::string> kMakeHuman{{"@l", "L"},
                                                    {"@r", "R"},
                                                    {"root", "root"},
                                                    {"lowerback", "spine05"},
                                                    {"upperback", "spine03"},
                                                    {"thorax", "spine01"},
                                                    {"lowerneck", "neck01"},
                                                    {"upperneck", "neck02"},
                                                    {"head", "head"},
                                                    {"femur", "upperleg01.@"},
                                                    {"tibia", "lowerleg01.@"},
                                                    {"foot", "foot.@"},
                                                    {"toes", "toe1-1.@"},
                                                    {"clavicle", "clavicle.@"},
                                                    {"humerus", "upperarm01.@"},
                                                    {"radius", "lowerarm01.@"},
                                                    {"wrist", "lowerarm02.@"},
                                                    {"hand", "wrist.@"},
                                                    {"fingers", "finger3-1.@"},
                                                    {"thumb", "finger1-1.@"}};

std::vector<Written> writtenWays(const MotionClip& clip) {
  std::vector<Written> ways;
  const auto way = [&](const std::string& how, const MotionClip& written, double unit = 0.01, bool places = false) {
    ways.push_back({how, BvhText(written, unit, places).text()});
  };
  const auto with = [&](const std::map<std::string, std::string>& words, const MotionClip& c,
                        const std::string& before) {
    return renamed(c, [&](const std::string& name) { return before + named(words, name); });
  };
  const MotionClip along = reframed(clip, bonesAlongX(clip));
  way("bones along x", along);
  way("Rokoko", with(kMixamo, along, ""));
  way("Rokoko with a namespace", with(kMixamo, along, "Actor 1:"));
  way("LAFAN1, bones along x, z up", turnedWhole(with(kMixamo, along, ""), turnAbout(0, 90.0)));
  way("Motive", with(kMotive, along, "Skeleton_"), 1.0);
  way("Mixamo", with(kMixamo, clip, "mixamorig:"));
  way("Mixamo, second figure, metres", with(kMixamo, clip, "mixamorig7:"), 1.0);
  way("Biovision in inches", with(kBiovision, clip, ""), 0.0254);
  way("Biped, names with blanks", with(kBiped, clip, "Bip01 "), 0.0254);
  way("Unreal, z up, facing y", turnedWhole(with(kUnreal, along, ""), turnAbout(2, 90.0) * turnAbout(0, 90.0)));
  way("SMPL", with(kSmpl, clip, ""));
  way("Xsens, bones along x", with(kXsens, along, "Actor:"));
  way("MakeHuman in decimetres, z up", turnedWhole(with(kMakeHuman, clip, ""), turnAbout(0, 90.0)), 0.1);
  way("the hips' frame by 90 about x", reframed(clip, onlyFrameOf(clip, "root", turnAbout(0, 90.0))));
  way("the hips' frame by 180 about y", reframed(clip, onlyFrameOf(clip, "root", turnAbout(1, 180.0))));
  way("the head's frame by 20 about x", reframed(clip, onlyFrameOf(clip, "head", turnAbout(0, 20.0))));
  way("the head's frame by -20 about x", reframed(clip, onlyFrameOf(clip, "head", turnAbout(0, -20.0))));
  way("the chest's frame by 90 about z", reframed(clip, onlyFrameOf(clip, "thorax", turnAbout(2, 90.0))));
  way("facing x", turnedWhole(clip, turnAbout(1, 90.0)));
  way("facing -z", turnedWhole(clip, turnAbout(1, 180.0)));
  way("z up", turnedWhole(clip, turnAbout(0, 90.0)));
  way("-y up", turnedWhole(clip, turnAbout(0, 180.0)));
  way("x up", turnedWhole(clip, turnAbout(2, -90.0)));
  way("z up, feet and hands along x", turnedWhole(along, turnAbout(0, 90.0)));
  way("places in the channels", clip, 0.01, true);
  return ways;
}

double wrapped(double degrees) {
  return std::abs(std::remainder(degrees, 360.0));
}

/// The greatest difference of any angle that a score asks for, over all frames and both arms, with its name.
std::pair<double, std::string> differenceOf(const mannequin::RecordedMotion& a, const mannequin::RecordedMotion& b) {
  const auto figure = *mannequin::makeFigure({});
  const auto ma = mannequin::retarget(figure, a), mb = mannequin::retarget(figure, b);
  std::pair<double, std::string> worst{0.0, ""};
  if (!ma || !mb || ma->postures.size() != mb->postures.size()) return {1e9, "frames"};
  for (std::size_t f = 0; f < ma->postures.size(); ++f) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto x = measure(figure, ma->postures[f], forwardKinematics(figure, ma->postures[f]), side);
      const auto y = measure(figure, mb->postures[f], forwardKinematics(figure, mb->postures[f]), side);
      const std::pair<const char*, double> all[] = {
          {"upper arm flexion", x.upper_arm_flexion - y.upper_arm_flexion},
          {"upper arm abduction", x.upper_arm_abduction - y.upper_arm_abduction},
          {"lower arm flexion", x.lower_arm_flexion - y.lower_arm_flexion},
          {"wrist flexion", x.wrist_flexion - y.wrist_flexion},
          {"wrist deviation", x.wrist_deviation - y.wrist_deviation},
          {"wrist twist", 80.0 * (std::abs(x.wrist_twist_share) - std::abs(y.wrist_twist_share))},
          {"neck flexion", x.neck_flexion - y.neck_flexion},
          {"neck twist", x.neck_twist - y.neck_twist},
          {"neck side bend", x.neck_side_bend - y.neck_side_bend},
          {"trunk", std::abs(x.trunk_flexion) - std::abs(y.trunk_flexion)},
          {"trunk twist", x.trunk_twist - y.trunk_twist},
          {"trunk side bend", x.trunk_side_bend - y.trunk_side_bend},
          {"knee", x.knee_flexion - y.knee_flexion},
      };
      for (const auto& [name, difference] : all) {
        if (wrapped(difference) > worst.first)
          worst = {wrapped(difference), std::string(name) + " in frame " + std::to_string(f)};
      }
    }
  }
  return worst;
}

mannequin::RecordedMotion motionOf(const std::string& text, const std::string& how) {
  const auto clip = mannequin::readBvh(text, how);
  EXPECT_TRUE(clip) << how << ": " << (clip ? "" : clip.error().message());
  if (!clip) return {};
  const auto motion = mannequin::recordedMotion(*clip);
  EXPECT_TRUE(motion) << how << ": " << (motion ? "" : motion.error().message());
  return motion ? *motion : mannequin::RecordedMotion{};
}

void expectSameScores(const MotionClip& clip) {
  const auto plain = motionOf(BvhText(clip).text(), "plain");
  const auto figure = *mannequin::makeFigure({});
  for (const Written& way : writtenWays(clip)) {
    const auto motion = motionOf(way.text, way.how);
    ASSERT_EQ(motion.bodies.size(), clip.frames.size()) << way.how;
    const auto [worst, where] = differenceOf(plain, motion);
    EXPECT_LT(worst, 2.0) << way.how << ": " << where;
    for (const MotionMethod method : {MotionMethod::kRula, MotionMethod::kReba, MotionMethod::kOwas}) {
      const auto a = scoreMotion(plain, figure, method, {}), b = scoreMotion(motion, figure, method, {});
      ASSERT_TRUE(a && b);
      int other = 0;
      for (std::size_t f = 0; f < a->frames.size(); ++f) {
        EXPECT_NEAR(a->frames[f].trunk_inclination, b->frames[f].trunk_inclination, 0.01) << way.how;
        other += a->frames[f].score != b->frames[f].score ? 1 : 0;
      }
      // An angle that differs by less than 2 deg may lie on two sides of a bound.
      EXPECT_LE(other, static_cast<int>(0.03 * static_cast<double>(a->frames.size()))) << way.how;
    }
  }
}

TEST(RecordedByAnyProgram, TheSameMotionHasTheSameScores) {
  expectSameScores(workingPerson());
}

TEST(RecordedByAnyProgram, TheSharedClipsTooHaveTheSameScores) {
  for (const char* name : {"mocap/02_01.bvh", "mocap/02_06.bvh"}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(file, name);
    MotionClip clip = *mannequin::readMotionFile(file);
    std::vector<mannequin::ClipFrame> some;
    for (std::size_t f = 0; f < clip.frames.size(); f += 8) some.push_back(clip.frames[f]);
    clip.frames = some;
    expectSameScores(clip);
  }
}

TEST(RecordedByAnyProgram, FramesTurnedAtRandomGiveNearlyTheSame) {
  // Then nothing tells how head and hands are turned about their bones but the motion on the whole.
  std::mt19937_64 random(3);
  std::normal_distribution<double> number;
  const MotionClip clip = workingPerson();
  std::vector<dmat3> turns;
  for (std::size_t j = 0; j < clip.joints.size(); ++j)
    turns.push_back(
        glm::mat3_cast(glm::normalize(dquat(number(random), number(random), number(random), number(random)))));
  const auto plain = motionOf(BvhText(clip).text(), "plain");
  const auto motion = motionOf(BvhText(reframed(clip, turns)).text(), "random");
  ASSERT_EQ(motion.bodies.size(), plain.bodies.size());
  for (std::size_t f = 0; f < motion.bodies.size(); f += 5) {
    const auto off = [](const dmat3& a, const dmat3& b) {
      return glm::length(rotationVector(glm::quat_cast(glm::transpose(a) * b))) / kDegree;
    };
    EXPECT_LT(off(plain.bodies[f].R_thorax, motion.bodies[f].R_thorax), 4.0) << f;
    EXPECT_LT(off(plain.bodies[f].R_head, motion.bodies[f].R_head), 12.0) << f;
    EXPECT_LT(glm::length(plain.bodies[f].elbow[1] - motion.bodies[f].elbow[1]), 1e-5) << f;
  }
}

TEST(RecordedByAnyProgram, WithoutNeckSpinePartsOrToesTheTrunkIsTheSame) {
  const MotionClip clip = workingPerson();
  const auto plain = motionOf(BvhText(clip).text(), "plain");
  const auto figure = *mannequin::makeFigure({});
  const auto expected = scoreMotion(plain, figure, MotionMethod::kRula, {});
  MotionClip bare = withoutJoint(clip, "lowerneck");
  EXPECT_EQ(bare.find("lowerneck"), -1);
  const auto no_neck = motionOf(BvhText(bare).text(), "no neck");
  const auto found = scoreMotion(no_neck, figure, MotionMethod::kRula, {});
  ASSERT_TRUE(expected && found);
  for (std::size_t f = 0; f < expected->frames.size(); ++f)
    EXPECT_NEAR(expected->frames[f].trunk_inclination, found->frames[f].trunk_inclination, 4.0) << f;
  const auto says = [](const mannequin::RecordedMotion& motion, const char* words) {
    return std::any_of(motion.assumptions.begin(), motion.assumptions.end(),
                       [&](const Text& each) { return english(each).find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says(no_neck, "no joint for the neck"));
  EXPECT_FALSE(says(plain, "no joint for the neck"));
  for (const char* name : {"lowerback", "upperback"}) bare = withoutJoint(bare, name);
  const auto bones = motionOf(BvhText(reframed(bare, bonesAlongX(bare))).text(), "one spine joint, no neck");
  const auto score = scoreMotion(bones, figure, MotionMethod::kOwas, {});
  ASSERT_TRUE(score);
  EXPECT_LT(score->frames.front().trunk_inclination, 10.0);
}

TEST(RecordedByAnyProgram, PublicFilesHaveTheTrunkOfTheirJoints) {
  // Trunk against the vertical as found by another forward kinematics (case 06 and 08 of the motions tried): files of
  // PyMO (no neck) and AnimatedDrawings (z up), in a folder bvh beside the other shared data.
  struct Known {
    const char* file;
    double least, most;
    mannequin::UpAxis up;
  };
  for (const Known& known : {Known{"bvh/AV_8Walk_Meredith_HVHA_Rep1.bvh", 0.1, 11.4, mannequin::UpAxis::kY},
                             Known{"bvh/dab.bvh", 0.7, 21.1, mannequin::UpAxis::kZ}}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(file, known.file);
    const auto motion = mannequin::readRecordedMotion(file);
    ASSERT_TRUE(motion) << motion.error().message();
    EXPECT_EQ(motion->up, known.up);
    const auto scores = scoreMotion(*motion, *mannequin::makeFigure({}), MotionMethod::kOwas, {});
    ASSERT_TRUE(scores);
    const auto lean = [](const FrameScore& a, const FrameScore& b) {
      return a.trunk_inclination < b.trunk_inclination;
    };
    const auto [least, most] = std::minmax_element(scores->frames.begin(), scores->frames.end(), lean);
    EXPECT_NEAR(least->trunk_inclination, known.least, 2.0) << known.file;
    EXPECT_NEAR(most->trunk_inclination, known.most, 2.0) << known.file;
  }
}

TEST(RecordedByAnyProgram, UpIsReportedAndCanBeTold) {
  const std::string text = BvhText(turnedWhole(workingPerson(), turnAbout(0, 90.0))).text();
  const auto clip = mannequin::readBvh(text, "z.bvh");
  ASSERT_TRUE(clip);
  EXPECT_EQ(mannequin::recordedMotion(*clip)->up, mannequin::UpAxis::kZ);
  MotionReading told;
  told.up = mannequin::UpAxis::kY;
  const auto lying = mannequin::recordedMotion(*clip, told);
  ASSERT_TRUE(lying);
  EXPECT_EQ(lying->up, mannequin::UpAxis::kY);
  EXPECT_NE(english(lying->assumptions.front()).find("as set; the head is above the feet along the file's z axis"),
            std::string::npos);
  const auto score = scoreMotion(*lying, *mannequin::makeFigure({}), MotionMethod::kRula, {});
  EXPECT_GT(score->frames.front().trunk_inclination, 70.0);
  for (const char* wrong : {"", "w", "--z", "zz"}) EXPECT_FALSE(mannequin::parseUpAxis(wrong)) << wrong;
  EXPECT_EQ(*mannequin::parseUpAxis("+X"), mannequin::UpAxis::kX);
  EXPECT_EQ(*mannequin::parseUpAxis("-y"), mannequin::UpAxis::kMinusY);
}

}  // namespace
}  // namespace hapticell::ergonomics
