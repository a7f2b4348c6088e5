// SPDX-License-Identifier: Apache-2.0
// Programs are read back by small readers of their own (regular expressions, matrices by hand): none of the code that
// wrote them is used.
#include "trajectory/programs/writing/program_export.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <regex>

#include "tests/trajectory/motion/motions.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

dmat3 aboutX(double a) {
  return {1, 0, 0, 0, std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a)};
}
dmat3 aboutY(double a) {
  return {std::cos(a), 0, -std::sin(a), 0, 1, 0, std::sin(a), 0, std::cos(a)};
}
dmat3 aboutZ(double a) {
  return {std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1};
}

/// Rodrigues' formula.
dmat3 aboutVector(const dvec3& r) {
  const double angle = glm::length(r);
  if (angle < 1e-12) return dmat3(1.0);
  const dvec3 k = r / angle;
  const dmat3 K(0, k.z, -k.y, -k.z, 0, k.x, k.y, -k.x, 0);
  return dmat3(1.0) + std::sin(angle) * K + (1.0 - std::cos(angle)) * K * K;
}

struct ReadTarget {
  dvec3 p{0.0};  // m
  dmat3 R{1.0};
};

std::vector<double> numbersIn(const std::string& text) {
  static const std::regex kNumber(R"([-+]?\d+(\.\d+)?([eE][-+]?\d+)?)");
  std::vector<double> numbers;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), kNumber); it != std::sregex_iterator(); ++it) {
    numbers.push_back(std::stod(it->str()));
  }
  return numbers;
}

/// The groups of every match, the whole first.
std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::vector<std::string>> all;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), regex); it != std::sregex_iterator(); ++it) {
    all.emplace_back(it->begin(), it->end());
  }
  return all;
}

double field(const std::string& text, const std::string& name) {
  std::smatch match;
  const std::regex regex("\\b" + name + R"(\s*=?\s*"?\s*([-+]?\d+(\.\d+)?))");
  EXPECT_TRUE(std::regex_search(text, match, regex)) << name << " in " << text;
  return match.empty() ? NAN : std::stod(match[1].str());
}

dvec3 fields(const std::string& text, const char* a, const char* b, const char* c) {
  return {field(text, a), field(text, b), field(text, c)};
}

std::string contentOf(const std::vector<ProgramFile>& files, const std::string& ending) {
  for (const ProgramFile& file : files) {
    if (file.name.size() >= ending.size() && file.name.substr(file.name.size() - ending.size()) == ending) {
      return file.content;
    }
  }
  ADD_FAILURE() << "no file " << ending;
  return {};
}

std::vector<ReadTarget> readKrl(const std::vector<ProgramFile>& files) {
  std::map<std::string, ReadTarget> points;
  for (const auto& match : matches(contentOf(files, ".dat"), R"(DECL E6POS (XP\d+)=\{([^}]*)\})")) {
    const std::string body = match[2];
    const dvec3 abc = kRadians * fields(body, "A", "B", "C");
    points[match[1]] = {fields(body, "X", "Y", "Z") / 1000.0, aboutZ(abc.x) * aboutY(abc.y) * aboutX(abc.z)};
  }
  std::vector<ReadTarget> targets{points.at("XP1")};
  for (const auto& match : matches(contentOf(files, ".src"), R"(LIN (XP\d+))")) targets.push_back(points.at(match[1]));
  return targets;
}

std::vector<ReadTarget> readRapid(const std::vector<ProgramFile>& files) {
  std::vector<ReadTarget> targets;
  for (const auto& match : matches(contentOf(files, ".mod"), R"(robtarget p\d+:=\[\[([^\]]*)\],\[([^\]]*)\])")) {
    const auto p = numbersIn(match[1]), q = numbersIn(match[2]);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const dmat3 R(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),  // columns
                  2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),  //
                  2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
    targets.push_back({dvec3(p[0], p[1], p[2]) / 1000.0, R});
  }
  return targets;
}

std::vector<ReadTarget> readFanuc(const std::vector<ProgramFile>& files) {
  std::vector<ReadTarget> targets;
  for (const auto& match : matches(contentOf(files, ".LS"), R"(P\[\d+\]\{([^}]*)\})")) {
    const std::string whole = match[1];
    const std::string body = whole.substr(whole.find("',"));  // behind the configuration, which has letters too
    const dvec3 wpr = kRadians * fields(body, "W", "P", "R");
    targets.push_back({fields(body, "X", "Y", "Z") / 1000.0, aboutZ(wpr.z) * aboutY(wpr.y) * aboutX(wpr.x)});
  }
  return targets;
}

