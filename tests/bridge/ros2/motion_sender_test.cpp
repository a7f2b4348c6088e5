// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/motion_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "geometry/system/packed_text.h"
#include "tests/bridge/ros2/played_controller.h"
#include "tests/bridge/ros2/private_domain.h"
#include "tests/bridge/ros2/slide_cell.h"
#include "tests/haptic/server/live_server.h"

namespace hapticell::bridge {
namespace {

using ::testing::HasSubstr;

/// 15 mm in half a second: as it is, within all limits, and no farther than a robot may be from its path.
SendOptions shortMotion(const SlideCell& cell) {
  SendOptions options;
  options.node = PrivateDomain::options();
  options.motion = cell.wanted;
  options.motion.action = "/slide_controller/follow_joint_trajectory";
  return options;
}

std::string refusalOf(const SendOptions& options, bool is_stopped = false) {
  const std::atomic<bool> stop{is_stopped};
  const auto sent = sendMotion(options, stop);
  return sent ? sent->dump() : sent.error().message();
}

TEST(SendMotion, WithoutAConfirmationItIsAPreview) {
  const SlideCell cell(0.015, 0.5);
  const SendOptions options = shortMotion(cell);
  const std::atomic<bool> stop{false};
  const auto preview = sendMotion(options, stop);
  ASSERT_TRUE(preview) << preview.error().message();
  const auto checked = checkedMotion(options.motion);
  ASSERT_TRUE(checked);
  auto wanted = previewOf(*checked, options.motion.action);
  wanted["sent"] = false;
  EXPECT_EQ(*preview, wanted);
}

TEST(SendMotion, RefusesWhatIsNotTheRobotsOrNotConfirmed) {
  const SlideCell cell(0.015, 0.5);
  SendOptions empty = shortMotion(cell);
  empty.motion.workcell = cell.folder.write("empty.hcell", R"({"format": "hapticell-workcell", "version": 1, "entities": [
    {"name": "wall", "source": {"file": "box:0.1,1,1"}}]})").string();
  EXPECT_THAT(refusalOf(empty), HasSubstr("no robot"));
  SendOptions other = shortMotion(cell);
  other.motion.motion = cell.folder.write("other.csv", "t,elbow\n0,0\n1,0.01\n").string();
  EXPECT_THAT(refusalOf(other), HasSubstr("elbow"));
  EXPECT_THAT(refusalOf(other), HasSubstr("other.csv"));
  SendOptions changed = shortMotion(cell);
  changed.confirmation = checkedMotion(SlideCell(0.016, 0.5).wanted)->confirmation;
  EXPECT_THAT(refusalOf(changed), HasSubstr("not the one that was confirmed"));
}

TEST(SendMotion, SaysWhichControllerIsMissing) {
  const SlideCell cell(0.015, 0.5);
  const PrivateDomain domain;
  SendOptions options = shortMotion(cell);
  options.confirmation = checkedMotion(options.motion)->confirmation;
  options.wait = 0.2;
  const std::string nobody = refusalOf(options);
  EXPECT_THAT(nobody, HasSubstr(options.motion.action));
  EXPECT_THAT(nobody, HasSubstr("no controller offers this action"));
  options.services = RpcForm::kPlain;  // Not looked for, but met.
  const std::string silent = refusalOf(options);
  EXPECT_THAT(silent, HasSubstr(options.motion.action));
  EXPECT_THAT(silent, HasSubstr("does not answer on all topics"));
  options.wait = 1000.0;
  EXPECT_THAT(refusalOf(options, true), HasSubstr("stopped before the motion was sent"));
}

/// The robot of a SlideCell with its controller, in a thread of its own until this object ends.
class PlayedRobot {
 public:
  enum class Answer { kReject, kSucceed, kCancel };

  /// `stopping` is called once the goal came if the answer is kCancel, in the robot's thread.
  PlayedRobot(const std::string& action, double position, Answer answer, std::function<void()> stopping = {})
      : node_(PrivateDomain::node()),
        controller_(*node_, action, RpcForm::kNumbered),
        position_(position),
        answer_(answer),
        stopping_(std::move(stopping)) {
    const auto writer = node_->advertise("/joint_states", sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault);
    EXPECT_TRUE(writer);
    joints_ = writer.value_or(0);
    thread_ = std::thread([this] { run(); });
  }
  ~PlayedRobot() { end(); }
  PlayedRobot(const PlayedRobot&) = delete;
  PlayedRobot& operator=(const PlayedRobot&) = delete;

