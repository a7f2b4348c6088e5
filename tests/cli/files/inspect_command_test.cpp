// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr const char* kArm = R"(<robot name="arm"><link name="base"/><link name="upper">
<visual><origin xyz="0 0 0.5"/><geometry><box size="0.2 0.4 1.0"/></geometry></visual></link><link name="tip"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
<joint name="end" type="fixed"><parent link="upper"/><child link="tip"/></joint></robot>)";

class FileCommands : public ::testing::Test {
 protected:
  FileCommands() { fs::current_path(folder_.path()); }
  ~FileCommands() override { fs::current_path(before_); }

  /// Exit status and what was said on standard error.
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), "hapticell-cli");
    words.insert(words.end(), {"--json", "result.json"});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    ::testing::internal::CaptureStderr();
    const int status = runCommandLine(static_cast<int>(argv.size()), argv.data());
    said_ = ::testing::internal::GetCapturedStderr();
    return status;
  }
  json result() const { return json::parse(std::ifstream("result.json")); }
  json document(const char* name) const { return json::parse(std::ifstream(name)); }

  fs::path before_ = fs::current_path();
  test::TemporaryFolder folder_;
  std::string said_;
};

TEST_F(FileCommands, InspectGivesSizesInMetresAndTheGuessedUnit) {
  folder_.write("part.obj", kTetrahedron);
  ASSERT_EQ(run({"inspect", "part.obj"}), 0) << said_;
  EXPECT_EQ(result()["format"], "obj");
  EXPECT_EQ(result()["unit"], "m");
  EXPECT_NEAR(result()["entities"][0]["volume"], 1.0 / 6.0, 1e-12);
  ASSERT_EQ(run({"inspect", "part.obj", "--unit", "in"}), 0) << said_;
  EXPECT_NEAR(result()["entities"][0]["bounds"]["max"][0], 0.0254, 1e-12);
  EXPECT_THAT(result()["warnings"], IsEmpty());
  EXPECT_EQ(run({"inspect", "part.obj", "--unit", "ell"}), 2);

  folder_.write("big.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\nf 1 2 2\n");
  ASSERT_EQ(run({"inspect", "big.obj"}), 0) << said_;
  const json big = result();
  EXPECT_EQ(big["unit"], "mm");
  EXPECT_EQ(big["entities"][0]["triangles"], 2);  // As the file has it; the one without area is told as a warning.
  EXPECT_NEAR(big["entities"][0]["bounds"]["max"][1], 0.1, 1e-12);
  EXPECT_EQ(big["entities"][0]["closed"], false);
  EXPECT_EQ(big["warnings"].size(), 4u);  // Unit guessed, no area, a hole, not closed.
}

TEST_F(FileCommands, InspectShowsARobotWithItsLinks) {
  folder_.write("arm.urdf", kArm);
  ASSERT_EQ(run({"inspect", "arm.urdf"}), 0) << said_;
  EXPECT_EQ(result()["format"], "urdf");
  const json robot = result()["entities"][0];
  EXPECT_EQ(robot["kind"], "robot");
  EXPECT_EQ(robot["dof"], 1);
  EXPECT_EQ(robot["joints"][0]["type"], "continuous");
  EXPECT_TRUE(robot["joints"][0]["lower"].is_null());
  EXPECT_EQ(robot["triangles"], 0);
  ASSERT_EQ(robot["children"].size(), 1u);
  EXPECT_EQ(robot["children"][0]["name"], "upper");
  EXPECT_EQ(robot["children"][0]["triangles"], 12);
  EXPECT_NEAR(robot["bounds"]["max"][2], 1.0, 1e-12);
  EXPECT_NEAR(robot["volume"], 0.08, 1e-12);
}

TEST_F(FileCommands, WorkcellNewWritesWhatInspectShows) {
  folder_.write("part.obj", kTetrahedron);
  folder_.write("arm.urdf", kArm);
  ASSERT_EQ(run({"workcell", "new", "cell.hcell", "--add", "part.obj,unit=mm,pose=1,2,-3,0.7071068,0,0,0.7071068",
                 "--add", "part.obj", "--add", "arm.urdf,name=robot", "--add", "box:0.1,0.2,0.3,name=block", "--check",
                 "robot+block:part,near_miss=0.03,safety=0.004", "--check", "block:"}),
            0)
      << said_;
  EXPECT_EQ(result()["entities"], json({"part", "part 2", "robot", "block"}));
  const json written = document("cell.hcell");
  EXPECT_EQ(written["format"], "hapticell-workcell");
  EXPECT_EQ(written["version"], 1);
  EXPECT_EQ(written["entities"][0]["source"]["file"], "part.obj");
  EXPECT_EQ(written["pair_sets"][0]["first"], json({"robot", "block"}));
  EXPECT_EQ(written["pair_sets"][0]["safety_distance"], 0.004);
  EXPECT_EQ(written["pair_sets"][0]["near_miss"], 0.03);
  EXPECT_EQ(written["pair_sets"][1]["second"], json::array());

  ASSERT_EQ(run({"inspect", "cell.hcell"}), 0) << said_;
  const json cell = result();
  ASSERT_EQ(cell["entities"].size(), 4u);
  // Turned by a quarter about z: its x axis points along y.
  EXPECT_NEAR(cell["entities"][0]["bounds"]["max"][1], 2.001, 1e-9);
  EXPECT_NEAR(cell["entities"][0]["bounds"]["min"][0], 0.999, 1e-9);
  EXPECT_NEAR(cell["entities"][3]["volume"], 0.006, 1e-12);
  EXPECT_EQ(cell["pair_sets"].size(), 2u);
}

