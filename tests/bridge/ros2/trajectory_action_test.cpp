// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/trajectory_action.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/ros2/ros_conversion.h"
#include "tests/bridge/ros2/played_controller.h"
#include "tests/bridge/ros2/private_domain.h"

namespace hapticell::bridge {
namespace {

constexpr const char* kAction = "/arm_controller/follow_joint_trajectory";

trajectory::Trajectory swingOfTwoJoints() {
  trajectory::Trajectory motion;
  motion.joint_names = {"A1", "A2"};
  motion.has_poses = false;
  for (int i = 0; i < 4; ++i) motion.addFrame({0.3 * i, {}}, std::vector<double>{0.1 * i, -0.7 / (i + 1)});
  return motion;
}

std::vector<std::uint8_t> bytesOf(const GoalId& id) {
  return {std::begin(id.uuid), std::end(id.uuid)};
}

/// A client and its server, played step by step in one thread.
class TrajectoryActionTest : public ::testing::TestWithParam<RpcForm> {
 protected:
  std::unique_ptr<TrajectoryAction> connectedAction() {
    auto opened = TrajectoryAction::open(*own_, kAction, GetParam());
    if (!opened) throw std::runtime_error(opened.error().message());
    EXPECT_TRUE(eventually([&] { return (*opened)->isConnected(); }));
    return std::move(*opened);
  }
  /// Both sides take what came until `is_done`.
  template <typename IsDone>
  bool playUntil(TrajectoryAction& action, const IsDone& is_done) {
    return eventually([&] {
      controller_.take();
      EXPECT_TRUE(action.take());
      return is_done();
    });
  }
  /// The goal arrived, is accepted and executed.
  GoalId started(TrajectoryAction& action) {
    EXPECT_TRUE(action.send(*motion_.message()));
    EXPECT_TRUE(playUntil(action, [&] { return controller_.goals().size() == 1; }));
    const auto goal = controller_.goals().at(0);
    controller_.answerGoal(goal.asker, true);
    controller_.publishStates({{goal.id, GoalState::kExecuting}});
    EXPECT_TRUE(playUntil(action, [&] { return action.accepted() && action.state() == GoalState::kExecuting; }));
    return goal.id;
  }