  /// Ends the thread. What came until then.
  const PlayedController& end() {
    over_ = true;
    if (thread_.joinable()) thread_.join();
    return controller_;
  }

 private:
  void run() {
    JointStateMessage message({"x"});
    for (std::size_t goals = 0, cancellations = 0, questions = 0; !over_;) {
      EXPECT_TRUE(node_->write(joints_, message.at(0, {position_})));
      controller_.take();
      for (; goals < controller_.goals().size(); ++goals) begin(controller_.goals()[goals]);
      for (; cancellations < controller_.cancellations().size(); ++cancellations) {
        controller_.answerCancellation(controller_.cancellations()[cancellations].asker);
        controller_.publishStates({{controller_.cancellations()[cancellations].goal.goal_id, GoalState::kCanceled}});
      }
      const GoalState last = answer_ == Answer::kSucceed ? GoalState::kSucceeded : GoalState::kCanceled;
      for (; questions < controller_.questions().size(); ++questions)
        controller_.answerQuestion(controller_.questions()[questions].asker, last, 0, "");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void begin(const PlayedController::Goal& goal) {
    if (answer_ == Answer::kCancel) stopping_();
    controller_.answerGoal(goal.asker, answer_ != Answer::kReject);
    if (answer_ == Answer::kReject) return;
    controller_.publishStates({{goal.id, GoalState::kExecuting}});
    for (int i = 0; i < 3; ++i) controller_.publishFeedback(goal.id);
    if (answer_ == Answer::kSucceed) controller_.publishStates({{goal.id, GoalState::kSucceeded}});
  }

  std::unique_ptr<RosNode> node_;
  PlayedController controller_;
  double position_;
  Answer answer_;
  std::function<void()> stopping_;
  dds_entity_t joints_ = 0;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

TEST(SendMotion, SendsNothingToARobotThatIsElsewhere) {
  const SlideCell cell(0.015, 0.5);
  const PrivateDomain domain;
  SendOptions options = shortMotion(cell);
  options.confirmation = checkedMotion(options.motion)->confirmation;
  options.wait = 30.0;
  const std::atomic<bool> stop{false};
  PlayedRobot robot(options.motion.action, 0.002, PlayedRobot::Answer::kSucceed);  // 1 mm is allowed.
  const auto sent = sendMotion(options, stop);
  ASSERT_FALSE(sent) << sent->dump();
  EXPECT_THAT(sent.error().message(), HasSubstr("joint 'x' of the robot is not at the first point"));
  EXPECT_TRUE(robot.end().goals().empty());
}

TEST(SendMotion, SendsWhatWasConfirmedAndSaysHowItEnded) {
  const SlideCell cell(0.015, 0.5);
  const PrivateDomain domain;
  SendOptions options = shortMotion(cell);
  const auto checked = checkedMotion(options.motion);
  ASSERT_TRUE(checked) << checked.error().message();
  options.confirmation = checked->confirmation;
  options.wait = 30.0;
  using Answer = PlayedRobot::Answer;
  for (const auto& [answer, outcome] :
       {std::pair(Answer::kSucceed, "succeeded"), {Answer::kCancel, "canceled"}, {Answer::kReject, "rejected"}}) {
    std::atomic<bool> stop{false};
    PlayedRobot robot(options.motion.action, 0.0005, answer, [&stop] { stop = true; });
    const auto sent = sendMotion(options, stop);
    ASSERT_TRUE(sent) << outcome << ": " << sent.error().message();
    EXPECT_EQ((*sent)["sent"], true) << outcome;
    EXPECT_EQ((*sent)["outcome"], outcome);
    EXPECT_EQ((*sent)["confirmation"], checked->confirmation);
    EXPECT_EQ((*sent)["feedbacks"], answer == Answer::kReject ? 0 : 3) << outcome;
    const PlayedController& controller = robot.end();
    ASSERT_EQ(controller.goals().size(), 1u) << outcome;
    EXPECT_EQ(controller.goals()[0].joints, std::vector<std::string>{"x"});
    EXPECT_EQ(controller.goals()[0].points, PlayedController::pointsOf(*checked->message->message()));
    if (answer != Answer::kCancel) continue;
    EXPECT_FALSE(controller.cancellations().empty());
    EXPECT_FALSE((*sent)["reason"].get<std::string>().empty());
  }
}

/// A haptic server with a played stylus; another program holds it, as a person would.
class PlayedStylus {
 public:
  PlayedStylus() {
    haptic::TcpLinkOptions options;
    options.port = server_.port();
    hand_ = std::make_unique<haptic::TcpLink>(options);
    EXPECT_TRUE(haptic::connects(*hand_));
  }
  std::string address() const { return "127.0.0.1:" + std::to_string(server_.port()); }
  void press() { hand_->sendHandTarget({.holding = true, .X_DH = kHeld, .buttons = 1}); }
  void letGo() { hand_->sendHandTarget({.holding = true, .X_DH = kHeld, .buttons = 0}); }
  void endServer() { server_.stop(); }

 private:
  const Pose kHeld = Pose::translation(dvec3(0.0, 0.0, 0.005));
  haptic::LiveServer server_;
  std::unique_ptr<haptic::TcpLink> hand_;
};

TEST(SendMotion, NothingIsSentUntilAButtonOfTheStylusIsHeld) {
  const SlideCell cell(0.015, 0.5);
  const PrivateDomain domain;
  PlayedStylus stylus;
  SendOptions options = shortMotion(cell);
  options.confirmation = checkedMotion(options.motion)->confirmation;
  options.hold = stylus.address();
  options.wait = 1.0;
  PlayedRobot robot(options.motion.action, 0.0, PlayedRobot::Answer::kSucceed);
  std::string said;
  // Again where a busy machine took the second for finding the controller.
  for (int i = 0; i < 20 && said.find("button") == std::string::npos; ++i) said = refusalOf(options);
  EXPECT_THAT(said, HasSubstr("no button of the stylus was pressed"));
  EXPECT_THAT(said, HasSubstr(stylus.address()));
  EXPECT_TRUE(robot.end().goals().empty());
  for (const char* wrong : {"127.0.0.1", "127.0.0.1:0"}) {
    options.hold = wrong;
    EXPECT_THAT(refusalOf(options), HasSubstr("--hold")) << wrong;
  }
}

TEST(SendMotion, TheRobotStopsWhenTheButtonIsLetGoOrItsServerIsLost) {
  const SlideCell cell(0.015, 0.5);
  const PrivateDomain domain;
  SendOptions options = shortMotion(cell);
  options.confirmation = checkedMotion(options.motion)->confirmation;
  options.texts = true;
  options.wait = 30.0;
  using Answer = PlayedRobot::Answer;
  enum class End { kHeld, kLetGo, kLost };
  for (const End end : {End::kHeld, End::kLetGo, End::kLost}) {
    PlayedStylus stylus;
    stylus.press();
    options.hold = stylus.address();
    PlayedRobot robot(options.motion.action, 0.0005, end == End::kHeld ? Answer::kSucceed : Answer::kCancel,
                      [&stylus, end] { end == End::kLetGo ? stylus.letGo() : stylus.endServer(); });
    const std::atomic<bool> stop{false};
    const auto sent = sendMotion(options, stop);
    ASSERT_TRUE(sent) << sent.error().message();
    const PlayedController& controller = robot.end();
    EXPECT_EQ(controller.goals().size(), 1u);
    EXPECT_EQ((*sent)["outcome"], end == End::kHeld ? "succeeded" : "canceled");
    EXPECT_EQ(controller.cancellations().empty(), end == End::kHeld);
    if (end == End::kHeld) continue;
    EXPECT_THAT((*sent)["reason"].get<std::string>(), HasSubstr("the button of the stylus was released, or its server was lost"));
    const auto text = unpackedText((*sent)["reason_text"].get<std::string>());
    ASSERT_TRUE(text);
    EXPECT_EQ(english(*text), (*sent)["reason"]) << "the window translates it";
  }
}

}  // namespace
}  // namespace hapticell::bridge
