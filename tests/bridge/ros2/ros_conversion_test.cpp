// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/ros_conversion.h"

#include <gtest/gtest.h>

#include "bridge/ros2/cell_publisher.h"
#include "bridge/ros2/ros_listener.h"
#include "bridge/ros2/ros_node.h"
#include "bridge/ros2/type_hashes.h"

namespace hapticell::bridge {
namespace {

trajectory::Trajectory sampleMotion() {
  trajectory::Trajectory motion;
  motion.joint_names = {"A1", "A2"};
  for (int i = 0; i < 5; ++i) {
    const double joints[] = {0.1 * i * i, -0.2 * i};
    EXPECT_TRUE(motion.addFrame({2.0 + 0.5 * i, {}}, joints));
  }
  return motion;
}

TEST(RosConversion, TopicsAreMangledAsRosDoes) {
  EXPECT_EQ(mangledTopic("/tf_static"), "rt/tf_static");
  EXPECT_EQ(mangledTopic("tf"), "rt/tf");
}

TEST(RosConversion, MotionComesBackFromItsJointTrajectory) {
  const trajectory::Trajectory motion = sampleMotion();
  const JointTrajectoryMessage message(motion);
  const auto& points = message.message()->points;
  ASSERT_EQ(points._length, 5u);
  // Central difference of 0.1 i^2 in steps of 0.5 s: (0.4 - 0) / 1 at i = 1; at rest at both ends.
  EXPECT_NEAR(points._buffer[1].velocities._buffer[0], 0.4, 1e-12);
  EXPECT_EQ(points._buffer[0].velocities._buffer[0], 0.0);
  EXPECT_EQ(points._buffer[3].time_from_start.sec, 1);
  EXPECT_EQ(points._buffer[3].time_from_start.nanosec, 500'000'000u);
  const auto back = motionOf(*message.message());
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(back->joint_names, motion.joint_names);
  EXPECT_FALSE(back->has_poses);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(back->joints(i)[0], motion.joints(i)[0]);
    EXPECT_NEAR((*back)[i].t, motion[i].t - 2.0, 1e-9);
  }
}

TEST(RosConversion, OddTrajectoriesAreRefused) {
  trajectory_msgs_msg_dds__JointTrajectory_ empty{};
  EXPECT_FALSE(motionOf(empty));
  const trajectory::Trajectory motion = sampleMotion();
  const JointTrajectoryMessage message(motion);
  auto bent = *message.message();
  bent.points._buffer[2].time_from_start = {0, 0};
  EXPECT_FALSE(motionOf(bent));
  const JointTrajectoryMessage other(motion);
  bent = *other.message();
  bent.points._buffer[2].positions._buffer[0] = std::nan("");
  EXPECT_FALSE(motionOf(bent));
  bent.points._buffer[2].positions._length = 1;
  EXPECT_FALSE(motionOf(bent));
}

TEST(RosConversion, PlanningSceneHasTheTriangles) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}};
  PlanningSceneMessage scene;
  scene.addObject("plate", Pose::translation({1, 2, 3}), mesh);
  const auto* const message = scene.message(5'000'000'001, "arm", nullptr);
  ASSERT_EQ(message->world.collision_objects._length, 1u);
  const auto& object = message->world.collision_objects._buffer[0];
  EXPECT_STREQ(object.id, "plate");
  EXPECT_EQ(object.pose.position.y, 2.0);
  EXPECT_EQ(object.header.stamp.sec, 5);
  EXPECT_EQ(nanosecondsOf(object.header.stamp), 5'000'000'001);
  EXPECT_EQ(object.meshes._buffer[0].vertices._buffer[2].z, 0.5);
  EXPECT_EQ(object.meshes._buffer[0].triangles._buffer[0].vertex_indices[2], 2u);
}

TEST(RosConversion, QuaternionIsInTheOrderOfRos) {
  const auto pose = rosPose({{1, 2, 3}, dquat(0.5, 0.1, 0.2, 0.3)});
  EXPECT_EQ(pose.orientation.w, 0.5);
  EXPECT_EQ(pose.orientation.z, 0.3);
  JointStateMessage joints({"a"});
  EXPECT_EQ(joints.at(1, {0.5})->position._buffer[0], 0.5);
}

TEST(RosListener, NothingToListenForIsAnError) {
  const std::atomic<bool> stop{true};
  ListenOptions options;
  options.node = {77, true};
  EXPECT_FALSE(listen(options, stop));
}

TEST(CellPublisher, MissingCellIsAnError) {
  const std::atomic<bool> stop{true};
  PublishOptions options;
  options.workcell = "/nowhere/cell.hcell";
  EXPECT_FALSE(publishCell(options, stop));
}

// As `ros2 topic info --verbose` of ROS 2 Jazzy prints them.
TEST(TypeHashes, AreThoseThatRosPublishes) {
  const std::pair<const char*, const char*> published[] = {
      {"std_msgs::msg::dds_::String_", "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
      {"rosgraph_msgs::msg::dds_::Clock_", "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"},
      {"sensor_msgs::msg::dds_::JointState_", "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
      {"tf2_msgs::msg::dds_::TFMessage_", "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
      {"geometry_msgs::msg::dds_::PoseStamped_", "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
      {"geometry_msgs::msg::dds_::WrenchStamped_", "8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77"},
      {"trajectory_msgs::msg::dds_::JointTrajectory_",
       "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e"},
      {"visualization_msgs::msg::dds_::MarkerArray_",
       "86cb8800b6fb05b5eff1abd7a56f62a5641d3ae9a1c29e78e67e704f1d067dcf"}};
  for (const auto& [type, hash] : published) EXPECT_EQ(typeHash(type), "RIHS01_" + std::string(hash)) << type;
  for (const char* other : {"", "std_msgs::msg::dds_::String", "std_msgs/msg/String", "std_msgs::msg::dds_::Header_"})
    EXPECT_TRUE(typeHash(other).empty()) << other;
}

}  // namespace
}  // namespace hapticell::bridge
