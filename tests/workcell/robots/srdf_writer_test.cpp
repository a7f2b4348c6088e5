// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/srdf_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "workcell/robots/srdf.h"

namespace hapticell::workcell {
namespace {

kinematics::RobotModel twoJoints() {
  kinematics::RobotModel model;
  for (int i = 0; i < 3; ++i) {
    kinematics::Link link;
    link.name = "link & " + std::to_string(i);
    link.parent_joint = i - 1;
    model.links.push_back(link);
    if (i == 0) continue;
    kinematics::Joint joint;
    joint.name = "joint_" + std::to_string(i);
    joint.type = kinematics::JointType::kRevolute;
    joint.parent_link = i - 1;
    joint.child_link = i;
    joint.lower = -1.0;
    joint.upper = 2.0;
    joint.variable = i - 1;
    model.moving.push_back(i - 1);
    model.joints.push_back(joint);
  }
  return model;
}

TEST(SrdfWriter, ReaderBringsBackGroupsPosesAndPairs) {
  kinematics::RobotModel model = twoJoints();
  model.groups = {{"arm", {0, 1}, "link & 0", "link & 2"}, {"wrist", {1}, "", ""}};
  model.named_poses = {{"up", {0.25, 1.0 / 3.0}}, {"home", {0.5, -0.5}}};
  const std::vector<kinematics::DisabledPair> pairs{{0, 1, "Adjacent"}, {0, 2, "Never"}};
  const auto file = std::filesystem::temp_directory_path() / ("hsrdf-" + std::to_string(::getpid()) + ".srdf");
  std::ofstream(file) << srdfText("r<1>", model, pairs);
  kinematics::RobotModel read = twoJoints();
  read.name = "r<1>";
  Diagnostics notes;
  const auto result = readSrdf(file, read, notes);
  std::filesystem::remove(file);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_TRUE(notes.warnings.empty());
  ASSERT_EQ(read.groups.size(), 2u);
  EXPECT_EQ(read.groups[0].joints, (std::vector<int>{0, 1}));
  EXPECT_EQ(read.groups[1].joints, (std::vector<int>{1}));
  ASSERT_EQ(read.named_poses.size(), 2u);
  EXPECT_EQ(read.named_poses[0].q, model.named_poses[0].q);
  EXPECT_EQ(read.home, (std::vector<double>{0.5, -0.5}));
  ASSERT_EQ(read.disabled_pairs.size(), 2u);
  EXPECT_EQ(read.disabled_pairs[1].reason, "Never");
  EXPECT_EQ(read.disabled_pairs[1].second, 2);
}

TEST(SrdfWriter, ModelWithoutGroupsGetsItsArm) {
  const std::string text = srdfText("r", twoJoints(), {});
  EXPECT_NE(text.find("<chain base_link=\"link &amp; 0\" tip_link=\"link &amp; 2\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("group_state name=\"home\" group=\"arm\""), std::string::npos);
}

}  // namespace
}  // namespace hapticell::workcell
