// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/live_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "bridge/ros2/ros_conversion.h"
#include "bridge/ros2/ros_listener.h"
#include "bridge/ros2/taken_samples.h"
#include "bridge/ros2/topic_list.h"
#include "tests/bridge/ros2/private_domain.h"
#include "tests/bridge/ros2/slide_cell.h"
#include "tests/support/test_data.h"

namespace hapticell::bridge {
namespace {

/// What a test writes to standard input, for as long as it lives.
class GivenInput {
 public:
  GivenInput() : before_(::dup(STDIN_FILENO)) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe(ends), 0);
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
    writing_ = ends[1];
  }
  ~GivenInput() {
    end();
    if (before_ < 0) {
      ::close(STDIN_FILENO);
      return;
    }
    ::dup2(before_, STDIN_FILENO);
    ::close(before_);
  }
  GivenInput(const GivenInput&) = delete;
  GivenInput& operator=(const GivenInput&) = delete;

  void put(const std::string& text) const {
    EXPECT_EQ(::write(writing_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void end() {
    if (writing_ >= 0) ::close(writing_);
    writing_ = -1;
  }

 private:
  int before_, writing_ = -1;
};

LiveLinkOptions linkOf(const SlideCell& cell) {
  LiveLinkOptions options;
  options.node = PrivateDomain::options();
  options.workcell = cell.wanted.workcell;
  return options;
}

/// What another node heard of the robot and its base.
struct HeardSlide {
  std::unique_ptr<RosNode> node = PrivateDomain::node();
  dds_entity_t joints = node->subscribe("/joint_states", sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault).value_or(0);
  dds_entity_t frames = node->subscribe("/tf", tf2_msgs_msg_dds__TFMessage__desc, RosQuality::kTransforms).value_or(0);
  std::vector<double> positions;
  std::vector<Pose> bases;

  void take() {
    takeAll<sensor_msgs_msg_dds__JointState_>(joints, [this](const auto& state) {
      ASSERT_EQ(state.position._length, 1u);
      EXPECT_STREQ(state.name._buffer[0], "x");
      positions.push_back(state.position._buffer[0]);
    });
    takeAll<tf2_msgs_msg_dds__TFMessage_>(frames, [this](const auto& message) {
      for (std::uint32_t i = 0; i < message.transforms._length; ++i) {
        const auto& frame = message.transforms._buffer[i];
        if (std::string(frame.child_frame_id) != "base") continue;
        EXPECT_STREQ(frame.header.frame_id, "world");
        const auto& [p, q] = frame.transform;
        bases.push_back({{p.x, p.y, p.z}, dquat(q.w, q.x, q.y, q.z)});
      }
    });
  }
};

TEST(LiveLink, PublishesTheRobotWhereTheWindowHasIt) {
  const SlideCell cell(0.1, 1.0);
  const PrivateDomain domain;
  HeardSlide heard;
  GivenInput input;
  // Half a turn about z, written 0.05 % too long.
  input.put("{\"joints\": [0.9], \"place\": [9, 9, 9, 1, 0, 0, 0]}\n{\"joints\": [0.25], \"place\": [1, 2, 3, 0, 0, 0, 1.0005]}\n");
  input.end();
  const std::atomic<bool> stop{false};
  const auto result = runLiveLink(linkOf(cell), stop);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_TRUE(eventually([&] { return heard.take(), !heard.positions.empty() && !heard.bases.empty(); }));
  for (const double position : heard.positions) EXPECT_EQ(position, 0.25) << "the newest line counts";
  for (const Pose& X_WB : heard.bases) {
    EXPECT_EQ(X_WB.p, dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(std::abs(X_WB.q.z), 1.0, 1e-12);
  }
  EXPECT_EQ((*result)["robot"], "slide");
  EXPECT_GE((*result)["published"]["/joint_states"].get<int>(), 1);
  EXPECT_EQ((*result)["published"]["/robot_description"], 1);
  EXPECT_EQ((*result)["readers"]["/joint_states"], 1);
}

TEST(LiveLink, LinesThatDoNotFitTheRobotMoveNothing) {
  const SlideCell cell(0.1, 1.0);
  const PrivateDomain domain;
  for (const char* line : {"no JSON", "[0.25]", "{\"joints\": [0.25, 0.5]}", "{\"joints\": [\"a\"]}", "{\"joints\": 0.25}",
                           "{\"place\": [1, 2, 3, 0, 0, 0, 2]}", "{\"place\": [1, 2, 3]}", "{\"place\": [1, 2, 3, 0, 0, 0, null]}", ""}) {
    HeardSlide heard;
    GivenInput input;
    input.put(std::string(line) + "\n");
    input.end();
    const std::atomic<bool> stop{false};
    ASSERT_TRUE(runLiveLink(linkOf(cell), stop)) << line;
    EXPECT_TRUE(eventually([&] { return heard.take(), !heard.positions.empty() && !heard.bases.empty(); })) << line;
    EXPECT_EQ(heard.positions.back(), 0.0) << line;
    EXPECT_EQ(heard.bases.back().p, dvec3(0.0)) << line;
  }
}

TEST(LiveLink, HearsTheJointsOfTheRobot) {
  const SlideCell cell(0.1, 1.0);
  const PrivateDomain domain;
  const auto robots = PrivateDomain::node();
  const auto writer = robots->advertise("/slide/joints", sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault);
  ASSERT_TRUE(writer);
  GivenInput input;
  // Its message is there before the input ends, so that the link's last look finds it.
  std::thread robot([&] {
    EXPECT_TRUE(eventually([&] { return robots->readersOf(*writer) == 1; }));
    JointStateMessage message({"elbow", "x"});
    EXPECT_TRUE(robots->write(*writer, message.at(0, {9.0, -0.5})));
    input.end();
  });
  LiveLinkOptions options = linkOf(cell);
  options.mirror = true;
  options.joint_topic = "/slide/joints";
  const std::atomic<bool> stop{false};
  ::testing::internal::CaptureStdout();
  const auto result = runLiveLink(options, stop);
  std::istringstream said(::testing::internal::GetCapturedStdout());
  robot.join();
  ASSERT_TRUE(result) << result.error().message();
  std::vector<nlohmann::json> heard;
  for (std::string line; std::getline(said, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(json.is_object()) << line;
    if (json.contains("heard")) heard.push_back(json["heard"]);
  }
  EXPECT_EQ(heard, std::vector<nlohmann::json>{nlohmann::json::array({-0.5})}) << "joints of others are left out";
  EXPECT_TRUE(result->contains("heard_hz"));
  EXPECT_FALSE(result->contains("published")) << "it only hears";
  const auto& topics = (*result)["topics"];
  const auto heard_topic = std::find_if(topics.begin(), topics.end(), [](const auto& topic) { return topic["name"] == "/slide/joints"; });
  ASSERT_NE(heard_topic, topics.end()) << topics.dump();
  EXPECT_EQ((*heard_topic)["type"], "sensor_msgs::msg::dds_::JointState_");
  EXPECT_EQ((*heard_topic)["publishers"], 1);
  EXPECT_EQ((*heard_topic)["subscribers"], 0) << "its own does not count";
}

TEST(LiveLink, StoppedAtOnceItStillHasAResult) {
  const SlideCell cell(0.1, 1.0);
  const PrivateDomain domain;
  const std::atomic<bool> stop{true};
  const auto result = runLiveLink(linkOf(cell), stop);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_EQ((*result)["robot"], "slide");
  EXPECT_EQ((*result)["published"]["/joint_states"], 0);
  EXPECT_EQ((*result)["published"]["/robot_description"], 1);
  EXPECT_TRUE((*result)["topics"].empty()) << (*result)["topics"].dump();
}

TEST(LiveLink, RefusesACellThatIsMissingAndARobotThatIsNotThere) {
  const SlideCell cell(0.1, 1.0);
  const std::atomic<bool> stop{true};
  LiveLinkOptions options = linkOf(cell);
  options.entity = "wall";
  const auto no_robot = runLiveLink(options, stop);
  ASSERT_FALSE(no_robot);
  EXPECT_THAT(no_robot.error().message(), ::testing::HasSubstr("'wall'"));
  EXPECT_THAT(no_robot.error().message(), ::testing::HasSubstr("slide"));
  options.workcell = (cell.folder.path() / "missing.hcell").string();
  const auto missing = runLiveLink(options, stop);
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message(), ::testing::HasSubstr("missing.hcell"));
}

TEST(FindTopics, ListsWhatOthersPublishAndReadByName) {
  const PrivateDomain domain;
  const auto others = PrivateDomain::node();
  for (const char* topic : {"/left/joint_states", "/right/joint_states", "/left/joint_states"})
    ASSERT_TRUE(others->advertise(topic, sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault));
  ASSERT_TRUE(others->subscribe("/left/robot_description", std_msgs_msg_dds__String__desc, RosQuality::kLatched));
  std::atomic<bool> stop{false};
  TopicSearch search{PrivateDomain::options(), 30.0, [&stop](const auto& found) { stop = found["topics"].size() == 3; }};
  const auto found = findTopics(search, stop);
  ASSERT_TRUE(found) << found.error().message();
  const auto& topics = (*found)["topics"];
  ASSERT_EQ(topics.size(), 3u) << topics.dump();
  const auto row = [](const char* name, const char* type, int publishers, int subscribers) {
    return nlohmann::ordered_json{{"name", name}, {"type", type}, {"publishers", publishers}, {"subscribers", subscribers}};
  };
  EXPECT_EQ(topics[0], row("/left/joint_states", "sensor_msgs::msg::dds_::JointState_", 2, 0));
  EXPECT_EQ(topics[1], row("/left/robot_description", "std_msgs::msg::dds_::String_", 0, 1));
  EXPECT_EQ(topics[2], row("/right/joint_states", "sensor_msgs::msg::dds_::JointState_", 1, 0));
}

TEST(Listen, TakesTheDescriptionOfTheNamedTopic) {
  const test::TemporaryFolder folder;
  const PrivateDomain domain;
  const auto robots = PrivateDomain::node();
  for (const std::string side : {"left", "right"}) {
    const auto writer = robots->advertise("/" + side + "/robot_description", std_msgs_msg_dds__String__desc, RosQuality::kLatched);
    ASSERT_TRUE(writer);
    std::string urdf = "<robot name=\"" + side + "\"><link name=\"base\"/></robot>";
    const std_msgs_msg_dds__String_ message{urdf.data()};
    ASSERT_TRUE(robots->write(*writer, &message));
  }
  ListenOptions options;
  options.node = PrivateDomain::options();
  options.description = (folder.path() / "robot.urdf").string();
  options.description_topic = "/right/robot_description";
  options.seconds = 30.0;
  const std::atomic<bool> stop{false};
  const auto heard = listen(options, stop);
  ASSERT_TRUE(heard) << heard.error().message();
  std::ifstream file(options.description);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "<robot name=\"right\"><link name=\"base\"/></robot>");
  options.description_topic = "/nobody";
  options.seconds = 0.05;
  const auto nobody = listen(options, stop);
  ASSERT_FALSE(nobody);
  EXPECT_THAT(nobody.error().message(), ::testing::HasSubstr("/nobody"));
}

}  // namespace
}  // namespace hapticell::bridge
