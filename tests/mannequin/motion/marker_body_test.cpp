// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/marker_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mannequin/motion/retarget.h"
#include "mannequin/posture/forward_kinematics.h"
#include "tests/mannequin/motion/c3d_text.h"
#include "tests/support/test_data.h"

namespace hapticell::mannequin {
namespace {

using test::C3dFile;

/// Half a joint's breadth and a marker's radius, as a laboratory would measure them on the figure.
constexpr double kKnee = 0.059, kAnkle = 0.043, kElbow = 0.047, kWrist = 0.025;

/// Plug-in Gait's markers put on a figure in a posture, in millimetres.
std::map<std::string, dvec3> markersOn(const Figure& figure, const Posture& posture) {
  const FigurePose pose = forwardKinematics(figure, posture);
  std::map<std::string, dvec3> marks;
  const SegmentPlace& pelvis = pose[Segment::kPelvis];
  const double hip = glm::length(pose[Segment::kLeftThigh].p_WS - pose[Segment::kRightThigh].p_WS) / 2.0;
  const double width = (hip - 0.0073) / 0.33, depth = 0.16;
  const dvec3 front(0.24 * depth + 0.0099, 0.0, 0.30 * width + 0.0109);
  for (const auto& [side, out] : {std::pair{"L", 1.0}, {"R", -1.0}}) {
    const std::string s(side);
    const Side at = out > 0 ? Side::kLeft : Side::kRight;
    const auto leg = [&](Segment left) { return pose[legSegment(at, left)]; };
    const auto arm = [&](Segment left) { return pose[armSegment(at, left)]; };
    marks[s + "ASI"] = pelvis.point(front + dvec3(0, out * width / 2.0, 0));
    marks[s + "PSI"] = pelvis.point(front + dvec3(-depth, out * 0.04, 0));
    marks[s + "THI"] = leg(Segment::kLeftThigh).point({0.0, out * 0.10, -0.2});
    marks[s + "KNE"] = leg(Segment::kLeftShank).p_WS + leg(Segment::kLeftThigh).R_WS * dvec3(0, out * kKnee, 0);
    marks[s + "TIB"] = leg(Segment::kLeftShank).point({0.0, out * 0.08, -0.2});
    marks[s + "ANK"] = leg(Segment::kLeftFoot).p_WS + leg(Segment::kLeftShank).R_WS * dvec3(0, out * kAnkle, 0);
    marks[s + "HEE"] = leg(Segment::kLeftFoot).point({-0.06, 0.0, -0.03});
    marks[s + "TOE"] = leg(Segment::kLeftFoot).point({0.14, 0.0, -0.03});
    const SegmentPlace thorax = pose[Segment::kThorax];
    marks[s + "SHO"] = arm(Segment::kLeftUpperArm).p_WS + thorax.R_WS * dvec3(0.0, out * 0.012, 0.047);
    marks[s + "ELB"] = arm(Segment::kLeftForearm).p_WS + arm(Segment::kLeftUpperArm).R_WS * dvec3(0, out * kElbow, 0);
    const SegmentPlace wrist = arm(Segment::kLeftWrist), hand = arm(Segment::kLeftHand);
    const dvec3 on_back = hand.p_WS + wrist.R_WS * dvec3(0, out * kWrist, 0);
    marks[s + "WRA"] = on_back + wrist.R_WS * dvec3(0.04, 0, 0);
    marks[s + "WRB"] = on_back - wrist.R_WS * dvec3(0.04, 0, 0);
    marks[s + "FIN"] = on_back + hand.R_WS * dvec3(0, 0, -0.09) + wrist.R_WS * dvec3(0, out * 0.010, 0);
    marks[s + "FHD"] = pose[Segment::kHead].point({0.10, out * 0.07, 0.10});
    marks[s + "BHD"] = pose[Segment::kHead].point({-0.08, out * 0.07, 0.10});
  }
  const SegmentPlace& thorax = pose[Segment::kThorax];
  const dvec3 c7 = glm::transpose(thorax.R_WS) * (pose[Segment::kLowerNeck].p_WS - thorax.p_WS);
  marks["C7"] = thorax.point(c7 + dvec3(-0.042, 0, 0.02));
  marks["CLAV"] = thorax.point(c7 + dvec3(0.078, 0, -0.04));
  marks["T10"] = thorax.point(c7 + dvec3(-0.042, 0, -0.20));
  marks["STRN"] = thorax.point(c7 + dvec3(0.078, 0, -0.26));
  for (auto& [name, p] : marks) p *= 1000.0;
  return marks;
}

std::vector<Posture> workOf(const Figure& figure) {
  std::vector<Posture> postures;
  const char* const names[] = {"standing", "both_hands_forward", "stooping", "standing", "reaching", "standing"};
  for (std::size_t i = 0; i + 1 < std::size(names); ++i) {
    for (int k = 0; k < 10; ++k)
      postures.push_back(
          interpolate(*libraryPosture(figure, names[i]), *libraryPosture(figure, names[i + 1]), 0.1 * k));
  }
  return postures;
}

std::string fileOf(const Figure& figure, const std::vector<Posture>& postures, C3dFile file = {},
                   const std::function<std::string(const std::string&)>& named = {}) {
  std::vector<std::map<std::string, dvec3>> frames;
  for (const Posture& posture : postures) frames.push_back(markersOn(figure, posture));
  std::vector<std::string> order;
  file.labels.clear();
  for (const auto& [name, p] : frames.front()) {
    order.push_back(name);
    file.labels.push_back(named ? named(name) : name);
  }
  file.frames = static_cast<int>(frames.size());
  if (!file.place)
    file.place = [&](int f, int m) {
      return std::optional(frames[static_cast<std::size_t>(f)].at(order[static_cast<std::size_t>(m)]));
    };
  return file.bytes();
}

double worstJoint(const RecordedMotion& motion, const Figure& figure, const std::vector<Posture>& postures) {
  double worst = 0.0;
  for (std::size_t f = 0; f < postures.size(); ++f) {
    const FigurePose pose = forwardKinematics(figure, postures[f]);
    const RecordedBody& body = motion.bodies[f];
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      const std::pair<dvec3, Segment> arm[] = {{body.shoulder[i], Segment::kLeftUpperArm},
                                               {body.elbow[i], Segment::kLeftForearm},
                                               {body.hand[i], Segment::kLeftHand}};
      const std::pair<dvec3, Segment> leg[] = {
          {body.hip[i], Segment::kLeftThigh}, {body.knee[i], Segment::kLeftShank}, {body.ankle[i], Segment::kLeftFoot}};
      for (const auto& [p, segment] : arm)
        worst = std::max(worst, glm::length(p - pose[armSegment(side, segment)].p_WS));
      for (const auto& [p, segment] : leg)
        worst = std::max(worst, glm::length(p - pose[legSegment(side, segment)].p_WS));
    }
  }
  return worst;
}

TEST(MarkerBody, TheFigureStandsAsTheOneThatWoreTheMarkers) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const std::vector<Posture> postures = workOf(figure);
  const auto clip = parseC3d(fileOf(figure, postures), "worn.c3d");
  ASSERT_TRUE(clip) << clip.error().message();
  const auto set = recogniseMarkers(*clip);
  ASSERT_TRUE(set) << set.error().message();
  EXPECT_EQ(set->name, "Plug-in Gait");
  const auto motion = recordedMotion(*clip, *set);
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_LT(worstJoint(*motion, figure, postures), 0.010);
  const auto worn = retarget(figure, *motion);
  ASSERT_TRUE(worn);
  for (std::size_t f = 0; f < postures.size(); ++f) {
    const FigurePose a = forwardKinematics(figure, postures[f]), b = forwardKinematics(figure, worn->postures[f]);
    for (const Segment segment : {Segment::kPelvis, Segment::kThorax, Segment::kHead, Segment::kLeftUpperArm,
                                  Segment::kRightForearm, Segment::kLeftThigh, Segment::kRightShank}) {
      const double off = glm::length(rotationVector(glm::quat_cast(glm::transpose(a[segment].R_WS) * b[segment].R_WS)));
      // Where a limb is nearly straight its turn about itself is not seen.
      const bool limb = segment >= Segment::kLeftClavicle;
      const double lean = glm::length(a[segment].R_WS[2] - b[segment].R_WS[2]);
      EXPECT_LT(limb ? lean : off, 4.0 * kDegree) << segmentInfo(segment).name << " in frame " << f;
    }
  }
}

