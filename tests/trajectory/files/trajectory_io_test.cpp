// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/number_text.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <clocale>
#include <filesystem>
#include <fstream>

#include "tests/support/test_data.h"
#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/editing.h"
#include "trajectory/files/ros_trajectory.h"
#include "trajectory/files/ros_yaml_reader.h"

namespace hapticell::trajectory {
namespace {

namespace fs = std::filesystem;

class TrajectoryFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("htraj-" + std::to_string(::getpid()) + "-" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  fs::path folder_;
};

Trajectory sample() {
  Trajectory trajectory;
  trajectory.name = "weld \"1\"";
  trajectory.entity = "robot";
  trajectory.moved = "tcp";
  trajectory.joint_names = {"A1", "A2"};
  for (int i = 0; i < 40; ++i) {
    const double joints[] = {0.1 * i / 3.0, -1e-17 * i};
    trajectory.addFrame({i / 1000.0, test::gestureAt(0.37 * i), i == 7, i == 9 ? 0.25 : 0.0}, joints);
  }
  return trajectory;
}

void expectEqualBits(const Trajectory& a, const Trajectory& b, bool poses) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.joint_names, b.joint_names);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].t, b[i].t) << i;
    if (poses) {
      EXPECT_EQ(a[i].X_WT.p, b[i].X_WT.p) << i;
      EXPECT_EQ(a[i].X_WT.q, b[i].X_WT.q) << i;
    }
    for (std::size_t j = 0; j < a.joint_names.size(); ++j) EXPECT_EQ(a.joints(i)[j], b.joints(i)[j]) << i;
  }
}

TEST(TrajectoryFile, OfVersion01IsRead) {
  std::vector<Text> notes;
  const auto kept = readTrajectory(hapticell::test::sourceFile("tests/samples/0.1/extraction-expert.htraj"), &notes);
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_TRUE(notes.empty()) << english(notes);
  EXPECT_EQ(kept->size(), 12u);
  EXPECT_EQ((*kept)[0].X_WT.p.z, 0.14237772996932505);
  EXPECT_TRUE(kept->findChannel("force_z").has_value());
}

TEST_F(TrajectoryFiles, NamesOfPointsComeBack) {
  const Trajectory named = withName(sample(), 3, "oben \"links\" \xc3\xa9").value();
  const std::string text = toJsonText(named);
  const auto again = readTrajectory(write("a.htraj", text));
  ASSERT_TRUE(again.has_value()) << again.error().message();
  EXPECT_EQ((*again)[3].nameText(), named[3].nameText());
  EXPECT_EQ((*again)[2].name, nullptr);
  EXPECT_EQ(toJsonText(*again), text);
  EXPECT_EQ(toJsonText(sample()).find("names"), std::string::npos) << "files without names are as they were";
  const auto refused = readTrajectory(
      write("b.htraj", R"({"format":"hapticell-trajectory","version":1,"names":[[7,"x"]],"frames":[]})"));
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message().find("names"), std::string::npos);
}

TEST_F(TrajectoryFiles, JsonCsvAndRosComeBackBitForBit) {
  const Trajectory trajectory = sample();
  const auto json = readTrajectory(write("a.htraj", toJsonText(trajectory)));
  ASSERT_TRUE(json.has_value()) << json.error().message();
  expectEqualBits(trajectory, *json, true);
  EXPECT_EQ(json->name, trajectory.name);
  EXPECT_EQ(json->moved, "tcp");
  EXPECT_TRUE((*json)[7].by_hand);
  EXPECT_EQ((*json)[9].dwell, 0.25);
  EXPECT_TRUE(toJsonText(*json) == toJsonText(trajectory));
  const auto csv = readTrajectory(write("a.csv", toCsvText(trajectory)));
  ASSERT_TRUE(csv.has_value()) << csv.error().message();
  expectEqualBits(trajectory, *csv, true);
  const auto ros = readTrajectory(write("a.yaml", *toRosText(trajectory)));
  ASSERT_TRUE(ros.has_value()) << ros.error().message();
  expectEqualBits(trajectory, *ros, false);
}

