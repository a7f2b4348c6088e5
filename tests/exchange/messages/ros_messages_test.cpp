// SPDX-License-Identifier: Apache-2.0
#include "exchange/messages/ros_messages.h"

#include <gtest/gtest.h>

#include "exchange/messages/cdr.h"

namespace hapticell::exchange {
namespace {

/// Written by hand after the CDR rules: header, stamp, "w", padding to 8, one name, one position.
TEST(RosMessages, JointStateHasTheBytesOfCdr) {
  const RosJointState message{{2'000'000'003, "w"}, {"A1"}, {1.5}, {}, {}};
  const char expected[] =
      "\x00\x01\x00\x00"                  // Plain CDR, low byte first.
      "\x02\x00\x00\x00\x03\x00\x00\x00"  // 2 s, 3 ns.
      "\x02\x00\x00\x00w\x00\x00\x00"     // "w" and two bytes of padding.
      "\x01\x00\x00\x00\x03\x00\x00\x00"  // One name of three bytes.
      "A1\x00\x00"                        // And one of padding.
      "\x01\x00\x00\x00"                  // One position; at 32 of the body.
      "\x00\x00\x00\x00\x00\x00\xf8\x3f"
      "\x00\x00\x00\x00\x00\x00\x00\x00";
  EXPECT_EQ(toCdr(message), std::string(expected, sizeof expected - 1));
}

TEST(RosMessages, BothByteOrdersAreRead) {
  CdrReader big(std::string_view("\x00\x00\x00\x00\x00\x00\x00\x07", 8));
  EXPECT_EQ(big.uint32(), 7u);
  EXPECT_TRUE(big.isGood());
  CdrReader other(std::string_view("\x00\x03\x00\x00\x00\x00\x00\x07", 8));
  EXPECT_FALSE(other.isGood());
}

TEST(RosMessages, EveryTypeComesBack) {
  const RosHeader header{1'234'567'890'123, "world"};
  const Pose X{{1.0, -2.0, 3.5}, {0.5, 0.5, -0.5, 0.5}};
  const auto joints = jointStateFromCdr(toCdr(RosJointState{header, {"a", "bc"}, {1, 2}, {3, 4}, {5, 6}}));
  ASSERT_TRUE(joints);
  EXPECT_EQ(joints->header, header);
  EXPECT_EQ(joints->effort, (std::vector<double>{5, 6}));
  const auto pose = poseStampedFromCdr(toCdr(RosPoseStamped{header, X}));
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->pose.q, X.q);
  const auto wrench = wrenchStampedFromCdr(toCdr(RosWrenchStamped{header, {1, 2, 3}, {4, 5, 6}}));
  ASSERT_TRUE(wrench);
  EXPECT_EQ(wrench->torque, dvec3(4, 5, 6));
  const auto transforms = transformsFromCdr(toCdr(RosTransforms{{{header, "tool", X}, {header, "b", X}}}));
  ASSERT_TRUE(transforms);
  EXPECT_EQ(transforms->transforms.at(1).child_frame_id, "b");
  const auto joy = joyFromCdr(toCdr(RosJoy{header, {0.5f}, {1, 0}}));
  ASSERT_TRUE(joy);
  EXPECT_EQ(joy->buttons, (std::vector<std::int32_t>{1, 0}));
}

TEST(RosMessages, CutMessagesAreRefused) {
  const std::string bytes = toCdr(RosJointState{{1, "world"}, {"a", "bc"}, {1, 2}, {3, 4}, {5, 6}});
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(jointStateFromCdr(bytes.substr(0, size)));
}

TEST(RosMessages, DefinitionHoldsWhatItUses) {
  const std::string text = rosDefinition("geometry_msgs/msg/PoseStamped");
  for (const char* used : {"MSG: std_msgs/Header", "MSG: geometry_msgs/Pose", "MSG: geometry_msgs/Quaternion",
                           "MSG: builtin_interfaces/Time"})
    EXPECT_NE(text.find(used), std::string::npos) << used;
}

}  // namespace
}  // namespace hapticell::exchange