TEST_F(FileCommands, InspectWeighsWhatARobotCarries) {
  ASSERT_EQ(run({"workcell", "new", "cell.hcell", "--add", "library:kuka_kr16_2,name=robot", "--add",
                 "box:0.1,0.1,0.1,name=casting,on=robot"}),
            0)
      << said_;
  ASSERT_EQ(run({"inspect", "cell.hcell"}), 0) << said_;
  json load = result()["loads"][0];
  EXPECT_EQ(load["robot"], "robot");
  EXPECT_EQ(load["payload"], 16.0);
  EXPECT_EQ(load["parts"], json::array({"casting"}));
  EXPECT_EQ(load["mass_not_entered"], json::array({"casting"}));
  EXPECT_EQ(load["verdict"], "not known");
  json cell = document("cell.hcell");
  for (json& entity : cell["entities"])
    if (entity["name"] == "casting") entity["mass"] = 20.0;
  std::ofstream("cell.hcell") << cell;
  ASSERT_EQ(run({"inspect", "cell.hcell"}), 0) << said_;
  load = result()["loads"][0];
  EXPECT_EQ(load["mass"], 20.0);
  EXPECT_EQ(load["mass_not_entered"], json::array());
  EXPECT_EQ(load["verdict"], "too heavy");
}

TEST_F(FileCommands, InspectPutsEntitiesBelowTheirAssembly) {
  folder_.write("cell.hcell", R"({"format": "hapticell-workcell", "version": 1, "entities": [
    {"name": "a", "source": {"file": "box:1,1,1"}, "parent": "fixture"},
    {"name": "b", "source": {"file": "sphere:1"}},
    {"name": "c", "source": {"file": "box:1,1,2"}, "parent": "fixture", "placement": {"position": [5, 0, 0]}}]})");
  ASSERT_EQ(run({"inspect", "cell.hcell"}), 0) << said_;
  const json tree = result()["entities"];
  ASSERT_EQ(tree.size(), 2u);
  EXPECT_EQ(tree[0]["kind"], "assembly");
  EXPECT_EQ(tree[0]["triangles"], 0);
  EXPECT_EQ(tree[0]["children"].size(), 2u);
  EXPECT_NEAR(tree[0]["volume"], 3.0, 1e-12);
  EXPECT_NEAR(tree[0]["bounds"]["max"][0], 5.5, 1e-12);
}

TEST_F(FileCommands, FramesOfTheCellAreMadeAndListed) {
  folder_.write("arm.urdf", kArm);
  ASSERT_EQ(
      run({"workcell", "new", "cell.hcell", "--add", "arm.urdf", "--add",
           "frame:,name=station,pose=1,2,3,0.5,0.5,0.5,0.5", "--add",
           "frame:,name=flange,pose=0,0,1,1,0,0,0,on=arm:upper", "--add", "box:0.1,0.1,0.1,name=part,on=station"}),
      0)
      << said_;
  ASSERT_EQ(run({"inspect", "cell.hcell"}), 0) << said_;
  const json tree = result()["entities"];
  ASSERT_EQ(tree.size(), 4u);
  EXPECT_EQ(tree[1]["kind"], "frame");
  EXPECT_EQ(tree[1]["name"], "station");
  EXPECT_EQ(tree[1]["triangles"], 0);
  EXPECT_TRUE(tree[1]["bounds"].is_null());
  EXPECT_THAT(tree[1]["placement"]["position"], ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(tree[1]["placement"]["quaternion"], ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_TRUE(tree[1]["attached_to"].is_null());
  EXPECT_EQ(tree[2]["attached_to"], "arm");
  EXPECT_EQ(tree[2]["attached_link"], "upper");
  EXPECT_EQ(run({"workcell", "new", "other.hcell", "--add", "frame:1,2"}), 2);
  EXPECT_THAT(said_, HasSubstr("frame: alone"));
}

TEST_F(FileCommands, WhatIsWrongIsOneSentenceAndNothingIsWritten) {
  folder_.write("part.obj", kTetrahedron);
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--add", "gone.stl"}, "gone.stl: the file does not exist"},
      {{"--add", "part.obj,unit=furlong"}, "furlong"},
      {{"--add", "part.obj,pose=1,2,3"}, "seven numbers"},
      {{"--add", "part.obj,pose=0,0,0,1,0,0,nan"}, "seven numbers"},
      {{"--add", "part.obj,pose=0,0,0,2,0,0,0"}, "length 1"},
      {{"--add", "part.obj,name=a", "--add", "part.obj,name=a"}, "already in use"},
      {{"--add", "mannequin:male:500"}, "0.1 to 99.9"},
      {{"--add", "library:nothing"}, "library:nothing"},
      {{"--add", "box:1,2"}, "box:length (above 0), width (above 0), height (above 0)"},
      {{"--add", "part.obj", "--check", "part:table"}, "no entity is named 'table'; expected one of part"},
      {{"--add", "part.obj", "--check", "part"}, "colon"},
      {{"--add", "part.obj", "--check", "part:,safety=-1"}, "metres, 0 to 1"},
  };
  for (const auto& [words, sentence] : cases) {
    std::vector<std::string> all{"workcell", "new", "cell.hcell"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(run(all), 2) << words[1];
    EXPECT_THAT(said_, HasSubstr(sentence));
    EXPECT_EQ(std::count(said_.begin(), said_.end(), '\n'), 1) << said_;
    EXPECT_FALSE(fs::exists("cell.hcell"));
  }
  EXPECT_EQ(run({"workcell", "new", "cell.txt", "--add", "part.obj"}), 2);
  EXPECT_EQ(run({"workcell", "new", "missing/cell.hcell", "--add", "part.obj"}), 2);
  EXPECT_EQ(run({"inspect", "none.hcell"}), 2);
}

}  // namespace
}  // namespace hapticell::cli
