// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/trajectory_action.h"

#include <algorithm>
#include <iterator>
#include <random>

namespace hapticell::bridge {

namespace {

bool isSame(const unique_identifier_msgs_msg_dds__UUID_& a, const unique_identifier_msgs_msg_dds__UUID_& b) {
  return std::equal(std::begin(a.uuid), std::end(a.uuid), std::begin(b.uuid));
}

/// Version 4 of RFC 4122.
unique_identifier_msgs_msg_dds__UUID_ randomUuid() {
  std::random_device source;
  unique_identifier_msgs_msg_dds__UUID_ id{};
  for (std::uint8_t& byte : id.uuid) byte = static_cast<std::uint8_t>(source() & 0xFF);
  id.uuid[6] = static_cast<std::uint8_t>((id.uuid[6] & 0x0F) | 0x40);
  id.uuid[8] = static_cast<std::uint8_t>((id.uuid[8] & 0x3F) | 0x80);
  return id;
}

}  // namespace

const char* toString(GoalState state) {
  static constexpr const char* kNames[] = {"unknown", "accepted", "executing", "canceling", "succeeded", "canceled", "aborted"};
  const auto number = static_cast<std::size_t>(state);
  return number < std::size(kNames) ? kNames[number] : kNames[0];
}

bool isOver(GoalState state) {
  return state == GoalState::kSucceeded || state == GoalState::kCanceled || state == GoalState::kAborted;
}

TrajectoryAction::TrajectoryAction(RosNode& node) : node_(node), goal_(randomUuid()) {}

Expected<std::optional<RpcForm>> TrajectoryAction::formOf(RosNode& node, const std::string& action) {
  constexpr std::uint16_t kFastDds = 0x010F, kCycloneDds = 0x0110;
  const std::string topic = "rq" + action + "/_action/send_goalRequest";
  for (const RosEndpoint& reader : node.othersReaders()) {
    if (reader.topic != topic) continue;
    if (reader.type != control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request__desc.m_typename)
      return makeError({.file = action,
                        .found = Text("an action of the type %1", reader.type),
                        .expected = "control_msgs/action/FollowJointTrajectory"});
    if (reader.vendor == kFastDds) return RpcForm::kPlain;
    if (reader.vendor == kCycloneDds) return RpcForm::kNumbered;
    return makeError({.file = action,
                      .found = Text("a server with the DDS of the maker %1", static_cast<std::int64_t>(reader.vendor)),
                      .expected = "Fast DDS or Cyclone DDS",
                      .fix = "Name the form of its services by --services."});
  }
  return std::nullopt;
}

Expected<std::unique_ptr<TrajectoryAction>> TrajectoryAction::open(RosNode& node, const std::string& action, RpcForm form) {
  std::unique_ptr<TrajectoryAction> client(new TrajectoryAction(node));
  const std::string below = action + "/_action/";
  HAPTICELL_TRY(client->sending_.open(node, below + "send_goal",
                                      {control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request__desc,
                                       control_msgs_action_dds__FollowJointTrajectory_SendGoal_Response__desc,
                                       hapticell_numbered_SendGoalRequest_desc, hapticell_numbered_SendGoalResponse_desc},
                                      form));
  HAPTICELL_TRY(client->resulting_.open(node, below + "get_result",
                                        {control_msgs_action_dds__FollowJointTrajectory_GetResult_Request__desc,
                                         control_msgs_action_dds__FollowJointTrajectory_GetResult_Response__desc,
                                         hapticell_numbered_GetResultRequest_desc, hapticell_numbered_GetResultResponse_desc},
                                        form));
  HAPTICELL_TRY(client->canceling_.open(node, below + "cancel_goal",
                                        {action_msgs_srv_dds__CancelGoal_Request__desc, action_msgs_srv_dds__CancelGoal_Response__desc,
                                         hapticell_numbered_CancelGoalRequest_desc, hapticell_numbered_CancelGoalResponse_desc},
                                        form));
  const auto status = node.subscribe(below + "status", action_msgs_msg_dds__GoalStatusArray__desc, RosQuality::kLatched);
  HAPTICELL_TRY(status);
  const auto feedback = node.subscribe(
      below + "feedback", control_msgs_action_dds__FollowJointTrajectory_FeedbackMessage__desc, RosQuality::kDefault);
  HAPTICELL_TRY(feedback);
  client->status_ = *status;
  client->feedback_ = *feedback;
  return client;
}

bool TrajectoryAction::isConnected() const {
  return sending_.isConnected(node_) && resulting_.isConnected(node_) && canceling_.isConnected(node_) &&
         node_.writersOf(status_) > 0 && node_.writersOf(feedback_) > 0;
}

Expected<void> TrajectoryAction::send(const trajectory_msgs_msg_dds__JointTrajectory_& motion) {
  std::string no_frame;
  control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request_ request{};
  request.goal_id = goal_;
  request.goal.trajectory = motion;
  request.goal.multi_dof_trajectory.header.frame_id = no_frame.data();
  return sending_.ask(node_, request);
}

Expected<void> TrajectoryAction::cancel() {
  action_msgs_srv_dds__CancelGoal_Request_ request{};
  request.goal_info.goal_id = goal_;  // Stamp 0 with a number: this goal alone.
  return canceling_.ask(node_, request);
}

Expected<void> TrajectoryAction::take() {
  takeAll<action_msgs_msg_dds__GoalStatusArray_>(status_, [this](const auto& statuses) {
    for (std::uint32_t i = 0; i < statuses.status_list._length; ++i) {
      const auto& status = statuses.status_list._buffer[i];
      if (isSame(status.goal_info.goal_id, goal_) && !isOver(state_)) state_ = static_cast<GoalState>(status.status);
    }
  });
  takeAll<control_msgs_action_dds__FollowJointTrajectory_FeedbackMessage_>(feedback_, [this](const auto& message) {
    if (isSame(message.goal_id, goal_)) ++feedbacks_;
  });
  sending_.takeResponses([this](const auto& response) {
    if (!accepted_ || response.accepted) accepted_ = response.accepted;
  });
  canceling_.takeResponses([](const auto&) {});  // The state says what became of it.
  if (isOver(state_) && !asked_) {
    asked_ = true;
    HAPTICELL_TRY(resulting_.ask(node_, {goal_}));
  }
  resulting_.takeResponses([this](const auto& response) {
    const auto state = static_cast<GoalState>(response.status);
    if (asked_ && state == state_)
      result_ = Result{state, response.result.error_code, response.result.error_string ? response.result.error_string : ""};
  });
  return {};
}

}  // namespace hapticell::bridge
