// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/motion_sender.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <thread>

#include "bridge/ros2/cell_sources.h"
#include "bridge/ros2/taken_samples.h"
#include "bridge/ros2/trajectory_action.h"
#include "geometry/system/packed_text.h"

namespace hapticell::bridge {

namespace {

using SteadyClock = std::chrono::steady_clock;
using nlohmann::ordered_json;

constexpr auto kPoll = std::chrono::milliseconds(2);
// Robots publish at 50 Hz and faster. Half: a busy network stops a good motion; twice: it runs blind for a second.
constexpr double kSilence = 0.5;
// Controllers reach their goals to some mrad. Half: noisy encoders are refused; twice: the jump at the start is felt.
constexpr double kStartAngle = 0.01, kStartLength = 0.001;
// Robots lag behind by some hundredths of a second at full speed. Half: fast motions are stopped; twice: a collision is
// noticed later.
constexpr double kPathAngle = 0.2, kPathLength = 0.02;
// For an answer of the controller. Half: a loaded one is taken for lost; twice: the user waits.
constexpr double kPatience = 5.0;

double secondsSince(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

/// Where the robot says that it is.
class RobotJoints {
 public:
  RobotJoints(dds_entity_t reader, const CheckedMotion& motion) : reader_(reader) {
    const auto& names = motion.message->message()->joint_names;
    for (std::uint32_t j = 0; j < names._length; ++j) places_[names._buffer[j]] = j;
    joints_.resize(names._length, 0.0);
    heard_.resize(names._length);
  }

  void take() {
    takeAll<sensor_msgs_msg_dds__JointState_>(reader_, [this](const auto& state) {
      for (std::uint32_t i = 0; i < std::min(state.name._length, state.position._length); ++i) {
        const auto place = places_.find(state.name._buffer[i] ? state.name._buffer[i] : "");
        if (place == places_.end() || !std::isfinite(state.position._buffer[i])) continue;
        joints_[place->second] = state.position._buffer[i];
        heard_[place->second] = SteadyClock::now();
      }
    });
  }

  const std::vector<double>& joints() const { return joints_; }
  /// Age of the oldest joint, s; infinite: one of them never came.
  double age() const {
    double age = 0.0;
    for (const auto& heard : heard_) age = std::max(age, heard ? secondsSince(*heard) : HUGE_VAL);
    return age;
  }

 private:
  dds_entity_t reader_;
  std::map<std::string, std::size_t> places_;
  std::vector<double> joints_;
  std::vector<std::optional<SteadyClock::time_point>> heard_;
};

/// The joint that is farthest from where it should be, in units of what is allowed, and its name.
struct Apart {
  double share = 0.0;
  std::string joint;
};

Apart apartFrom(const CheckedMotion& motion, const std::vector<double>& wanted, const std::vector<double>& joints,
                double angle, double length) {
  Apart apart;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    const double share = std::abs(joints[j] - wanted[j]) / (motion.is_sliding[j] ? length : angle);
    if (share >= apart.share) apart = {share, motion.message->message()->joint_names._buffer[j]};
  }
  return apart;
}

/// The button of a stylus that is held while the robot may move. Without a server it counts as held.
class HeldButton {
 public:
  explicit HeldButton(std::unique_ptr<haptic::TcpLink> link) : link_(std::move(link)) {}

  bool isHeld() {
    if (!link_) return true;
    while (const auto state = link_->latestState()) {
      is_pressed_ = state->buttons != 0;
      heard_ = SteadyClock::now();
    }
    // Servers send 100 states a second and more. Half: a busy machine stops the robot; twice: it stops later.
    return is_pressed_ && link_->linkState() == haptic::LinkState::kConnected && secondsSince(heard_) < 0.1;
  }

