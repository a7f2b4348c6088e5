// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/ros_words.h"

#include <cstdlib>
#include <string>

#include "cli/ros2/bridge_call.h"

namespace hapticell::cli {

namespace {

/// --domain, else ROS_DOMAIN_ID, else 0.
Expected<int> domainOf(const RosWords& words) {
  const char* const named = std::getenv("ROS_DOMAIN_ID");
  if (words.domain >= 0) return words.domain;
  if (!named || *named == '\0') return 0;
  char* end = nullptr;
  const long domain = std::strtol(named, &end, 10);
  if (*end != '\0' || domain < 0 || domain > 232)
    return makeError({.place = "ROS_DOMAIN_ID", .found = std::string(named), .expected = "0 to 232"});
  return static_cast<int>(domain);
}

}  // namespace

void addRosWords(Subcommand command, RosWords& words) {
  command.option("--domain", words.domain, "Domain, 0 to 232 (ROS_DOMAIN_ID, else 0)").withinWhole(0, 232);
  command.flag("--this-machine", words.this_machine, "Only programs on this machine (as ROS_LOCALHOST_ONLY=1)");
}

Expected<std::optional<nlohmann::ordered_json>> bridgeResult(nlohmann::ordered_json job, const RosWords& words) {
  const auto domain = domainOf(words);
  HAPTICELL_TRY(domain);
  const char* const local = std::getenv("ROS_LOCALHOST_ONLY");
  job["domain"] = *domain;
  job["this_machine"] = words.this_machine || (local && std::string(local) == "1");
  const auto answer = callBridge(job.dump());
  HAPTICELL_TRY(answer);
  if (answer->status != 0) return std::nullopt;
  auto result = nlohmann::ordered_json::parse(answer->output, nullptr, false);
  if (result.is_discarded())
    return makeError({.found = "hapticell-ros2 gave no result", .fix = "This is a bug. Please report it."});
  return result;
}

}  // namespace hapticell::cli