TEST(MarkerBody, NamesUnitsAndAxesOfOtherProgramsGiveTheSame) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.62});
  const std::vector<Posture> postures = workOf(figure);
  const auto read = [&](const std::string& bytes) {
    const auto clip = parseC3d(bytes, "other.c3d");
    EXPECT_TRUE(clip) << (clip ? "" : clip.error().message());
    const auto set = recogniseMarkers(*clip);
    EXPECT_TRUE(set) << (set ? "" : set.error().message());
    return *recordedMotion(*clip, *set);
  };
  const double plain = worstJoint(read(fileOf(figure, postures)), figure, postures);
  EXPECT_LT(plain, 0.012);
  const auto with = [](const std::string& before) {
    return [before](const std::string& name) { return before + name; };
  };
  EXPECT_NEAR(worstJoint(read(fileOf(figure, postures, {}, with("Worker 1:"))), figure, postures), plain, 1e-5);
  C3dFile cmu;
  cmu.processor = 86;
  EXPECT_LT(worstJoint(read(fileOf(figure, postures, cmu,
                                   [](const std::string& name) {
                                     if (name.ends_with("ASI")) return name.substr(0, 1) + "FWT";
                                     return name.ends_with("PSI") ? name.substr(0, 1) + "BWT" : name;
                                   })),
                       figure, postures),
            0.04);
}

