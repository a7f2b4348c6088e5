// SPDX-License-Identifier: Apache-2.0
#include "cli/robot_options.h"

#include "cli/result_writer.h"
#include "kinematics/jacobian.h"
#include "workcell/entity_source.h"

namespace hapticell::cli {

std::vector<std::string> RobotWithTip::jointNames() const {
  std::vector<std::string> names;
  for (const int variable : variables) {
    const int joint = model.moving[static_cast<std::size_t>(variable)];
    names.push_back(model.joints[static_cast<std::size_t>(joint)].name);
  }
  return names;
}

Expected<RobotWithTip> readRobotWithTip(const std::string& file, const std::string& tip_name) {
  Diagnostics diagnostics;
  workcell::EntityLoader loader(".");
  const auto entity = loader.load(file, 1.0, diagnostics);
  for (const std::string& sentence : diagnostics.warnings) warn(sentence);
  if (!entity) return makeError(entity.error());
  if (!entity->robot) return makeError({file, "", "it is no robot", "a robot file, or library:NAME", ""});
  RobotWithTip robot{*entity->robot, -1, {}};
  robot.tip = tip_name.empty() ? robot.model.defaultTip() : robot.model.findLink(tip_name);
  if (robot.tip < 0) {
    std::string links;
    for (const kinematics::Link& link : robot.model.links) links += (links.empty() ? "" : ", ") + link.name;
    return makeError({file, "--tip", "there is no link '" + tip_name + "'", "one of " + links, ""});
  }
  robot.variables = kinematics::variablesOfChain(robot.model, robot.tip);
  return robot;
}

}  // namespace hapticell::cli
