// SPDX-License-Identifier: Apache-2.0
// A JointTrajectory in every style that ROS's tools write it in, and in those that YAML allows besides.
#include "trajectory/files/ros_yaml_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "trajectory/files/ros_trajectory.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::trajectory {
namespace {

Expected<Trajectory> readText(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("ros-yaml-" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(path, std::ios::binary) << text;
  auto read = readRosYaml(path);
  std::filesystem::remove(path);
  return read;
}

// All say: joints a and b; (0, 1) at the beginning, (1, 2) after 1.5 s.
const std::vector<std::pair<const char*, std::string>> kStyles{
    {"flow maps",
     "joint_names: [a, b]\npoints:\n- {positions: [0.0, 1.0], velocities: [], time_from_start: {sec: 0, nanosec: 0}}\n"
     "- {positions: [1.0, 2.0], time_from_start: {sec: 1, nanosec: 500000000}}\n"},
    {"ros2 topic echo",
     "header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ''\njoint_names:\n- a\n- b\npoints:\n- positions:\n"
     "  - 0.0\n  - 1.0\n  velocities: []\n  accelerations: []\n  effort: []\n  time_from_start:\n    sec: 0\n    "
     "nanosec: 0\n"
     "- positions:\n  - 1.0\n  - 2.0\n  velocities: []\n  accelerations: []\n  effort: []\n  time_from_start:\n    "
     "sec: 1\n"
     "    nanosec: 500000000\n---\n"},
    {"rostopic echo",
     "header: \n  seq: 7\n  stamp: \n    secs: 0\n    nsecs: 0\n  frame_id: ''\njoint_names: [a, b]\npoints: \n  - \n"
     "    positions: [0.0, 1.0]\n    velocities: []\n    time_from_start: \n      secs: 0\n      nsecs: 0\n  - \n"
     "    positions: [1.0, 2.0]\n    velocities: []\n    time_from_start: \n      secs: 1\n      nsecs: "
     "500000000\n---\n"},
    {"keys in another order, quoted, with comments",
     "# by hand\npoints:\n- time_from_start: {nanosec: 0, sec: 0}  # begin\n  positions: [0, 1]\n"
     "- 'time_from_start': {nanosec: 500000000, sec: 1}\n  \"positions\": [1, 2.0e0]\njoint_names: ['a', \"b\"]\n"},
    {"lists over several lines, seconds as a number",
     "{joint_names: [a,\n  b], points: [{positions: [0,\n 1], time_from_start: 0}, {positions: [1, 2],\n "
     "time_from_start: 1.5}]}\n"},
    {"JSON",
     R"({"joint_names": ["a", "b"], "points": [{"positions": [0, 1], "time_from_start": {"sec": 0, "nanosec": 0}},
        {"positions": [1, 2], "time_from_start": {"sec": 1, "nanosec": 500000000}}]})"},
    {"an action's goal",
     "goal:\n  trajectory:\n    joint_names: [a, b]\n    points:\n    - positions: [0, 1]\n      time_from_start: "
     "{sec: 0}\n"
     "    - positions: [1, 2]\n      time_from_start: {sec: 1, nanosec: 500000000}\n"},
    {"DisplayTrajectory",
     "model_id: arm\ntrajectory:\n- joint_trajectory:\n    joint_names: [a, b]\n    points:\n    - positions: [0, 1]\n"
     "      time_from_start: {secs: 0, nsecs: 0}\n    - positions: [1, 2]\n"
     "      time_from_start: {secs: 1, nsecs: 500000000}\n"},
    {"anchors, Windows line ends",
     "joint_names: [a, b]\r\nstart: &zero {sec: 0, nanosec: 0}\r\npoints:\r\n- positions: [0, 1]\r\n"
     "  time_from_start: *zero\r\n- positions: [1, 2]\r\n  time_from_start: {sec: 1, nanosec: 500000000}\r\n"},
    {"JointState messages of ros2 topic echo",
     "header:\n  stamp: {sec: 90, nanosec: 250000000}\nname: [a, b]\nposition: [0, 1]\nvelocity: []\n---\n"
     "header:\n  stamp: {sec: 91, nanosec: 750000000}\nname: [a, b]\nposition: [1, 2]\n---\n"}};

TEST(RosYaml, EveryStyleSaysTheSame) {
  for (const auto& [name, text] : kStyles) {
    const auto read = readText(text);
    ASSERT_TRUE(read.has_value()) << name << ": " << read.error().message();
    EXPECT_FALSE(read->has_poses) << name;
    EXPECT_EQ(read->joint_names, (std::vector<std::string>{"a", "b"})) << name;
    ASSERT_EQ(read->size(), 2u) << name;
    EXPECT_EQ((*read)[0].t, 0.0) << name;
    EXPECT_EQ((*read)[1].t, 1.5) << name;
    EXPECT_EQ(read->joints(0)[1], 1.0) << name;
    EXPECT_EQ(read->joints(1)[0], 1.0) << name;
    EXPECT_EQ(read->joints(1)[1], 2.0) << name;
  }
}

TEST(RosYaml, FaultsNameLineAndWhatIsWrong) {
  const std::string head = "joint_names: [a, b]\npoints:\n";
  const std::pair<std::string, std::string> faults[] = {
      {"joint_names: [a, b\n", "line"},
      {"", "no message of these types"},
      {",robot", "line 1: invalid YAML"},  // Here yaml-cpp 0.7 would go on until the memory is full.
      {"joint_names: [a]\n---\n]\n", "line"},
      {"points: []\n", "no message of these types"},
      {head + "- positions: [1]\n  time_from_start: 0\n", "line 3: 1 positions; expected 2, one per joint"},
      {head + "- positions: [1, x]\n  time_from_start: 0\n", "'x'; expected a number"},
      {head + "- positions: [1, .nan]\n  time_from_start: 0\n", "expected a number"},
      {head + "- positions: [1, 2]\n", "time_from_start is missing"},
      {head + "- positions: [1, 2]\n  time_from_start: {minutes: 2}\n", "'minutes' in a time"},
      {head + "- positions: [1, 2]\n  time_from_start: 1\n- positions: [1, 2]\n  time_from_start: 1\n", "increase"},
      {head + "- positions: [1, 2]\n  positions: [1, 3]\n  time_from_start: 1\n", "'positions' twice"},
      {"joint_names: [a, a]\npoints: []\n", "joint 'a' twice"},
      {head + "- positions: [1, 2]\n  time_from_start: 0\n- '...'\n", "--full-length"},
      {"joint_names: [a]\npoints: []\n---\njoint_names: [a]\npoints: []\n", "2 trajectories; expected one"}};
  for (const auto& [text, part] : faults) {
    const auto read = readText(text);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(read.error().message().find(part), std::string::npos) << text << "\n" << read.error().message();
  }
}

TEST(RosYaml, NamesOfAnyLettersComeBack) {
  Trajectory motion;
  motion.joint_names = {"axis: 1", "it's #2", "3", "left/elbow"};
  const double q[] = {1.0, 2.0, 3.0, 4.0};
  motion.addFrame({0.0, {}}, q);
  const auto read = readText(*toRosText(motion));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->joint_names, motion.joint_names);
}

}  // namespace
}  // namespace hapticell::trajectory
