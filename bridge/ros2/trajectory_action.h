// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros2_messages.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bridge/ros2/rpc_client.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// States of a goal as action_msgs/msg/GoalStatus numbers them.
enum class GoalState : std::int8_t {
  kUnknown = 0,
  kAccepted = 1,
  kExecuting = 2,
  kCanceling = 3,
  kSucceeded = 4,
  kCanceled = 5,
  kAborted = 6,
};
/// "unknown", "accepted", "executing", "canceling", "succeeded", "canceled", "aborted".
const char* toString(GoalState state);
/// Succeeded, canceled or aborted: the controller no longer follows the goal.
bool isOver(GoalState state);

/// One goal of one FollowJointTrajectory action (control_msgs), as its client: three services and two topics below the
/// action's name. The state is that which the server publishes with the goal's own number, so that goals of other clients
/// are not taken for it. One thread. The node must outlive it.
class TrajectoryAction {
 public:
  /// What the server said about the end.
  struct Result {
    GoalState state = GoalState::kUnknown;
    std::int32_t error_code = 0;  ///< 0 successful, -1 invalid goal ... -5 goal tolerance violated.
    std::string error;
  };

  /// The form of a found server's services, by the maker of its DDS. Empty: no server of this action was found yet.
  /// Error: a maker whose form is not known.
  static Expected<std::optional<RpcForm>> formOf(RosNode& node, const std::string& action);

  /// `action`: "/arm_controller/follow_joint_trajectory". Error: what DDS says.
  static Expected<std::unique_ptr<TrajectoryAction>> open(RosNode& node, const std::string& action, RpcForm form);

  /// True once the server and this client found each other on all services and topics.
  bool isConnected() const;
  /// Sends the goal. Errors, here and below: what DDS says.
  Expected<void> send(const trajectory_msgs_msg_dds__JointTrajectory_& motion);
  /// Asks the server to stop; may be repeated.
  Expected<void> cancel();
  /// Takes what came since the last call. Once the goal is over, it asks for the result.
  Expected<void> take();

  GoalState state() const { return state_; }
  /// What a reply said about the goal, if one came. A plain reply may be one to another client.
  std::optional<bool> accepted() const { return accepted_; }
  /// Set once the server gave the result with the same state.
  const std::optional<Result>& result() const { return result_; }
  std::uint64_t feedbacks() const { return feedbacks_; }

 private:
  explicit TrajectoryAction(RosNode& node);

  RosNode& node_;
  unique_identifier_msgs_msg_dds__UUID_ goal_{};
  RpcClient<control_msgs_action_dds__FollowJointTrajectory_SendGoal_Request_,
            control_msgs_action_dds__FollowJointTrajectory_SendGoal_Response_, hapticell_numbered_SendGoalRequest,
            hapticell_numbered_SendGoalResponse>
      sending_;
  RpcClient<control_msgs_action_dds__FollowJointTrajectory_GetResult_Request_,
            control_msgs_action_dds__FollowJointTrajectory_GetResult_Response_, hapticell_numbered_GetResultRequest,
            hapticell_numbered_GetResultResponse>
      resulting_;
  RpcClient<action_msgs_srv_dds__CancelGoal_Request_, action_msgs_srv_dds__CancelGoal_Response_,
            hapticell_numbered_CancelGoalRequest, hapticell_numbered_CancelGoalResponse>
      canceling_;
  dds_entity_t status_ = 0, feedback_ = 0;
  GoalState state_ = GoalState::kUnknown;
  std::optional<bool> accepted_;
  std::optional<Result> result_;
  std::uint64_t feedbacks_ = 0;
  bool asked_ = false;
};

}  // namespace hapticell::bridge