  PrivateDomain domain_;
  std::unique_ptr<RosNode> own_ = PrivateDomain::node(), robots_ = PrivateDomain::node();
  PlayedController controller_{*robots_, kAction, GetParam()};
  JointTrajectoryMessage motion_{swingOfTwoJoints()};
};

TEST_P(TrajectoryActionTest, FollowsItsGoalToTheResult) {
  const auto action = connectedAction();
  EXPECT_FALSE(action->accepted());
  EXPECT_EQ(action->state(), GoalState::kUnknown);
  ASSERT_TRUE(action->send(*motion_.message()));
  ASSERT_TRUE(playUntil(*action, [&] { return !controller_.goals().empty(); }));
  const auto goal = controller_.goals()[0];
  EXPECT_EQ(goal.joints, (std::vector<std::string>{"A1", "A2"}));
  EXPECT_EQ(goal.points, PlayedController::pointsOf(*motion_.message()));
  EXPECT_EQ(goal.id.uuid[6] >> 4, 4) << "a random number of RFC 4122";
  EXPECT_EQ(goal.id.uuid[8] >> 6, 2);

  GoalId other = goal.id;
  other.uuid[15] ^= 1;
  controller_.answerGoal(goal.asker, true);
  controller_.publishStates({{other, GoalState::kAborted}, {goal.id, GoalState::kAccepted}});
  EXPECT_TRUE(playUntil(*action, [&] { return action->accepted() && action->state() == GoalState::kAccepted; }));
  EXPECT_EQ(action->accepted(), std::optional(true));
  controller_.publishStates({{goal.id, GoalState::kExecuting}, {other, GoalState::kAborted}});
  EXPECT_TRUE(playUntil(*action, [&] { return action->state() == GoalState::kExecuting; }));
  controller_.publishFeedback(other);
  for (int i = 0; i < 3; ++i) controller_.publishFeedback(goal.id);
  EXPECT_TRUE(playUntil(*action, [&] { return action->feedbacks() >= 3; }));
  EXPECT_TRUE(controller_.questions().empty()) << "there is no result yet";

  controller_.publishStates({{goal.id, GoalState::kSucceeded}});
  EXPECT_TRUE(playUntil(*action, [&] { return !controller_.questions().empty(); }));
  EXPECT_EQ(action->state(), GoalState::kSucceeded);
  EXPECT_FALSE(action->result());
  const auto question = controller_.questions().at(0);
  EXPECT_EQ(bytesOf(question.id), bytesOf(goal.id));
  controller_.answerQuestion(question.asker, GoalState::kAborted, -5, "another goal's");
  controller_.answerQuestion(question.asker, GoalState::kSucceeded, 0, "there");
  EXPECT_TRUE(playUntil(*action, [&] { return action->result().has_value(); }));
  ASSERT_TRUE(action->result());
  EXPECT_EQ(action->result()->state, GoalState::kSucceeded);
  EXPECT_EQ(action->result()->error_code, 0);
  EXPECT_EQ(action->result()->error, "there");
  EXPECT_EQ(action->feedbacks(), 3u) << "those of its own goal";
  EXPECT_EQ(controller_.questions().size(), 1u) << "asked once";
}

TEST_P(TrajectoryActionTest, ARejectionIsSeen) {
  const auto action = connectedAction();
  ASSERT_TRUE(action->send(*motion_.message()));
  ASSERT_TRUE(playUntil(*action, [&] { return !controller_.goals().empty(); }));
  controller_.answerGoal(controller_.goals()[0].asker, false);
  EXPECT_TRUE(playUntil(*action, [&] { return action->accepted().has_value(); }));
  EXPECT_EQ(action->accepted(), std::optional(false));
  EXPECT_EQ(action->state(), GoalState::kUnknown);
  // A plain reply may have been that to another client: a yes counts for more than a no.
  controller_.answerGoal(controller_.goals()[0].asker, true);
  EXPECT_TRUE(playUntil(*action, [&] { return action->accepted() == std::optional(true); }));
}

TEST_P(TrajectoryActionTest, CancelsItsOwnGoalAlone) {
  const auto action = connectedAction();
  const GoalId id = started(*action);
  ASSERT_TRUE(action->cancel());
  ASSERT_TRUE(action->cancel());
  ASSERT_TRUE(playUntil(*action, [&] { return controller_.cancellations().size() == 2; }));
  for (const auto& cancellation : controller_.cancellations()) {
    EXPECT_EQ(bytesOf(cancellation.goal.goal_id), bytesOf(id));
    EXPECT_EQ(nanosecondsOf(cancellation.goal.stamp), 0) << "a stamp would cancel older goals too";
    controller_.answerCancellation(cancellation.asker);
  }
  EXPECT_TRUE(action->take());
  EXPECT_EQ(action->state(), GoalState::kExecuting) << "the reply alone does not say that it rests";
  controller_.publishStates({{id, GoalState::kCanceling}});
  EXPECT_TRUE(playUntil(*action, [&] { return action->state() == GoalState::kCanceling; }));
  controller_.publishStates({{id, GoalState::kCanceled}});
  EXPECT_TRUE(playUntil(*action, [&] { return !controller_.questions().empty(); }));
  controller_.answerQuestion(controller_.questions().at(0).asker, GoalState::kCanceled, 0, "");
  EXPECT_TRUE(playUntil(*action, [&] { return action->result().has_value(); }));
  EXPECT_EQ(action->result()->state, GoalState::kCanceled);
}

TEST_P(TrajectoryActionTest, AGoalThatIsOverStaysSo) {
  const auto action = connectedAction();
  const GoalId id = started(*action);
  controller_.publishStates({{id, GoalState::kAborted}});
  EXPECT_TRUE(playUntil(*action, [&] { return action->state() == GoalState::kAborted; }));
  controller_.publishStates({{id, GoalState::kExecuting}});
  controller_.publishFeedback(id);  // Written later: once it is here, so is the state.
  EXPECT_TRUE(playUntil(*action, [&] { return action->feedbacks() == 1; }));
  EXPECT_TRUE(action->take());
  EXPECT_EQ(action->state(), GoalState::kAborted);
  EXPECT_TRUE(playUntil(*action, [&] { return !controller_.questions().empty(); }));
  controller_.answerQuestion(controller_.questions().at(0).asker, GoalState::kAborted, -4, "A2 left its path");
  EXPECT_TRUE(playUntil(*action, [&] { return action->result().has_value(); }));
  EXPECT_EQ(action->result()->error_code, -4);
  EXPECT_EQ(action->result()->error, "A2 left its path");
}

INSTANTIATE_TEST_SUITE_P(BothForms, TrajectoryActionTest, ::testing::Values(RpcForm::kPlain, RpcForm::kNumbered),
                         [](const auto& form) { return form.param == RpcForm::kPlain ? "Plain" : "Numbered"; });

TEST(TrajectoryAction, TwoClientsHaveGoalsOfTheirOwn) {
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), robots = PrivateDomain::node();
  PlayedController controller(*robots, kAction, RpcForm::kNumbered);
  const JointTrajectoryMessage motion(swingOfTwoJoints());
  std::unique_ptr<TrajectoryAction> clients[2];
  for (auto& client : clients) {
    auto opened = TrajectoryAction::open(*own, kAction, RpcForm::kNumbered);
    ASSERT_TRUE(opened) << opened.error().message();
    client = std::move(*opened);
    ASSERT_TRUE(eventually([&] { return client->isConnected(); }));
    ASSERT_TRUE(client->send(*motion.message()));
  }
  ASSERT_TRUE(eventually([&] { return controller.take(), controller.goals().size() == 2; }));
  const auto &first = controller.goals()[0], &second = controller.goals()[1];
  EXPECT_NE(bytesOf(first.id), bytesOf(second.id));
  EXPECT_NE(first.asker.client, second.asker.client);
  controller.answerGoal(first.asker, false);
  controller.answerGoal(second.asker, true);
  controller.publishStates({{second.id, GoalState::kExecuting}});
  for (auto& client : clients)
    EXPECT_TRUE(eventually([&] { return client->take() && client->accepted(); }));
  // Which of the two came first does not matter: one was refused, and the other one moves.
  const std::size_t moving = clients[0]->accepted() == std::optional(true) ? 0 : 1;
  EXPECT_EQ(clients[moving]->accepted(), std::optional(true));
  EXPECT_EQ(clients[1 - moving]->accepted(), std::optional(false));
  EXPECT_TRUE(eventually([&] { return clients[moving]->take() && clients[moving]->state() == GoalState::kExecuting; }));
  EXPECT_TRUE(clients[1 - moving]->take());
  EXPECT_EQ(clients[1 - moving]->state(), GoalState::kUnknown);
}

TEST(TrajectoryAction, FindsTheFormByTheMakerOfTheServersDds) {
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), robots = PrivateDomain::node();
  const auto nobody = TrajectoryAction::formOf(*own, kAction);
  ASSERT_TRUE(nobody) << nobody.error().message();
  EXPECT_FALSE(nobody->has_value());
  const PlayedController controller(*robots, kAction, RpcForm::kNumbered);
  std::optional<RpcForm> form;
  EXPECT_TRUE(eventually([&] { return form = TrajectoryAction::formOf(*own, kAction).value_or(std::nullopt), form.has_value(); }));
  EXPECT_EQ(form, std::optional(RpcForm::kNumbered)) << "Cyclone DDS";
  EXPECT_FALSE(TrajectoryAction::formOf(*own, "/another_controller/follow_joint_trajectory").value_or(RpcForm::kPlain));
}

