// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/published_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/ros2/taken_samples.h"
#include "tests/bridge/ros2/private_domain.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::bridge {
namespace {

/// A crane in a cell: a plate on the base turned by 0.5 rad, an arm that turns on it, a slide that reaches out of the arm,
/// and a tool that turns back as far as the arm turned.
struct CraneCell {
  test::TemporaryFolder folder;
  workcell::Document document;
  std::shared_ptr<const workcell::Entity> crane;

  CraneCell() {
    folder.write("crane.urdf", R"(<robot name="crane"><link name="base"/><link name="plate"/><link name="arm"><visual><geometry>
      <box size="0.4 0.1 0.1"/></geometry></visual></link><link name="slide"/><link name="tool"/>
      <joint name="mount" type="fixed"><parent link="base"/><child link="plate"/><origin xyz="0 0 0.3" rpy="0 0 0.5"/></joint>
      <joint name="turn" type="revolute"><parent link="plate"/><child link="arm"/><axis xyz="0 0 1"/>
        <limit lower="-2" upper="2.5" velocity="1" effort="1"/></joint>
      <joint name="reach" type="prismatic"><parent link="arm"/><child link="slide"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
        <limit lower="0" upper="0.6" velocity="0.5" effort="1"/></joint>
      <joint name="level" type="continuous"><parent link="slide"/><child link="tool"/><origin xyz="0.1 0 0"/><axis xyz="0 0 1"/>
        <mimic joint="turn" multiplier="-1"/></joint></robot>)");
    Diagnostics notes;
    auto read = workcell::parseDocument(R"({"format": "hapticell-workcell", "version": 1, "entities": [
      {"name": "crane", "source": {"file": "crane.urdf"}, "placement": {"position": [1, 2, 3]}},
      {"name": "wall", "source": {"file": "box:0.1,1,1"}, "placement": {"position": [5, 0, 0]}}]})",
                                        folder.path(), "cell.hcell", notes);
    if (!read) throw std::runtime_error(read.error().message());
    document = std::move(*read);
    for (const auto& entity : document.state().entities)
      if (entity->name == "crane") crane = entity;
  }
  const kinematics::RobotModel& model() const { return *crane->robot(); }
};

/// A transform as readers of /tf have it: by its child, in its parent.
using Transforms = std::map<std::string, std::pair<std::string, Pose>>;

void addTransform(const geometry_msgs_msg_dds__TransformStamped_& message, Transforms& transforms) {
  const auto& [p, q] = message.transform;
  const Pose X{{p.x, p.y, p.z}, dquat(q.w, q.x, q.y, q.z)};
  EXPECT_TRUE(transforms.try_emplace(message.child_frame_id, std::string(message.header.frame_id), X).second)
      << message.child_frame_id << " has two parents";
}

Transforms transformsOf(const std::vector<geometry_msgs_msg_dds__TransformStamped_>& messages, std::int64_t stamp_ns) {
  Transforms transforms;
  for (const auto& message : messages) {
    EXPECT_EQ(nanosecondsOf(message.header.stamp), stamp_ns);
    addTransform(message, transforms);
  }
  return transforms;
}

/// The pose of a frame in the frame at the end of its parents.
Pose composed(const Transforms& transforms, const std::string& frame) {
  const auto found = transforms.find(frame);
  return found == transforms.end() ? Pose::identity() : composed(transforms, found->second.first) * found->second.second;
}

void expectSamePose(const Pose& a, const Pose& b, const std::string& what) {
  EXPECT_LT(glm::length(a.p - b.p), 1e-12) << what;
  EXPECT_LT(glm::length(rotationVector(a.q * glm::conjugate(b.q))), 1e-7) << what;
}

/// The tool of the crane by the trigonometry of its drawing.
Pose toolOfCrane(double turn, double reach) {
  const double radius = 0.4 + reach + 0.1;
  return {{radius * std::cos(0.5 + turn), radius * std::sin(0.5 + turn), 0.3}, glm::angleAxis(0.5, dvec3(0.0, 0.0, 1.0))};
}

