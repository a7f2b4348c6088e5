// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/demonstration_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace hapticell::exchange {
namespace {

trajectory::Trajectory ramp() {
  trajectory::Trajectory motion;
  motion.entity = "robot";
  motion.name = "reach";
  motion.joint_names = {"A1"};
  motion.channel_names = {"force_x", "force_y", "force_z"};
  for (int i = 0; i <= 10; ++i) {
    const double joints[] = {2.0 * i}, forces[] = {0.0, 0.5 * i, 0.0};
    EXPECT_TRUE(motion.addFrame({5.0 + 0.1 * i, {}}, joints, forces));
  }
  return motion;
}

const FileToWrite& fileNamed(const std::vector<FileToWrite>& files, const std::string& name) {
  for (const FileToWrite& file : files)
    if (file.path == name) return file;
  ADD_FAILURE() << name;
  return files.front();
}

TEST(DemonstrationTable, HasTheLayoutThatLeRobotDocuments) {
  const auto files = demonstrationFiles({ramp(), ramp()}, {20.0, "reach the pin", ""});
  ASSERT_TRUE(files) << files.error().message();
  const auto info = nlohmann::json::parse(fileNamed(*files, "meta/info.json").content);
  EXPECT_EQ(info["codebase_version"], "v2.1");
  EXPECT_EQ(info["total_episodes"], 2);
  EXPECT_EQ(info["total_frames"], 42);
  EXPECT_EQ(info["features"]["observation.force"]["shape"][0], 3);
  EXPECT_EQ(info["features"]["action"]["names"][0], "A1");
  const std::string& table = fileNamed(*files, "data/chunk-000/episode_000001.csv").content;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("observation.state.A1,observation.pose.x,"));
  EXPECT_TRUE(line.ends_with("action.A1,timestamp,frame_index,episode_index,index,task_index"));
  std::getline(lines, line);
  std::getline(lines, line);  // The second frame: 0.05 s, joint 1, next 2.
  EXPECT_NEAR(std::stod(line), 1.0, 1e-9);
  EXPECT_TRUE(line.ends_with(",0.05,1,1,22,0")) << line;
  const auto statistics = nlohmann::json::parse(
      fileNamed(*files, "meta/episodes_stats.jsonl").content.substr(0, fileNamed(*files, "meta/episodes_stats.jsonl").content.find('\n')));
  EXPECT_NEAR(statistics["stats"]["observation.state"]["mean"][0].get<double>(), 10.0, 1e-9);
  EXPECT_NEAR(statistics["stats"]["observation.state"]["max"][0].get<double>(), 20.0, 1e-9);
}

TEST(DemonstrationTable, MotionsOfOtherJointsAreRefused) {
  auto other = ramp().emptyCopy();
  other.joint_names = {"B1"};
  const double joint[] = {1.0};
  other.addFrame({0.0, {}}, joint);
  EXPECT_FALSE(demonstrationFiles({ramp(), other}, {}));
  EXPECT_FALSE(demonstrationFiles({}, {}));
  EXPECT_FALSE(demonstrationFiles({ramp()}, {0.0, "", ""}));
}

}  // namespace
}  // namespace hapticell::exchange
