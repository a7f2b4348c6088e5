// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <ros2_messages.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bridge/ros2/trajectory_action.h"
#include "tests/bridge/ros2/played_service.h"

namespace hapticell::bridge {

using GoalId = unique_identifier_msgs_msg_dds__UUID_;

/// The server of a FollowJointTrajectory action, which says what a test tells it to. The node must outlive it.
class PlayedController {
 public:
  using SendGoal = PlayedService<control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request_,
                                 control_msgs_action_dds__FollowJointTrajectory_SendGoal_Response_,
                                 hapticell_numbered_SendGoalRequest, hapticell_numbered_SendGoalResponse>;
  using GetResult = PlayedService<control_msgs_action_dds__FollowJointTrajectory_GetResult_Request_,
                                  control_msgs_action_dds__FollowJointTrajectory_GetResult_Response_,
                                  hapticell_numbered_GetResultRequest, hapticell_numbered_GetResultResponse>;
  /// Copies of what came.
  struct Goal {
    GoalId id{};
    SendGoal::Asker asker;
    std::vector<std::string> joints;
    std::vector<std::vector<double>> points;  ///< Time (s, whole and nanoseconds as two numbers), positions, velocities.
  };
  struct Cancellation {
    action_msgs_msg_dds__GoalInfo_ goal{};
    PlayedCancelGoal::Asker asker;
  };
  struct Question {
    GoalId id{};
    GetResult::Asker asker;
  };

  PlayedController(RosNode& node, const std::string& action, RpcForm form)
      : node_(node),
        sending_(node, action + "/_action/send_goal",
                 {control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request__desc,
                  control_msgs_action_dds__FollowJointTrajectory_SendGoal_Response__desc,
                  hapticell_numbered_SendGoalRequest_desc, hapticell_numbered_SendGoalResponse_desc},
                 form),
        resulting_(node, action + "/_action/get_result",
                   {control_msgs_action_dds__FollowJointTrajectory_GetResult_Request__desc,
                    control_msgs_action_dds__FollowJointTrajectory_GetResult_Response__desc,
                    hapticell_numbered_GetResultRequest_desc, hapticell_numbered_GetResultResponse_desc},
                   form),
        canceling_(node, action + "/_action/cancel_goal", cancelGoalTypes(), form) {
    const auto status =
        node.advertise(action + "/_action/status", action_msgs_msg_dds__GoalStatusArray__desc, RosQuality::kLatched);
    const auto feedback = node.advertise(
        action + "/_action/feedback", control_msgs_action_dds__FollowJointTrajectory_FeedbackMessage__desc, RosQuality::kDefault);
    EXPECT_TRUE(status && feedback);
    status_ = status.value_or(0);
    feedback_ = feedback.value_or(0);
  }

  /// What came so far, and now.
  void take() {
    sending_.takeRequests([this](const auto& request, const SendGoal::Asker& asker) {
      goals_.push_back({request.goal_id, asker, {}, pointsOf(request.goal.trajectory)});
      const auto& names = request.goal.trajectory.joint_names;
      goals_.back().joints.assign(names._buffer, names._buffer + names._length);
    });
    canceling_.takeRequests([this](const auto& request, const PlayedCancelGoal::Asker& asker) {
      cancellations_.push_back({request.goal_info, asker});
    });
    resulting_.takeRequests(
        [this](const auto& request, const GetResult::Asker& asker) { questions_.push_back({request.goal_id, asker}); });
  }
  const std::vector<Goal>& goals() const { return goals_; }
  const std::vector<Cancellation>& cancellations() const { return cancellations_; }
  const std::vector<Question>& questions() const { return questions_; }

  void answerGoal(const SendGoal::Asker& asker, bool accepted) { sending_.answer(asker, {accepted, {1, 2}}); }
  void answerCancellation(const PlayedCancelGoal::Asker& asker) { canceling_.answer(asker, {}); }
  void answerQuestion(const GetResult::Asker& asker, GoalState state, int code, std::string text) {
    resulting_.answer(asker, {static_cast<std::int8_t>(state), {code, text.data()}});
  }
  void publishStates(const std::vector<std::pair<GoalId, GoalState>>& states) {
    std::vector<action_msgs_msg_dds__GoalStatus_> list;
    for (const auto& [id, state] : states) list.push_back({{id, {3, 4}}, static_cast<std::int8_t>(state)});
    action_msgs_msg_dds__GoalStatusArray_ message{};
    message.status_list._buffer = list.data();
    message.status_list._length = message.status_list._maximum = static_cast<std::uint32_t>(list.size());
    EXPECT_TRUE(node_.write(status_, &message));
  }
  void publishFeedback(const GoalId& id) {
    std::string no_frame;
    control_msgs_action_dds__FollowJointTrajectory_FeedbackMessage_ message{};
    message.goal_id = id;
    message.feedback.header.frame_id = no_frame.data();
    EXPECT_TRUE(node_.write(feedback_, &message));
  }

  /// Every number of a trajectory.
  static std::vector<std::vector<double>> pointsOf(const trajectory_msgs_msg_dds__JointTrajectory_& trajectory) {
    std::vector<std::vector<double>> points;
    for (std::uint32_t i = 0; i < trajectory.points._length; ++i) {
      const auto& point = trajectory.points._buffer[i];
      std::vector<double>& numbers = points.emplace_back();
      numbers = {static_cast<double>(point.time_from_start.sec), static_cast<double>(point.time_from_start.nanosec)};
      for (const auto* list : {&point.positions, &point.velocities})
        numbers.insert(numbers.end(), list->_buffer, list->_buffer + list->_length);
    }
    return points;
  }

 private:
  RosNode& node_;
  SendGoal sending_;
  GetResult resulting_;
  PlayedCancelGoal canceling_;
  dds_entity_t status_ = 0, feedback_ = 0;
  std::vector<Goal> goals_;
  std::vector<Cancellation> cancellations_;
  std::vector<Question> questions_;
};

}  // namespace hapticell::bridge
