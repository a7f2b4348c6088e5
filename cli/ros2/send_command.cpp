// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/send_command.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/kit/result_writer.h"
#include "cli/ros2/ros_words.h"
#include "haptic/client/server_address.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct SendWords {
  RosWords ros;
  std::string workcell, entity, motion, action, confirm, hold, services = "auto", joint_topic = "/joint_states";
  double tool_speed = 0.25, joint_share = 1.0, wait = 5.0;
};

ordered_json jobOf(const SendWords& words, const std::string& confirmation) {
  return {{"do", "send"},
          {"workcell", words.workcell},
          {"entity", words.entity},
          {"motion", words.motion},
          {"action", words.action.starts_with("/") ? words.action : "/" + words.action},
          {"tool_speed", words.tool_speed},
          {"joint_share", words.joint_share},
          {"confirmation", confirmation},
          {"services", words.services},
          {"joint_topic", words.joint_topic},
          {"hold", words.hold},
          {"wait", words.wait}};
}

/// The name that a person types at the terminal; empty if there is none.
std::string typedName(const ordered_json& preview) {
  if (::isatty(STDIN_FILENO) != 1) return {};
  std::fprintf(stderr, "%s\nCtrl+C stops it. Type the name of the robot to send it: ", confirmationSentence(preview).c_str());
  std::string name;
  std::getline(std::cin, name);
  return name;
}

Expected<ExitStatus> sendWith(const SendWords& words, const ResultWriter& writer) {
  if (!words.hold.empty()) HAPTICELL_TRY(haptic::parseServerAddress(words.hold, "--hold"));
  const auto preview = bridgeResult(jobOf(words, ""), words.ros);
  HAPTICELL_TRY(preview);
  if (!*preview) return ExitStatus::kBadInput;
  const std::string robot = (*preview)->value("robot", "");
  const std::string named = words.confirm.empty() ? typedName(**preview) : words.confirm;
  if (!named.empty() && named != robot)
    return makeError({{}, "--confirm", Text("'%1'", named), Text("the name of the robot, '%1'", robot), {}});
  if (named.empty()) {
    HAPTICELL_TRY(writer.write(**preview));
    std::fprintf(stderr, "%s\nNothing was sent. To send it, add --confirm and the name of the robot.\n",
                 confirmationSentence(**preview).c_str());
    return ExitStatus::kDone;
  }
  const auto result = bridgeResult(jobOf(words, (*preview)->value("confirmation", "")), words.ros);
  HAPTICELL_TRY(result);
  if (!*result) return ExitStatus::kBadInput;
  HAPTICELL_TRY(writer.write(**result));
  return (*result)->value("outcome", "") == "succeeded" ? ExitStatus::kDone : ExitStatus::kCheckFound;
}

ExitStatus runSend(const SendWords& words, const ResultWriter& writer) {
  const auto status = sendWith(words, writer);
  if (status) return *status;
  report(status.error());
  return ExitStatus::kBadInput;
}

}  // namespace

std::string confirmationSentence(const ordered_json& preview) {
  char text[200];
  std::snprintf(text, sizeof text, "' moves for %.1f s, its tool at up to %.0f mm/s and its fastest joint at %.0f %% of its limit, ",
                preview.value("duration", 0.0), 1e3 * preview.value("tool_speed", 0.0), 100.0 * preview.value("joint_share", 0.0));
  std::string sentence = "Robot '" + preview.value("robot", "") + text + "on " + preview.value("action", "") + ".";
  if (preview.value("slowed", 1.0) > 1.0) {
    std::snprintf(text, sizeof text, " The motion is slowed %.2f times.", preview.value("slowed", 1.0));
    sentence += text;
  }
  for (const auto& pair : preview.value("touching_at_start", ordered_json::array()))
    sentence += " Not checked, because they touch at the start: " + pair.get<std::string>() + ".";
  return sentence;
}

void addSendCommand(Subcommand ros2, Action& chosen) {
  const auto words = std::make_shared<SendWords>();
  Subcommand send = ros2.add("send", "Check a motion and send it to a robot's controller (FollowJointTrajectory)");
  send.option("--workcell", words->workcell, "Workcell document, *.hcell").takes(ValueKind::kWorkcell).required();
  send.option("--entity", words->entity, "Robot of the cell (default: the only one)");
  send.option("--motion", words->motion, "Motion of the robot, in any format that is read")
      .takes(ValueKind::kMotion)
      .required();
  send.option("--action", words->action, "Action of the controller: /arm_controller/follow_joint_trajectory").required();
  send.option("--confirm", words->confirm, "Name of the robot, to send the motion without a question at the terminal");
  send.option("--tool-speed", words->tool_speed, "Greatest speed of the tool, m/s (0.25); a faster motion is slowed")
      .within(0.001, 10.0);
  send.option("--joint-share", words->joint_share, "Greatest share of each joint's speed limit (1); likewise")
      .within(0.001, 1.0);
  send.option("--hold", words->hold, "HOST:PORT of a haptic server; the robot moves while a button of its stylus is held");
  send.option("--joint-topic", words->joint_topic, "Topic of the robot's joint states (/joint_states)");
  send.option("--services", words->services, "Form of the controller's services (auto: by the maker of its DDS)")
      .among({"auto", "plain", "numbered"});
  send.option("--wait", words->wait, "How long to wait for controller, robot and button, s (5)").within(0.0, 3600.0);
  addRosWords(send, words->ros);
  send.onChosen([words, &chosen] { chosen = [words](ResultWriter& writer) { return runSend(*words, writer); }; });
}

}  // namespace hapticell::cli
