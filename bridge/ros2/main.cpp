// SPDX-License-Identifier: Apache-2.0
// hapticell-ros2 JOB: one JSON object that says what to do, as hapticell-cli ros2 and the window make it. The result is one JSON
// object on standard output; a sentence on standard error and exit 2 say why not. With "texts" in the job it is a last object
// on standard output, so that the window can say it in its language.
#include <dds/version.h>
#include <sys/prctl.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bridge/ros2/cell_publisher.h"
#include "bridge/ros2/live_link.h"
#include "bridge/ros2/motion_sender.h"
#include "bridge/ros2/ros_listener.h"
#include "bridge/ros2/topic_list.h"
#include "config/program_version.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/packed_text.h"

namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // Set by a signal handler.

void askToStop(int) {
  stop_asked = true;
}

hapticell::bridge::RosNodeOptions nodeOptions(const nlohmann::json& job) {
  return {job.value("domain", 0), job.value("this_machine", false)};
}

/// A line of standard output. What other programs sent may be no UTF-8.
void putLine(const nlohmann::ordered_json& json) {
  std::printf("%s\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  std::fflush(stdout);
}

hapticell::Expected<nlohmann::ordered_json> publish(const nlohmann::json& job) {
  hapticell::bridge::PublishOptions options;
  options.node = nodeOptions(job);
  options.workcell = job.value("workcell", "");
  options.entity = job.value("entity", "");
  options.motion = job.value("motion", "");
  options.server = job.value("server", "");
  options.trajectory_topic = job.value("trajectory", "");
  options.folder = job.value("meshes", "");
  options.rate_hz = job.value("rate", options.rate_hz);
  options.seconds = job.value("seconds", options.seconds);
  options.wait = job.value("wait", options.wait);
  options.simulated_clock = job.value("clock", false);
  options.contacts = job.value("contacts", false);
  options.repeat = job.value("repeat", false);
  return hapticell::bridge::publishCell(options, stop_asked);
}

hapticell::Expected<nlohmann::ordered_json> listen(const nlohmann::json& job) {
  hapticell::bridge::ListenOptions options;
  options.node = nodeOptions(job);
  options.motion = job.value("output", "");
  options.trajectory = job.value("trajectory", "");
  options.description = job.value("description", "");
  options.workcell = job.value("workcell", "");
  options.entity = job.value("entity", "");
  options.mirrored = job.value("mirror", "");
  options.objects = job.value("objects", false);
  options.joint_topic = job.value("joint_topic", options.joint_topic);
  options.trajectory_topic = job.value("trajectory_topic", options.trajectory_topic);
  options.description_topic = job.value("description_topic", options.description_topic);
  options.seconds = job.value("seconds", options.seconds);
  return hapticell::bridge::listen(options, stop_asked);
}

hapticell::Expected<nlohmann::ordered_json> send(const nlohmann::json& job) {
  hapticell::bridge::SendOptions options;
  options.node = nodeOptions(job);
  options.motion.workcell = job.value("workcell", "");
  options.motion.entity = job.value("entity", "");
  options.motion.motion = job.value("motion", "");
  options.motion.action = job.value("action", "");
  options.motion.tool_speed = job.value("tool_speed", options.motion.tool_speed);
  options.motion.joint_share = job.value("joint_share", options.motion.joint_share);
  options.confirmation = job.value("confirmation", "");
  const std::string services = job.value("services", "auto");
  if (services != "auto")
    options.services = services == "plain" ? hapticell::bridge::RpcForm::kPlain : hapticell::bridge::RpcForm::kNumbered;
  options.joint_topic = job.value("joint_topic", options.joint_topic);
  options.hold = job.value("hold", "");
  options.texts = job.value("texts", false);
  options.wait = job.value("wait", options.wait);
  if (job.value("progress", false)) options.progress = putLine;
  return hapticell::bridge::sendMotion(options, stop_asked);
}

hapticell::Expected<nlohmann::ordered_json> link(const nlohmann::json& job) {
  hapticell::bridge::LiveLinkOptions options;
  options.node = nodeOptions(job);
  options.workcell = job.value("workcell", "");
  options.entity = job.value("entity", "");
  options.mirror = job.value("mirror", false);
  options.joint_topic = job.value("joint_topic", options.joint_topic);
  options.rate_hz = job.value("rate", options.rate_hz);
  return hapticell::bridge::runLiveLink(options, stop_asked);
}

hapticell::Expected<nlohmann::ordered_json> topics(const nlohmann::json& job) {
  hapticell::bridge::TopicSearch search;
  search.node = nodeOptions(job);
  search.seconds = job.value("seconds", search.seconds);
  if (job.value("progress", false)) search.progress = putLine;
  return hapticell::bridge::findTopics(search, stop_asked);
}

hapticell::Expected<nlohmann::ordered_json> done(const nlohmann::json& job) {
  const std::string what = job.value("do", "");
  if (what == "listen") return listen(job);
  if (what == "link") return link(job);
  if (what == "topics") return topics(job);
  return what == "send" ? send(job) : publish(job);
}

constexpr const char* kUsage = R"(Usage: hapticell-ros2 JOB

Speaks with ROS 2 for hapticell-cli and the window, which start it, so that a fault in the DDS library cannot end
them. It is not meant to be started by hand: use hapticell-cli ros2.

JOB is one JSON object that says what to publish or to listen to. The result is one JSON object on standard output.

Options:
  --help                 show this text and exit
  --version              show version, commit, compiler and libraries, and exit
)";

/// Answers --help and --version; false for everything else.
bool answers(std::string_view option) {
  if (option == "--help" || option == "-h") return std::fputs(kUsage, stdout), true;
  if (option != "--version") return false;
  return std::puts(hapticell::config::versionText("hapticell-ros2", {{"Cyclone DDS", DDS_VERSION}}).c_str()), true;
}

int run(const std::string& text) {
  if (!hapticell::geometry::checkNesting(text, hapticell::geometry::NestedText::kJson, "job")) return 2;
  const nlohmann::json job = nlohmann::json::parse(text, nullptr, false);
  if (!job.is_object()) {
    std::fprintf(stderr, "hapticell-ros2 is started by 'hapticell-cli ros2'.\n");
    return 2;
  }
  const auto result = done(job);
  if (!result) {
    if (job.value("texts", false)) {
      putLine({{"failure", hapticell::packed(result.error())}, {"file", result.error().file}});
    } else {
      std::fprintf(stderr, "hapticell-cli: %s\n", result.error().message().c_str());
    }
    return 2;
  }
  putLine(*result);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && answers(argv[1])) return 0;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // It ends with hapticell-cli.
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
  try {
    return run(argc == 2 ? argv[1] : "");
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "hapticell-cli: ros2: %s\n", problem.what());
    return 2;
  }
}
