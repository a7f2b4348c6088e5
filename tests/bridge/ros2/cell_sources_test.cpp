// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/cell_sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptic/transport/pairing_key.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"

namespace hapticell::bridge {
namespace {

using ::testing::HasSubstr;

/// A cell with a wall and robots of one sliding joint, by their names.
workcell::Document cellWithRobots(const test::TemporaryFolder& folder, const std::vector<std::string>& robots) {
  folder.write("rail.urdf", R"(<robot name="rail"><link name="base"/><link name="block"/><joint name="slide" type="prismatic">
    <parent link="base"/><child link="block"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>)");
  std::string entities = R"({"name": "wall", "source": {"file": "box:0.1,1,1"}})";
  for (const std::string& robot : robots) entities += R"(, {"name": ")" + robot + R"(", "source": {"file": "rail.urdf"}})";
  Diagnostics notes;
  auto read = workcell::parseDocument(R"({"format": "hapticell-workcell", "version": 1, "entities": [)" + entities + "]}",
                                      folder.path(), "cell.hcell", notes);
  if (!read) throw std::runtime_error(read.error().message());
  return std::move(*read);
}

std::string refusalOf(const workcell::Document& document, const std::string& entity) {
  const auto robot = robotToPublish(document, entity, "cell.hcell");
  return robot ? "the robot " + (*robot)->name : robot.error().message();
}

TEST(RobotToPublish, IsTheOnlyOneOrTheNamedOne) {
  const test::TemporaryFolder folder;
  const auto one = robotToPublish(cellWithRobots(folder, {"left"}), "", "cell.hcell");
  ASSERT_TRUE(one) << one.error().message();
  EXPECT_EQ((*one)->name, "left");
  const workcell::Document cell = cellWithRobots(folder, {"left", "middle", "right"});
  for (const char* name : {"left", "middle", "right"}) {
    const auto named = robotToPublish(cell, name, "cell.hcell");
    ASSERT_TRUE(named) << named.error().message();
    EXPECT_EQ(named->get(), cell.findByName(name));
  }
}

TEST(RobotToPublish, ARefusalNamesTheRobotsThatThereAre) {
  const test::TemporaryFolder folder;
  const std::string none = refusalOf(cellWithRobots(folder, {}), "");
  EXPECT_THAT(none, HasSubstr("cell.hcell"));
  EXPECT_THAT(none, HasSubstr("no robot"));
  const workcell::Document cell = cellWithRobots(folder, {"left", "right"});
  EXPECT_THAT(refusalOf(cell, ""), HasSubstr("left, right"));
  EXPECT_THAT(refusalOf(cellWithRobots(folder, {"a", "b", "c"}), ""), HasSubstr("a, b, c"));
  for (const char* other : {"middle", "wall"}) {
    const std::string said = refusalOf(cell, other);
    EXPECT_THAT(said, HasSubstr("cell.hcell"));
    EXPECT_THAT(said, HasSubstr("'" + std::string(other) + "'"));
    EXPECT_THAT(said, HasSubstr("left, right"));
    EXPECT_THAT(said, HasSubstr("--entity"));
  }
}

TEST(ReplayOfFile, MovesTheRobotAsTheFileSays) {
  const test::TemporaryFolder folder;
  const workcell::Document cell = cellWithRobots(folder, {"left"});
  const auto file = folder.write("motion.csv", "t,slide\n1,0.25\n3,-0.75\n");
  std::vector<Text> notes;
  const auto replay = replayOfFile(cell, *cell.findByName("left"), file.string(), notes);
  ASSERT_TRUE(replay) << replay.error().message();
  EXPECT_EQ(replay->entity(), cell.findByName("left")->id);
  for (const double t : {1.0, 1.5, 2.75, 3.0}) {  // -0.5 m/s from 0.25 m on.
    ASSERT_EQ(replay->at(t).joints.size(), 1u);
    EXPECT_NEAR(replay->at(t).joints[0], 0.25 - 0.5 * (t - 1.0), 1e-12) << t;
  }
}

TEST(ReplayOfFile, ARefusalNamesTheFile) {
  const test::TemporaryFolder folder;
  const workcell::Document cell = cellWithRobots(folder, {"left"});
  const workcell::Entity& robot = *cell.findByName("left");
  std::vector<Text> notes;
  for (const char* name : {"missing.htraj", "missing.csv", "missing.mcap"}) {
    const std::string missing = (folder.path() / name).string();
    const auto replay = replayOfFile(cell, robot, missing, notes);
    ASSERT_FALSE(replay);
    EXPECT_EQ(replay.error().file, missing);
    EXPECT_FALSE(replay.error().found.empty());
  }
  const std::string strange = folder.write("strange.csv", "t,elbow\n0,0.25\n1,0.5\n").string();
  const auto replay = replayOfFile(cell, robot, strange, notes);
  ASSERT_FALSE(replay);
  EXPECT_EQ(replay.error().file, strange);
  EXPECT_THAT(replay.error().message(), HasSubstr("elbow"));
}

/// The folder of settings for one test.
class SettingsIn {
 public:
  explicit SettingsIn(const std::filesystem::path& folder) {
    if (const char* const before = std::getenv(kVariable)) before_ = before;
    ::setenv(kVariable, folder.c_str(), 1);
  }
  ~SettingsIn() { before_ ? ::setenv(kVariable, before_->c_str(), 1) : ::unsetenv(kVariable); }
  SettingsIn(const SettingsIn&) = delete;
  SettingsIn& operator=(const SettingsIn&) = delete;

 private:
  static constexpr const char* kVariable = "XDG_CONFIG_HOME";
  std::optional<std::string> before_;
};

TEST(WatchedServer, WithoutAnAddressThereIsNone) {
  const auto link = watchedServer("", "--hold");
  ASSERT_TRUE(link) << link.error().message();
  EXPECT_EQ(*link, nullptr);
}

TEST(WatchedServer, AnAddressWithoutAPortIsRefusedBeforeAnyServerIsLookedFor) {
  for (const char* wrong : {"127.0.0.1", "station-2", ":4799", "127.0.0.1:", "127.0.0.1:0", "127.0.0.1:65536", "127.0.0.1:47x"}) {
    const auto link = watchedServer(wrong, "--hold");
    ASSERT_FALSE(link) << wrong;
    EXPECT_THAT(link.error().message(), HasSubstr("--hold: '" + std::string(wrong) + "'; expected HOST:PORT"));
  }
}

// Servers that do not answer or refuse are tested with haptic/client/server_watch.h, whose wait a test can shorten.
TEST(WatchedServer, LooksForTheKeyOfHostAndPort) {
  const test::TemporaryFolder folder;
  const SettingsIn settings(folder.path());
  const auto key = haptic::knownServerKeyFile("127.0.0.1", 4799);
  std::filesystem::create_directories(key.parent_path());
  std::filesystem::copy_file(folder.write("no.key", "this is no key\n"), key);
  std::filesystem::permissions(key, std::filesystem::perms::owner_read | std::filesystem::perms::others_read);
  const auto link = watchedServer("127.0.0.1:4799", "--hold");
  ASSERT_FALSE(link) << "others can read the key";
  EXPECT_EQ(link.error().file, key.string());
  EXPECT_THAT(link.error().message(), HasSubstr("other users can read"));
}

}  // namespace
}  // namespace hapticell::bridge