TEST_F(TrajectoryFiles, RosInFlowStyleIsRead) {
  const auto read = readTrajectory(write("b.yaml",
                                         "joint_names: [j1, 'j2']\npoints:\n- positions: [0.5, 1]\n"
                                         "  time_from_start: {sec: 0, nanosec: 0}\n- positions: [0.25, 2]\n"
                                         "  time_from_start: {sec: 1, nanosec: 500000000}\n"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->joint_names, (std::vector<std::string>{"j1", "j2"}));
  EXPECT_EQ((*read)[1].t, 1.5);
  EXPECT_EQ(read->joints(1)[1], 2.0);
}

TEST_F(TrajectoryFiles, RosNamesItsJointsOnce) {
  const auto read = readTrajectory(write("c.yaml",
                                         "joint_names: [a]\npoints:\n- positions: [1]\n  time_from_start: 0\n"
                                         "joint_names: [a, b]\n"));
  ASSERT_FALSE(read.has_value());
  EXPECT_NE(read.error().message().find("line 5: 'joint_names' twice"), std::string::npos) << read.error().message();
}

TEST_F(TrajectoryFiles, RosTimesThatNoCountHoldsAreRefused) {
  const std::string head = "joint_names: [a]\npoints:\n- positions: [1]\n  time_from_start:\n";
  for (const std::string times :
       {"    sec: 9900000000\n", "    sec: 4400000000\n    nanosec: 4600000000000000000\n", "    sec: -9900000000\n"}) {
    const auto read = readTrajectory(write("d.yaml", head + times));
    ASSERT_FALSE(read.has_value()) << times;
    EXPECT_NE(read.error().message().find("at most 9e9 s"), std::string::npos) << read.error().message();
  }
}

TEST_F(TrajectoryFiles, NumbersDoNotFollowTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(fixedText(-1e-9, 3), "0.000");
  EXPECT_EQ(fixedText(1234.5, 2), "1234.50");
  std::setlocale(LC_ALL, before.c_str());
}

TEST_F(TrajectoryFiles, FaultsNameFileAndPlace) {
  const std::string head = R"({"format":"hapticell-trajectory","version":1,"joints":["a"],"frames":)";
  const std::pair<std::string, std::string> faults[] = {
      {"{", "invalid JSON"},
      {R"({"format":"other"})", "format"},
      {R"({"format":"hapticell-trajectory","version":2})", "newer"},
      {head + "[[0,0,0,0,1,0,0,0]]}", "frame 0"},
      {head + "[[0,0,0,0,1,0,0,0,0],[0,0,0,0,1,0,0,0,0]]}", "frame 1"},
      {head + "[[0,0,0,0,3,0,0,0,0]]}", "quaternion"},
      {head + R"([[0,0,0,0,1,0,0,"x",0]]})", "numbers"},
      {head + R"([[0,0,0,0,1,0,0,0,0]],"dwells":[[4,1]]})", "dwells"},
  };
  for (const auto& [text, word] : faults) {
    const auto read = readTrajectory(write("bad.htraj", text));
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(read.error().message().find("bad.htraj"), std::string::npos) << read.error().message();
    EXPECT_NE(read.error().message().find(word), std::string::npos) << read.error().message();
  }
  EXPECT_FALSE(readTrajectory(folder_ / "none.csv").has_value());
  EXPECT_FALSE(readTrajectory(write("x.txt", "")).has_value());
  const auto order = readTrajectory(write("c.csv", "t,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"));
  ASSERT_FALSE(order.has_value());
  EXPECT_NE(order.error().message().find("line 3"), std::string::npos);
}

TEST(Trajectory, PosesBetweenFramesAndOrderOfTimes) {
  Trajectory trajectory;
  EXPECT_TRUE(trajectory.addFrame({0.0, Pose::identity()}));
  EXPECT_TRUE(trajectory.addFrame({2.0, Pose::translation({1, 0, 0})}));
  EXPECT_FALSE(trajectory.addFrame({2.0, Pose::identity()}));
  EXPECT_DOUBLE_EQ(trajectory.poseAt(0.5).p.x, 0.25);
  EXPECT_DOUBLE_EQ(trajectory.poseAt(-1.0).p.x, 0.0);
  EXPECT_DOUBLE_EQ(trajectory.poseAt(9.0).p.x, 1.0);
  EXPECT_DOUBLE_EQ(trajectory.duration(), 2.0);
}

}  // namespace
}  // namespace hapticell::trajectory