TEST(TrajectoryAction, RefusesAnActionOfAnotherType) {
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), robots = PrivateDomain::node();
  ASSERT_TRUE(robots->openReader("rq" + std::string(kAction) + "/_action/send_goalRequest", std_msgs_msg_dds__String__desc,
                                 RosQuality::kDefault, std_msgs_msg_dds__String__desc.m_typename));
  ASSERT_TRUE(eventually([&] { return !TrajectoryAction::formOf(*own, kAction); }));
  const std::string said = TrajectoryAction::formOf(*own, kAction).error().message();
  for (const char* part : {kAction, "std_msgs::msg::dds_::String_", "control_msgs/action/FollowJointTrajectory"})
    EXPECT_THAT(said, ::testing::HasSubstr(part));
}

TEST(TrajectoryAction, StatesAreThoseOfActionMsgs) {
  // action_msgs/msg/GoalStatus: STATUS_UNKNOWN 0 to STATUS_ABORTED 6.
  const char* const names[] = {"unknown", "accepted", "executing", "canceling", "succeeded", "canceled", "aborted"};
  for (int number = 0; number <= 6; ++number) {
    EXPECT_STREQ(toString(static_cast<GoalState>(number)), names[number]);
    EXPECT_EQ(isOver(static_cast<GoalState>(number)), number >= 4) << number;
  }
  for (const int number : {-1, 7, 127}) {
    EXPECT_STREQ(toString(static_cast<GoalState>(number)), "unknown");
    EXPECT_FALSE(isOver(static_cast<GoalState>(number)));
  }
}

}  // namespace
}  // namespace hapticell::bridge