std::set<std::string> childrenIn(const Transforms& transforms) {
  std::set<std::string> children;
  for (const auto& [child, in_parent] : transforms) children.insert(child);
  return children;
}

TEST(RobotFrames, ComposeToThePosesOfTheLinks) {
  const CraneCell cell;
  RobotFrames frames(cell.model());
  for (const auto& [turn, reach] : {std::pair(0.0, 0.0), {0.7, 0.25}, {-1.9, 0.6}}) {
    const std::vector<double> q{turn, reach};
    Transforms all = transformsOf(frames.at(q, false, 7'000'000'001), 7'000'000'001);
    EXPECT_EQ(childrenIn(all), (std::set<std::string>{"plate"})) << "fixed";
    const Transforms moving = transformsOf(frames.at(q, true, 8'000'000'002), 8'000'000'002);
    EXPECT_EQ(childrenIn(moving), (std::set<std::string>{"arm", "slide", "tool"}));
    all.insert(moving.begin(), moving.end());
    expectSamePose(composed(all, "tool"), toolOfCrane(turn, reach), "tool by hand");
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(cell.model(), q, X_BL);
    for (std::size_t k = 0; k < X_BL.size(); ++k)
      expectSamePose(composed(all, cell.model().links[k].name), X_BL[k], cell.model().links[k].name);
  }
}

TEST(RobotDescription, IsReadAgainAsTheSameRobot) {
  const CraneCell cell;
  const test::TemporaryFolder folder;
  const std::filesystem::path meshes = folder.path() / "cell 4 & \"5\" <élan> 100%";
  std::filesystem::create_directories(meshes);
  Diagnostics notes;
  const auto text = robotDescription(*cell.crane, meshes, notes);
  ASSERT_TRUE(text) << text.error().message();
  const auto read = workcell::readUrdfText(*text, "/nowhere/robot.urdf", notes, nullptr, workcell::RobotContent::kKinematics);
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->dof(), 2u);
  for (const kinematics::Joint& joint : cell.model().joints) {
    const int there = read->findJoint(joint.name);
    ASSERT_GE(there, 0) << joint.name;
    const kinematics::Joint& again = read->joints[static_cast<std::size_t>(there)];
    EXPECT_EQ(again.type, joint.type) << joint.name;
    EXPECT_EQ(again.variable, joint.variable) << joint.name;
    EXPECT_EQ(again.lower, joint.lower) << joint.name;
    EXPECT_EQ(again.upper, joint.upper) << joint.name;
    EXPECT_EQ(again.velocity, joint.velocity) << joint.name;
  }
  std::vector<Pose> X_WL;
  kinematics::forwardKinematics(*read, {0.7, 0.25}, X_WL);
  const int tool = read->findLink("tool");
  ASSERT_GE(tool, 0);
  expectSamePose(X_WL[static_cast<std::size_t>(tool)], cell.crane->X_WE * toolOfCrane(0.7, 0.25), "tool in the cell");
  // Shapes by whole addresses, so that readers in other folders find them.
  std::size_t shapes = 0;
  const std::string before = "filename=\"";
  for (std::size_t at = text->find(before); at != std::string::npos; at = text->find(before, at + 1), ++shapes) {
    const std::size_t begin = at + before.size();
    const std::string address = text->substr(begin, text->find('"', begin) - begin);
    ASSERT_TRUE(address.starts_with("file:///")) << address;
    std::string file;  // Percent codes read as RFC 3986 has them.
    for (std::size_t k = 7; k < address.size(); ++k) {
      ASSERT_EQ(std::string(" \"<>&").find(address[k]), std::string::npos) << address;
      const bool is_code = address[k] == '%';
      file += is_code ? static_cast<char>(std::stoi(address.substr(k + 1, 2), nullptr, 16)) : address[k];
      k += is_code ? 2 : 0;
    }
    EXPECT_TRUE(std::filesystem::is_regular_file(file)) << address;
  }
  EXPECT_GT(shapes, 0u) << "the arm's";
}

/// What another node hears of a cell.
struct HeardCell {
  explicit HeardCell(RosNode& node) : node_(node) {
    joints = open("/joint_states", sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault);
    moving = open("/tf", tf2_msgs_msg_dds__TFMessage__desc, RosQuality::kTransforms);
    clock = open("/clock", rosgraph_msgs_msg_dds__Clock__desc, RosQuality::kDefault);
  }
  dds_entity_t open(const char* topic, const dds_topic_descriptor_t& type, RosQuality quality) {
    const auto reader = node_.subscribe(topic, type, quality);
    EXPECT_TRUE(reader);
    return reader.value_or(0);
  }
  static Transforms transformsFrom(dds_entity_t reader) {
    Transforms transforms;
    EXPECT_TRUE(eventually([&] {
      takeAll<tf2_msgs_msg_dds__TFMessage_>(reader, [&](const auto& message) {
        for (std::uint32_t i = 0; i < message.transforms._length; ++i) addTransform(message.transforms._buffer[i], transforms);
      });
      return !transforms.empty();
    }));
    return transforms;
  }

  RosNode& node_;
  dds_entity_t joints = 0, moving = 0, clock = 0;
};

TEST(PublishedCell, SaysJointsFramesAndTime) {
  const CraneCell cell;
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), others = PrivateDomain::node();
  HeardCell heard(*others);
  PublishedCell published(*own, cell.document, cell.crane, std::nullopt, true);
  ASSERT_TRUE(published.open());
  ASSERT_TRUE(eventually([&] {
    return others->writersOf(heard.joints) == 1 && others->writersOf(heard.moving) == 1 && others->writersOf(heard.clock) == 1;
  }));
  ASSERT_TRUE(published.publishAt(1.5, {cell.crane->X_WE, {0.7, 0.25}}));

  std::vector<std::string> names;
  std::vector<double> positions;
  std::vector<std::int64_t> stamps;
  EXPECT_TRUE(eventually([&] {
    takeAll<sensor_msgs_msg_dds__JointState_>(heard.joints, [&](const auto& state) {
      names.assign(state.name._buffer, state.name._buffer + state.name._length);
      positions.assign(state.position._buffer, state.position._buffer + state.position._length);
      stamps.push_back(nanosecondsOf(state.header.stamp));
    });
    return !names.empty();
  }));
  EXPECT_EQ(names, (std::vector<std::string>{"turn", "reach"})) << "the joint that follows is not set by anybody";
  EXPECT_EQ(positions, (std::vector<double>{0.7, 0.25}));
  EXPECT_TRUE(eventually([&] {
    takeAll<rosgraph_msgs_msg_dds__Clock_>(heard.clock, [&](const auto& now) { stamps.push_back(nanosecondsOf(now.clock)); });
    return stamps.size() == 2;
  }));
  EXPECT_EQ(stamps, (std::vector<std::int64_t>(2, 1'500'000'000)));
  EXPECT_EQ(childrenIn(HeardCell::transformsFrom(heard.moving)), (std::set<std::string>{"arm", "slide", "tool"}));

  const auto result = published.result();
  EXPECT_EQ(result["robot"], "crane");
  EXPECT_EQ(result["published"]["/joint_states"], 1);
  EXPECT_EQ(result["published"]["/tf_static"], 0);
  EXPECT_EQ(result["readers"]["/joint_states"], 1);
  EXPECT_EQ(result["readers"]["/tf_static"], 0);
  EXPECT_FALSE(result["published"].contains("/stylus/pose"));
  EXPECT_FALSE(result["published"].contains("/moved/pose")) << "nothing moves it";
}

TEST(PublishedCell, ALaterReaderGetsDescriptionFramesAndScene) {
  const CraneCell cell;
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), others = PrivateDomain::node();
  PublishedCell published(*own, cell.document, cell.crane, std::nullopt, true);
  ASSERT_TRUE(published.open());
  ASSERT_TRUE(published.publishLatched("<robot/>"));
  ASSERT_TRUE(published.publishAt(0.0, {cell.crane->X_WE, {0.7, 0.25}}));
  HeardCell late(*others);
  const dds_entity_t description = late.open("/robot_description", std_msgs_msg_dds__String__desc, RosQuality::kLatched);
  const dds_entity_t fixed = late.open("/tf_static", tf2_msgs_msg_dds__TFMessage__desc, RosQuality::kLatched);
  const dds_entity_t scene = late.open("/planning_scene", moveit_msgs_msg_dds__PlanningScene__desc, RosQuality::kLatched);

  std::string text;
  EXPECT_TRUE(eventually([&] {
    takeAll<std_msgs_msg_dds__String_>(description, [&](const auto& message) { text = message.data; });
    return !text.empty();
  }));
  EXPECT_EQ(text, "<robot/>");
  Transforms all = HeardCell::transformsFrom(fixed);
  EXPECT_EQ(childrenIn(all), (std::set<std::string>{"base", "plate"}));
  EXPECT_EQ(all.at("base").first, "world");
  ASSERT_TRUE(eventually([&] { return published.result()["readers"]["/tf"] == 1; }));
  ASSERT_TRUE(published.publishAt(1.0, {cell.crane->X_WE, {0.7, 0.25}}));
  all.merge(HeardCell::transformsFrom(late.moving));
  expectSamePose(composed(all, "tool"), cell.crane->X_WE * toolOfCrane(0.7, 0.25), "tool in the world");

  std::vector<std::string> objects;
  std::size_t triangles = 0;
  double x = 0.0;
  bool is_diff = false;
  EXPECT_TRUE(eventually([&] {
    takeAll<moveit_msgs_msg_dds__PlanningScene_>(scene, [&](const auto& message) {
      is_diff = message.is_diff;
      for (std::uint32_t i = 0; i < message.world.collision_objects._length; ++i) {
        const auto& object = message.world.collision_objects._buffer[i];
        objects.emplace_back(object.id);
        x = object.pose.position.x;
        triangles = object.meshes._length == 1 ? object.meshes._buffer[0].triangles._length : 0;
      }
    });
    return !objects.empty();
  }));
  EXPECT_EQ(objects, std::vector<std::string>{"wall"}) << "the robot is in its description";
  EXPECT_EQ(triangles, 12u);
  EXPECT_EQ(x, 5.0);
  EXPECT_TRUE(is_diff);
}

TEST(PublishedCell, ABaseThatMoves) {
  const CraneCell cell;
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), others = PrivateDomain::node();
  HeardCell heard(*others);
  PublishedCell published(*own, cell.document, cell.crane, std::nullopt, false);
  published.letBaseMove();
  ASSERT_TRUE(published.open());
  ASSERT_TRUE(published.publishLatched("<robot/>"));
  ASSERT_TRUE(eventually([&] { return others->writersOf(heard.moving) == 1; }));
  const Pose X_WB{{-1.0, 4.0, 0.5}, glm::angleAxis(0.3, dvec3(0.0, 1.0, 0.0))};
  ASSERT_TRUE(published.publishAt(0.0, {X_WB, {0.0, 0.0}}));
  const Transforms moving = HeardCell::transformsFrom(heard.moving);
  EXPECT_EQ(childrenIn(moving), (std::set<std::string>{"arm", "base", "slide", "tool"}));
  expectSamePose(moving.at("base").second, X_WB, "base");
  const dds_entity_t fixed = heard.open("/tf_static", tf2_msgs_msg_dds__TFMessage__desc, RosQuality::kLatched);
  EXPECT_EQ(childrenIn(HeardCell::transformsFrom(fixed)), (std::set<std::string>{"plate"}));
  EXPECT_FALSE(published.result()["published"].contains("/clock")) << "the time of day";
}

}  // namespace
}  // namespace hapticell::bridge