TEST(MarkerBody, HelenHayesIsUnderstood) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const std::vector<Posture> postures = workOf(figure);
  const std::map<std::string, std::string> words{{"ASI", "ASIS"},  {"SHO", "Shoulder"}, {"ELB", "Elbow"},
                                                 {"WRA", "Wrist"}, {"KNE", "Knee"},     {"ANK", "Ankle"},
                                                 {"HEE", "Heel"},  {"TOE", "Toe"}};
  const std::string bytes = fileOf(figure, postures, {}, [&](const std::string& name) {
    const auto found = words.find(name.substr(1));
    if (name == "LPSI") return std::string("V.Sacral");
    if (name == "LFHD") return std::string("Front.Head");
    if (name == "LBHD") return std::string("Rear.Head");
    return found == words.end() ? "x" + name : name.substr(0, 1) + "." + found->second;
  });
  const auto clip = parseC3d(bytes, "hayes.c3d");
  ASSERT_TRUE(clip);
  const auto set = recogniseMarkers(*clip);
  ASSERT_TRUE(set) << set.error().message();
  EXPECT_EQ(set->name, "Helen Hayes");
  const auto motion = recordedMotion(*clip, *set);
  ASSERT_TRUE(motion);
  EXPECT_LT(worstJoint(*motion, figure, postures), 0.07);  // One marker a wrist, at its thumb's side.
  EXPECT_NE(std::find_if(motion->assumptions.begin(), motion->assumptions.end(),
                         [](const Text& each) { return english(each).find("one marker") != std::string::npos; }),
            motion->assumptions.end());
}

TEST(MarkerBody, ATableOfOnesOwnNamesTheMarkers) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const std::vector<Posture> postures = workOf(figure);
  const auto clip =
      parseC3d(fileOf(figure, postures, {}, [](const std::string& name) { return "m-" + name + "-x"; }), "own.c3d");
  ASSERT_TRUE(clip);
  const auto unknown = recogniseMarkers(*clip);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("--markers"), std::string::npos);
  std::string table = "name = \"Our laboratory\"\n[markers]\nsacrum = [\"m-LPSI-x\", \"m-RPSI-x\"]\n";
  for (const auto& [side, letter] : {std::pair{"left", "L"}, {"right", "R"}}) {
    for (const auto& [landmark, word] :
         {std::pair{"asis", "ASI"}, {"shoulder", "SHO"}, {"elbow", "ELB"}, {"knee", "KNE"}, {"ankle", "ANK"}})
      table += std::string(side) + "_" + landmark + " = \"m-" + letter + word + "-x\"\n";
    table += std::string(side) + "_wrist = [\"m-" + letter + "WRA-x\", \"m-" + letter + "WRB-x\"]\n";
  }
  const auto set = parseMarkerTable(table, "own.toml", *clip);
  ASSERT_TRUE(set) << set.error().message();
  EXPECT_EQ(set->name, "Our laboratory");
  const auto motion = recordedMotion(*clip, *set);
  ASSERT_TRUE(motion);
  EXPECT_LT(worstJoint(*motion, figure, postures), 0.06);
  const auto refused = [&](const std::string& text, const std::string& words) {
    const auto bad = parseMarkerTable(text, "own.toml", *clip);
    ASSERT_FALSE(bad) << words;
    EXPECT_NE(bad.error().message().find(words), std::string::npos) << bad.error().message();
  };
  refused("[markers", "line 1");
  refused("name = \"x\"\n", "[markers] is missing");
  refused("[markers]\nleft_nose = \"m-LASI-x\"\n", "line 2: 'left_nose'");
  refused("[markers]\nleft_asis = \"nobody\"\n", "'nobody', which is not in the recording");
  refused("[markers]\nleft_asis = 7\n", "no marker for left_asis");
  refused("[markers]\nleft_asis = \"m-LASI-x\"\n", "no marker for");
}