std::vector<ReadTarget> readUrScript(const std::vector<ProgramFile>& files) {
  std::vector<ReadTarget> targets;
  for (const auto& match : matches(contentOf(files, ".script"), R"(move[jl]\(p\[([^\]]*)\])")) {
    const auto n = numbersIn(match[1]);
    targets.push_back({{n[0], n[1], n[2]}, aboutVector({n[3], n[4], n[5]})});
  }
  return targets;
}

std::vector<ReadTarget> readVal3(const std::vector<ProgramFile>& files) {
  std::vector<ReadTarget> targets;
  for (const auto& match : matches(contentOf(files, ".dtx"), R"re(<Value key="\d+" (x="[^>]*))re")) {
    const std::string body = match[1];
    if (body.find("world") == std::string::npos) continue;  // the tool
    const dvec3 r = kRadians * fields(body, "rx", "ry", "rz");
    targets.push_back({fields(body, "x", "y", "z") / 1000.0, aboutX(r.x) * aboutY(r.y) * aboutZ(r.z)});
  }
  return targets;
}

Trajectory writtenProgram() {
  Trajectory trajectory;
  trajectory.name = "weld seam 1";
  for (int i = 0; i < 60; ++i) trajectory.addFrame({0.1 * i, test::gestureAt(0.5 * i), false, i == 20 ? 0.5 : 0.0});
  return trajectory;
}

using Reader = std::vector<ReadTarget> (*)(const std::vector<ProgramFile>&);

TEST(ProgramExport, EveryFormatReadsBackToAMicrometreAndAFractionOfASecondOfArc) {
  const std::pair<ProgramFormat, Reader> formats[] = {{ProgramFormat::kKrl, readKrl},
                                                      {ProgramFormat::kRapid, readRapid},
                                                      {ProgramFormat::kFanuc, readFanuc},
                                                      {ProgramFormat::kUrScript, readUrScript},
                                                      {ProgramFormat::kVal3, readVal3}};
  const Trajectory trajectory = writtenProgram();
  for (const auto& [format, read] : formats) {
    const auto files = exportProgram(trajectory, format, {});
    ASSERT_TRUE(files.has_value());
    const auto targets = read(*files);
    ASSERT_EQ(targets.size(), trajectory.size()) << static_cast<int>(format);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      EXPECT_LT(glm::length(targets[i].p - trajectory[i].X_WT.p), 1e-6) << i;
      const dmat3 off = glm::transpose(targets[i].R) * trajectory[i].X_WT.R();
      const dvec3 sines(off[1][2] - off[2][1], off[2][0] - off[0][2], off[0][1] - off[1][0]);
      EXPECT_LT(0.5 * glm::length(sines) / kRadians, 1e-4) << i;
    }
  }
}

// One rotation in every convention, as the makers' own tools give it.
TEST(RobotAngles, OneRotationInEveryConvention) {
  const dquat q(0.692749, 0.593132, -0.131120, 0.388716);
  const dvec3 kuka = kukaAngles(glm::normalize(q)), fanuc = fanucAngles(glm::normalize(q));
  const dvec3 staubli = staubliAngles(glm::normalize(q)), ur = rotationVector(glm::normalize(q));
  EXPECT_LT(glm::length(kuka - dvec3(30, -40, 70)), 2e-4);
  EXPECT_LT(glm::length(fanuc - dvec3(70, -40, 30)), 2e-4);
  EXPECT_LT(glm::length(staubli - dvec3(74.1646, 16.2276, 46.2953)), 2e-4);
  EXPECT_LT(glm::length(ur - dvec3(1.324969, -0.292903, 0.868334)), 5e-6);
}

TEST(RobotAngles, ComeBackAtTheDegenerateAnglesToo) {
  for (const double middle : {-90.0, -89.9999, 0.0, 45.0, 90.0}) {
    for (const double outer : {-170.0, -30.0, 0.0, 120.0}) {
      const dquat q = fromKukaAngles({outer, middle, 25.0});
      EXPECT_LT(glm::length(rotationVector(glm::conjugate(q) * fromKukaAngles(kukaAngles(q)))), 1e-7);
      EXPECT_LT(glm::length(rotationVector(glm::conjugate(q) * fromFanucAngles(fanucAngles(q)))), 1e-7);
      const dquat s = fromStaubliAngles({outer, middle, 25.0});
      EXPECT_LT(glm::length(rotationVector(glm::conjugate(s) * fromStaubliAngles(staubliAngles(s)))), 1e-7);
    }
  }
}

