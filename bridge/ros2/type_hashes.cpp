// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/type_hashes.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hapticell::bridge {

namespace {

// Written by tools/ros2_type_hashes. They change only with the public definitions.
constexpr std::pair<std::string_view, std::string_view> kTypeHashes[] = {
    {"action_msgs::msg::dds_::GoalStatusArray_", "RIHS01_6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e"},
    {"action_msgs::srv::dds_::CancelGoal_Request_", "RIHS01_573d8b0a534451d7bc2ac8c5ffde8ac14b8593b7001175d0cd6516dcbeb8689a"},
    {"action_msgs::srv::dds_::CancelGoal_Response_", "RIHS01_573d8b0a534451d7bc2ac8c5ffde8ac14b8593b7001175d0cd6516dcbeb8689a"},
    {"control_msgs::action::dds_::FollowJointTrajectory_FeedbackMessage_", "RIHS01_80398fcb9674a79081a9906e2ccf0c804dd7cb15e22e362e606ee87186beab71"},
    {"control_msgs::action::dds_::FollowJointTrajectory_GetResult_Request_", "RIHS01_e3ceb38e3e1867c8dc0f46014df26e90eb93422f27e9e97f936e07f94be4bc8b"},
    {"control_msgs::action::dds_::FollowJointTrajectory_GetResult_Response_", "RIHS01_e3ceb38e3e1867c8dc0f46014df26e90eb93422f27e9e97f936e07f94be4bc8b"},
    {"control_msgs::action::dds_::FollowJointTrajectory_SendGoal_Request_", "RIHS01_b13789dddc325a7a962825c45e28c77d37237ec129dd0c34dc5994562938c57f"},
    {"control_msgs::action::dds_::FollowJointTrajectory_SendGoal_Response_", "RIHS01_b13789dddc325a7a962825c45e28c77d37237ec129dd0c34dc5994562938c57f"},
    {"geometry_msgs::msg::dds_::PoseStamped_", "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
    {"geometry_msgs::msg::dds_::WrenchStamped_", "RIHS01_8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77"},
    {"moveit_msgs::msg::dds_::CollisionObject_", "RIHS01_74b0acd6d56be032bf4f764b2c2633f50588b5fb2bd71e97206c59052747cf7e"},
    {"moveit_msgs::msg::dds_::PlanningScene_", "RIHS01_0f58540ad5eab4b9ea827d53b763c793d8cabd202b3b301fcee25afa4ce1bd80"},
    {"rosgraph_msgs::msg::dds_::Clock_", "RIHS01_692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"},
    {"sensor_msgs::msg::dds_::JointState_", "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
    {"std_msgs::msg::dds_::String_", "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
    {"tf2_msgs::msg::dds_::TFMessage_", "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
    {"trajectory_msgs::msg::dds_::JointTrajectory_", "RIHS01_179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e"},
    {"visualization_msgs::msg::dds_::MarkerArray_", "RIHS01_86cb8800b6fb05b5eff1abd7a56f62a5641d3ae9a1c29e78e67e704f1d067dcf"},
};

}  // namespace

std::string_view typeHash(std::string_view dds_type) {
  const auto* const found = std::ranges::find(kTypeHashes, dds_type, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kTypeHashes) ? std::string_view() : found->second;
}

}  // namespace hapticell::bridge
