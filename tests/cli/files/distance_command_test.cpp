// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

using nlohmann::json;

constexpr const char* kUnitCube =
    "v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv 0.5 0.5 -0.5\nv -0.5 0.5 -0.5\nv -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\nv 0.5 0.5 "
    "0.5\n"
    "v -0.5 0.5 0.5\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class DistanceCommand : public testing::Test {
 protected:
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"hapticell-cli", "distance"});
    words.insert(words.end(), {"--json", result_file_.string()});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    return runCommandLine(static_cast<int>(argv.size()), argv.data());
  }
  int runOn(const std::string& rows, std::vector<std::string> more = {}) {
    const auto poses = folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n" + rows);
    std::vector<std::string> words{"--moving", cube_, "--environment", cube_, "--poses", poses.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  json result() const { return json::parse(std::ifstream(result_file_)); }

  test::TemporaryFolder folder_;
  std::string cube_ = folder_.write("cube.obj", kUnitCube).string();
  std::filesystem::path result_file_ = folder_.path() / "result.json";
};

TEST_F(DistanceCommand, AnswersEveryPoseInOrder) {
  ASSERT_EQ(runOn("1.5,0,0,1,0,0,0\n1,0,0,1,0,0,0\n0,0,2,1,0,0,0\n0.1,0,0,1,0,0,0\n"), 0);
  const json results = result()["results"];
  ASSERT_EQ(results.size(), 4u);
  EXPECT_NEAR(results[0]["distance"], 0.5, 1e-12);
  EXPECT_EQ(results[0]["normal"], json::parse("[1.0,0.0,0.0]"));
  EXPECT_EQ(results[0]["point_on_moving"][0], 1.0);
  EXPECT_EQ(results[0]["point_on_environment"][0], 0.5);
  EXPECT_EQ(results[1]["distance"], 0.0);
  EXPECT_EQ(results[1]["colliding"], true);
  EXPECT_NEAR(results[2]["distance"], 1.0, 1e-12);
  EXPECT_EQ(results[3]["colliding"], true);
  for (const char* field : {"median_us", "p99_us", "max_us", "build_ms"}) EXPECT_GE(result()["timing"][field], 0.0);
}

TEST_F(DistanceCommand, ZonesLeaveFarPosesOutAndCountContacts) {
  ASSERT_EQ(runOn("1.5,0,0,1,0,0,0\n1.005,0,0,1,0,0,0\n", {"--safety-zone", "0.01"}), 0);
  const json results = result()["results"];
  EXPECT_TRUE(results[0]["distance"].is_null());
  EXPECT_EQ(results[0]["distance_at_least"], 0.01);
  EXPECT_EQ(results[0]["contacts"], 0);
  EXPECT_NEAR(results[1]["distance"], 0.005, 1e-12);
  EXPECT_EQ(results[1]["contacts"], 1);
}

TEST_F(DistanceCommand, UnitsScaleTheMeshesAndNotThePoses) {
  ASSERT_EQ(runOn("0.1,0,0,1,0,0,0\n", {"--unit", "in"}), 0);
  EXPECT_NEAR(result()["results"][0]["distance"], 0.1 - 0.0254, 1e-12);
}

TEST_F(DistanceCommand, SeveralEnvironmentsAnswerTogether) {
  const auto poses = folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n3,0,0,1,0,0,0\n");
  const auto other = folder_.write("far.obj", "v 4 -1 -1\nv 4 1 -1\nv 4 0 1\nf 1 2 3\n");
  ASSERT_EQ(run({"--moving", cube_, "--environment", cube_, other.string(), "--poses", poses.string()}), 0);
  EXPECT_NEAR(result()["results"][0]["distance"], 0.5, 1e-12);
  EXPECT_EQ(result()["results"][0]["environment"], 1);
}

/// Where they intersect both points are one common point.
void expectCommonPoint(const json& result) {
  EXPECT_EQ(result["distance"], 0.0);
  EXPECT_EQ(result["colliding"], true);
  EXPECT_EQ(result["point_on_moving"], result["point_on_environment"]);
  EXPECT_GE(result["contacts"], 1);
}

TEST_F(DistanceCommand, TouchingNestedAndCoincidentMeshesCollide) {
  const auto small = folder_.write("small.obj",
                                   "v -0.1 -0.1 -0.1\nv 0.1 -0.1 -0.1\nv 0 0.1 -0.1\nv 0 0 0.1\n"
                                   "f 3 2 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const auto poses = folder_.write("poses.csv",
                                   "x,y,z,qw,qx,qy,qz\n0.6,0,0,1,0,0,0\n0,0,0,1,0,0,0\n0.3,0.3,0.3,1,0,0,0\n"
                                   "0.600001,0,0,1,0,0,0\n");
  ASSERT_EQ(run({"--moving", small.string(), "--environment", cube_, "--poses", poses.string()}), 0);
  const json results = result()["results"];
  for (const int i : {0, 1, 2}) expectCommonPoint(results[static_cast<std::size_t>(i)]);
  EXPECT_EQ(results[0]["contained"], false);
  EXPECT_EQ(results[1]["contained"], true);
  EXPECT_NEAR(results[3]["distance"], 1e-6, 1e-12);
  EXPECT_EQ(results[3]["colliding"], false);
  ASSERT_EQ(runOn("0,0,0,1,0,0,0\n"), 0);
  expectCommonPoint(result()["results"][0]);
}

TEST_F(DistanceCommand, AnOpenShellIsARoomAndNotASolid) {
  const auto room = folder_.write("room.obj", std::string(kUnitCube).substr(0, std::string(kUnitCube).rfind("f ")));
  const auto inside = folder_.write("inside.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
  const auto poses = folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0,0,0.2,1,0,0,0\n");
  ASSERT_EQ(run({"--moving", inside.string(), "--environment", room.string(), "--poses", poses.string()}), 0);
  EXPECT_NEAR(result()["results"][0]["distance"], 0.3, 1e-12);
  EXPECT_EQ(result()["results"][0]["colliding"], false);
}

TEST_F(DistanceCommand, TrianglesWithoutAreaCountAsWhatTheyAre) {
  const auto thin = folder_.write("thin.obj", "v 0 0 0\nv 0 0 1\nv 0 0 2\nv 5 0 0\nf 1 2 3\nf 4 4 4\n");
  const auto poses = folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n1,0,1,1,0,0,0\n4.25,0,0,1,0,0,0\n");
  ASSERT_EQ(run({"--moving", cube_, "--environment", thin.string(), "--poses", poses.string(), "--unit", "m"}), 0);
  EXPECT_NEAR(result()["results"][0]["distance"], 0.5, 1e-12);
  EXPECT_NEAR(result()["results"][1]["distance"], 0.25, 1e-12);
}

TEST_F(DistanceCommand, MicrometresAreKeptFarFromTheOrigin) {
  const auto far = folder_.write("far.obj", "v 20 -1 -1\nv 20 1 -1\nv 20 0 1\nf 1 2 3\n");
  const auto poses = folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n19.499999,0,0,1,0,0,0\n20.5000005,0,0,1,0,0,0\n");
  ASSERT_EQ(run({"--moving", cube_, "--environment", far.string(), "--poses", poses.string()}), 0);
  EXPECT_NEAR(result()["results"][0]["distance"], 1e-6, 1e-10);
  EXPECT_NEAR(result()["results"][1]["distance"], 5e-7, 1e-10);
  EXPECT_NEAR(result()["results"][0]["point_on_environment"][0], 20.0, 1e-10);
}

TEST_F(DistanceCommand, ExitStatusTellsWhatHappened) {
  EXPECT_EQ(runOn("0.1,0,0,1,0,0,0\n", {"--fail-on-contact"}), 1);
  EXPECT_EQ(runOn("3,0,0,1,0,0,0\n", {"--fail-on-contact"}), 0);
  std::filesystem::remove(result_file_);
  EXPECT_EQ(runOn("3,0,0,2,0,0,0\n"), 2);
  EXPECT_EQ(runOn("3,0,0,1,0,0,0\n", {"--unit", "ell"}), 2);
  EXPECT_EQ(runOn("3,0,0,1,0,0,0\n", {"--safety-zone", "-1"}), 2);
  EXPECT_EQ(run({"--moving", "none.stl", "--environment", cube_, "--poses", "none.csv"}), 2);
  EXPECT_EQ(run({"--moving", cube_}), 2);
  EXPECT_FALSE(std::filesystem::exists(result_file_)) << "no half result is left";
}

}  // namespace
}  // namespace hapticell::cli