TEST(MarkerBody, WhatIsNotSeenIsBridgedAndSaid) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const std::vector<Posture> postures = workOf(figure);
  C3dFile file;
  std::vector<std::map<std::string, dvec3>> frames;
  for (const Posture& posture : postures) frames.push_back(markersOn(figure, posture));
  std::vector<std::string> order;
  for (const auto& [name, p] : frames.front()) order.push_back(name);
  for (const bool zero : {false, true}) {
    file.place = [&, zero](int f, int m) -> std::optional<dvec3> {
      const std::string& name = order[static_cast<std::size_t>(m)];
      const bool hidden = name == "LELB" && f >= 12 && f < 17;
      if (hidden) return zero ? std::optional(dvec3(0.0)) : std::nullopt;
      return frames[static_cast<std::size_t>(f)].at(name);
    };
    const auto clip = parseC3d(fileOf(figure, postures, file), "gap.c3d");
    const auto motion = recordedMotion(*clip, *recogniseMarkers(*clip));
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->bodies.size(), postures.size());
    EXPECT_LT(worstJoint(*motion, figure, postures), 0.05);
    EXPECT_NE(
        std::find_if(motion->assumptions.begin(), motion->assumptions.end(),
                     [](const Text& each) {
                       return english(each).find("left_elbow is not visible in 5 of 50 frames, for at most 0.05 s") !=
                              std::string::npos;
                     }),
        motion->assumptions.end());
  }
  file.place = [&](int f, int m) -> std::optional<dvec3> {
    const std::string& name = order[static_cast<std::size_t>(m)];
    if (name == "RKNE") return std::nullopt;
    return frames[static_cast<std::size_t>(f)].at(name);
  };
  const auto clip = parseC3d(fileOf(figure, postures, file), "never.c3d");
  const auto never = recordedMotion(*clip, *recogniseMarkers(*clip));
  ASSERT_FALSE(never);
  EXPECT_NE(never.error().message().find("right_knee is never visible"), std::string::npos);
}

TEST(MarkerBody, JointsOfPublicRecordingsAreWherePlugInGaitPutThem) {
  // The files hold Plug-in Gait's own joint centres and angles besides the markers.
  HAPTICELL_SHARED_DATA_OR_SKIP(folder, "c3d");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with("PiG_Motion-FlatFoot")) continue;
    ++files;
    const auto clip = readC3d(entry.path());
    ASSERT_TRUE(clip);
    const auto motion = recordedMotion(*clip, *recogniseMarkers(*clip));
    ASSERT_TRUE(motion);
    const auto expectNear = [&](const char* name, const auto& joint, double millimetres) {
      const auto found = std::find(clip->names.begin(), clip->names.end(), name);
      ASSERT_NE(found, clip->names.end()) << name;
      double sum = 0.0, count = 0.0;
      for (std::size_t f = 0; f < motion->bodies.size(); ++f) {
        const auto& p = clip->at(f, static_cast<std::size_t>(found - clip->names.begin()));
        if (!p || *p == dvec3(0.0)) continue;
        sum += glm::length(*p - joint(motion->bodies[f]));
        count += 1.0;
      }
      EXPECT_LT(1000.0 * sum / count, millimetres) << name << " in " << entry.path();
    };
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string side = i == 0 ? "L" : "R";
      expectNear((side + "FEP").c_str(), [i](const RecordedBody& b) { return b.hip[i]; }, 30.0);  // Another regression.
      expectNear((side + "FEO").c_str(), [i](const RecordedBody& b) { return b.knee[i]; }, 12.0);
      expectNear((side + "TIO").c_str(), [i](const RecordedBody& b) { return b.ankle[i]; }, 12.0);
      expectNear((side + "CLO").c_str(), [i](const RecordedBody& b) { return b.shoulder[i]; }, 25.0);
      expectNear((side + "HUO").c_str(), [i](const RecordedBody& b) { return b.elbow[i]; }, 25.0);
      expectNear((side + "RAO").c_str(), [i](const RecordedBody& b) { return b.hand[i]; }, 8.0);
    }
  }
  EXPECT_GE(files, 1);
}

TEST(MarkerBody, TheSharedRecordingIsAPersonWhoStands) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/cmu_02_05.c3d");
  const auto motion = readRecordedMotion(file);
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_EQ(motion->marker_set, "Plug-in Gait");
  EXPECT_EQ(motion->bodies.size(), 1854u);
  const auto worn = retarget(*makeFigure({Sex::kMale, 1.755}), *motion);
  ASSERT_TRUE(worn);
  // Bone lengths of subject 02 (02.asf: thigh 428 mm, shank 411 mm, upper arm 275 mm) within those of skin markers.
  const auto mean = [&](const auto& length) {
    double sum = 0.0;
    for (const RecordedBody& body : motion->bodies) sum += length(body);
    return sum / static_cast<double>(motion->bodies.size());
  };
  EXPECT_NEAR(mean([](const RecordedBody& b) { return glm::length(b.knee[0] - b.hip[0]); }), 0.428, 0.04);
  EXPECT_NEAR(mean([](const RecordedBody& b) { return glm::length(b.ankle[0] - b.knee[0]); }), 0.411, 0.03);
  EXPECT_NEAR(mean([](const RecordedBody& b) { return glm::length(b.elbow[0] - b.shoulder[0]); }), 0.275, 0.03);
}

}  // namespace
}  // namespace hapticell::mannequin