 private:
  std::unique_ptr<haptic::TcpLink> link_;
  bool is_pressed_ = false;
  SteadyClock::time_point heard_{};
};

/// Waits until `is_done`; false after `seconds` or when stopped.
template <typename IsDone>
bool waitFor(double seconds, const std::atomic<bool>& stop, const IsDone& is_done) {
  const auto begin = SteadyClock::now();
  while (!is_done()) {
    if (stop || secondsSince(begin) > seconds) return false;
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

tl::unexpected<Error> stoppedBefore(const SendOptions& options) {
  return makeError({.file = options.motion.action, .found = "stopped before the motion was sent"});
}

Expected<std::unique_ptr<TrajectoryAction>> connected(RosNode& node, const SendOptions& options,
                                                      const std::atomic<bool>& stop) {
  std::optional<RpcForm> form = options.services;
  Expected<std::optional<RpcForm>> found;
  const bool is_found = waitFor(options.wait, stop, [&] {
    if (form) return true;
    found = TrajectoryAction::formOf(node, options.motion.action);
    return !found || found->has_value();
  });
  HAPTICELL_TRY(found);
  if (stop) return stoppedBefore(options);
  if (!is_found)
    return makeError({.file = options.motion.action,
                      .found = "no controller offers this action",
                      .expected = "a running controller",
                      .fix = "Start it, compare the name with 'ros2 action list', or use a longer --wait."});
  auto action = TrajectoryAction::open(node, options.motion.action, form ? *form : **found);
  HAPTICELL_TRY(action);
  if (!waitFor(options.wait, stop, [&] { return (*action)->isConnected(); })) {
    if (stop) return stoppedBefore(options);
    return makeError({.file = options.motion.action,
                      .found = "the controller does not answer on all topics of the action",
                      .expected = "a controller that runs",
                      .fix = "Check the network in both directions."});
  }
  return action;
}

/// The robot is there and at the first point.
Expected<void> isAtStart(const CheckedMotion& motion, RobotJoints& robot, const SendOptions& options,
                         const std::atomic<bool>& stop) {
  const bool is_heard = waitFor(options.wait, stop, [&] {
    robot.take();
    return robot.age() < kSilence;
  });
  if (stop) return stoppedBefore(options);
  if (!is_heard)
    return makeError({.file = options.joint_topic,
                      .found = "the robot does not publish all joints of the motion",
                      .expected = "its joint states",
                      .fix = "Start its driver, or name its topic by --joint-topic."});
  const Apart apart = apartFrom(motion, motion.start, robot.joints(), kStartAngle, kStartLength);
  if (apart.share <= 1.0) return {};
  return makeError({.file = options.motion.motion,
                    .found = Text("joint '%1' of the robot is not at the first point of the motion", apart.joint),
                    .expected = "a robot within 0.01 rad (1 mm) of it",
                    .fix = "Move the robot there, or record a motion that begins where it is."});
}

/// The motion while it runs.
class RunningMotion {
 public:
  RunningMotion(const CheckedMotion& motion, TrajectoryAction& action, RobotJoints& robot, HeldButton& button,
                const SendOptions& options)
      : motion_(motion),
        path_(executedPath(*motion.message->message())),
        action_(action),
        robot_(robot),
        button_(button),
        options_(options) {}

  /// To its end, or to where it was cancelled. Error: the controller does not confirm it.
  Expected<ordered_json> run(const std::atomic<bool>& stop) {
    begin_ = SteadyClock::now();
    HAPTICELL_TRY(action_.send(*motion_.message->message()));
    while (!isOver(action_.state())) {
      HAPTICELL_TRY(action_.take());
      robot_.take();
      follow();
      const Text reason = whyStop(stop);
      if (!reason.empty() && reason_.empty()) {
        reason_ = reason;
        cancelled_ = SteadyClock::now();
        HAPTICELL_TRY(action_.cancel());
        repeated_ = cancelled_;
      }
      if (isRejected()) return ordered_json{{"outcome", "rejected"}, {"reason", english(reason_)}, {"feedbacks", 0}};
      if (!reason_.empty()) HAPTICELL_TRY(insist());
      std::this_thread::sleep_for(kPoll);
    }
    return ended();
  }

 private:
  /// The controller said no, and no state of the goal followed.
  bool isRejected() {
    if (action_.accepted() != std::optional(false) || action_.state() != GoalState::kUnknown) return false;
    if (!refused_) refused_ = SteadyClock::now();
    // The state of a goal follows its acceptance within some ms; half or twice of this only waits less or more.
    return secondsSince(*refused_) > 0.5;
  }

  void follow() {
    const GoalState state = action_.state();
    if (!started_ && (state == GoalState::kExecuting || action_.feedbacks() > 0)) started_ = SteadyClock::now();
    if (!options_.progress || secondsSince(shown_) < 0.1) return;
    shown_ = SteadyClock::now();
    options_.progress({{"t", started_ ? secondsSince(*started_) : 0.0}, {"state", toString(state)}, {"joints", robot_.joints()}});
  }

  Text whyStop(const std::atomic<bool>& stop) {
    if (stop) return Text("stopped by the user");
    if (!button_.isHeld()) return Text("the button of the stylus was released, or its server was lost");
    if (robot_.age() > kSilence) return Text("the robot's joint states did not come for 0.5 s");
    if (!started_ && secondsSince(begin_) > kPatience && !isOver(action_.state()))
      return Text("the controller did not start the motion within 5 s");
    if (!started_) return {};
    const double t = secondsSince(*started_);
    if (t > motion_.duration + kPatience) return Text("the motion lasts longer than it should");
    const Apart apart = apartFrom(motion_, path_.jointsAt(std::min(t, motion_.duration)), robot_.joints(), kPathAngle, kPathLength);
    if (apart.share > 1.0) return Text("joint '%1' left the motion by more than 0.2 rad (20 mm)", apart.joint);
    return {};
  }

  /// Repeats the cancellation until it is confirmed.
  Expected<void> insist() {
    if (secondsSince(cancelled_) > kPatience)
      return makeError({.file = options_.motion.action,
                        .found = Text("%1, and the controller did not confirm that it stopped", reason_),
                        .expected = "a robot that rests",
                        .fix = "Press the emergency stop of the robot cell."});
    if (secondsSince(repeated_) < 0.25) return {};
    repeated_ = SteadyClock::now();
    return action_.cancel();
  }

  Expected<ordered_json> ended() {
    const double seconds = secondsSince(begin_);
    const auto asked = SteadyClock::now();
    while (!action_.result() && secondsSince(asked) < 2.0) {
      HAPTICELL_TRY(action_.take());
      std::this_thread::sleep_for(kPoll);
    }
    ordered_json result{{"outcome", toString(action_.state())}, {"reason", english(reason_)}};
    if (options_.texts) result["reason_text"] = packed(reason_);
    if (const auto& said = action_.result()) {
      result["error_code"] = said->error_code;
      result["error"] = said->error;
    }
    result["feedbacks"] = action_.feedbacks();
    result["seconds"] = seconds;
    return result;
  }

  const CheckedMotion& motion_;
  const trajectory::Trajectory path_;
  TrajectoryAction& action_;
  RobotJoints& robot_;
  HeldButton& button_;
  const SendOptions& options_;
  SteadyClock::time_point begin_{}, shown_{}, cancelled_{}, repeated_{};
  std::optional<SteadyClock::time_point> started_, refused_;
  Text reason_;
};

}  // namespace

Expected<ordered_json> sendMotion(const SendOptions& options, const std::atomic<bool>& stop) {
  const auto motion = checkedMotion(options.motion);
  HAPTICELL_TRY(motion);
  ordered_json result = previewOf(*motion, options.motion.action);
  result["sent"] = false;
  if (options.confirmation.empty()) return result;
  if (options.confirmation != motion->confirmation)
    return makeError({.file = options.motion.motion,
                      .found = "the motion is not the one that was confirmed",
                      .expected = "the confirmed motion",
                      .fix = "Preview it again and confirm what you see."});
  auto link = watchedServer(options.hold, "--hold");
  HAPTICELL_TRY(link);
  HeldButton button(std::move(*link));
  auto node = RosNode::create(options.node);
  HAPTICELL_TRY(node);
  const auto reader = (*node)->subscribe(options.joint_topic, sensor_msgs_msg_dds__JointState__desc, RosQuality::kSensor);
  HAPTICELL_TRY(reader);
  RobotJoints robot(*reader, *motion);
  auto action = connected(**node, options, stop);
  HAPTICELL_TRY(action);
  if (!waitFor(options.wait, stop, [&] { return button.isHeld(); })) {
    if (stop) return stoppedBefore(options);
    return makeError({.file = options.hold,
                      .found = "no button of the stylus was pressed",
                      .expected = "a button that is held during the motion",
                      .fix = "Hold it before the motion begins."});
  }
  HAPTICELL_TRY(isAtStart(*motion, robot, options, stop));
  RunningMotion running(*motion, **action, robot, button, options);
  const auto ended = running.run(stop);
  HAPTICELL_TRY(ended);
  result["sent"] = true;
  result.update(*ended);
  return result;
}

}  // namespace hapticell::bridge