Trajectory withJoints() {
  Trajectory trajectory;
  trajectory.name = "9 seam";
  trajectory.joint_names = {"j1", "j2", "j3", "j4", "j5", "j6"};
  for (int i = 0; i < 5; ++i) {
    const double joints[] = {0.1 * i, -1.2, 1.3, 0.0, 0.5, 3.1};
    trajectory.addFrame({0.5 * i, Pose::translation({0.1 * i, 0, 0})}, joints);
  }
  return trajectory;
}

TEST(ProgramExport, FirstMoveIsOfJointsInDegreesAndConfigurationsAreWritten) {
  ProgramOptions options;
  options.configuration = [](std::span<const double>) { return std::string("S 2,T 35"); };
  const auto krl = exportProgram(withJoints(), ProgramFormat::kKrl, options);
  EXPECT_NE(
      contentOf(*krl, ".src").find("PTP {A1 0.00000,A2 -68.75494,A3 74.48451,A4 0.00000,A5 28.64789,A6 177.61692}"),
      std::string::npos);
  EXPECT_NE(contentOf(*krl, ".dat").find(",S 2,T 35,E1"), std::string::npos);
  EXPECT_EQ(krl->front().name, "p9_seam.src");
  const auto rapid = exportProgram(withJoints(), ProgramFormat::kRapid, {});
  EXPECT_NE(contentOf(*rapid, ".mod").find("MoveAbsJ [[0.000000,-68.754935,74.484513,0.000000,28.647890,177.616916],"),
            std::string::npos);
  const auto ur = exportProgram(withJoints(), ProgramFormat::kUrScript, {});
  EXPECT_NE(contentOf(*ur, ".script").find("movej([0.00000000,-1.20000000,"), std::string::npos);
  const auto val3 = exportProgram(withJoints(), ProgramFormat::kVal3, {});
  EXPECT_EQ(val3->size(), 4u);
  for (const ProgramFile& file : *val3) EXPECT_EQ(file.content.substr(0, 3), "\xEF\xBB\xBF") << file.name;
}

TEST(ProgramExport, BlendsNeverReachIntoANeighbours) {
  Trajectory trajectory;
  trajectory.name = "blend";
  for (const double x : {0.0, 0.1, 0.101, 0.3}) trajectory.addFrame({x + 0.01, Pose::translation({x, 0, 0})});
  ProgramOptions options;
  options.blend = 0.01;
  const auto files = exportProgram(trajectory, ProgramFormat::kUrScript, options);
  std::vector<double> radii;
  for (const auto& match : matches(contentOf(*files, ".script"), R"(,r=([0-9.]+)\))"))
    radii.push_back(std::stod(match[1]));
  ASSERT_EQ(radii.size(), 2u);
  EXPECT_LT(radii[0] + radii[1], 0.001);
}

TEST(ProgramExport, TheHeaderSaysWhatIsTheUsersOwn) {
  for (const auto format : {ProgramFormat::kKrl, ProgramFormat::kRapid, ProgramFormat::kFanuc, ProgramFormat::kUrScript,
                            ProgramFormat::kVal3}) {
    const auto files = exportProgram(writtenProgram(), format, {});
    ASSERT_TRUE(files.has_value());
    std::string text;
    for (const auto& file : *files) text += file.content;
    for (const char* word : {"tool|Tool", "base", "safety"})
      EXPECT_TRUE(std::regex_search(text, std::regex(word))) << static_cast<int>(format) << ' ' << word;
    if (format != ProgramFormat::kFanuc) continue;
    for (const auto& remark : matches(text, R"(\n\s*\d+:!([^;\n]*);)")) EXPECT_LE(remark[1].size(), 32u) << remark[1];
  }
}

TEST(ProgramExport, RefusesWhatMakesNoProgram) {
  EXPECT_FALSE(exportProgram(Trajectory{}, ProgramFormat::kKrl, {}).has_value());
  Trajectory seven;
  seven.joint_names = {"1", "2", "3", "4", "5", "6", "7"};
  seven.addFrame({0.0, Pose::identity()}, std::vector<double>(7, 0.0));
  EXPECT_FALSE(exportProgram(seven, ProgramFormat::kRapid, {}).has_value());
  ProgramOptions options;
  options.speed = 0.0;
  EXPECT_FALSE(exportProgram(withJoints(), ProgramFormat::kRapid, options).has_value());
}

}  // namespace
}  // namespace hapticell::trajectory
