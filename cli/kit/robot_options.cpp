// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/robot_options.h"

#include "cli/kit/result_writer.h"
#include "cli/kit/workcell_arguments.h"
#include "cli/kit/xacro_arguments.h"
#include "geometry/system/listed.h"
#include "kinematics/model/jacobian.h"
#include "kinematics/model/mounted_robot.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::cli {

std::vector<std::string> RobotWithTip::jointNames() const {
  std::vector<std::string> names;
  for (const int variable : variables) {
    const int joint = model.moving[static_cast<std::size_t>(variable)];
    names.push_back(model.joints[static_cast<std::size_t>(joint)].name);
  }
  return names;
}

namespace {

Expected<kinematics::RobotModel> readModel(const std::string& text, workcell::RobotContent content,
                                           Diagnostics& diagnostics) {
  const auto [file, arguments] = splitXacroArguments(text);
  if (content == workcell::RobotContent::kKinematics && workcell::looksLikeRobot(file) && !workcell::holdsScene(file)) {
    auto robot = workcell::readRobot(file, diagnostics, nullptr, content, arguments);
    HAPTICELL_TRY(robot);
    return std::move(robot->model);
  }
  workcell::EntityLoader loader(".");
  workcell::SourceFile source{file, 1.0};
  source.arguments = arguments;
  const auto entity = loader.loadSource(source, diagnostics);
  HAPTICELL_TRY(entity);
  if (!entity->robot())
    return makeError({.file = file, .found = "it is not a robot", .expected = "a robot file, or library:NAME"});
  return *entity->robot();
}

}  // namespace

Expected<RobotWithTip> readRobotWithTip(const std::string& file, const std::string& tip_name,
                                        workcell::RobotContent content) {
  Diagnostics diagnostics;
  auto model = readModel(file, content, diagnostics);
  for (const Text& sentence : diagnostics.warnings) warn(sentence);
  HAPTICELL_TRY(model);
  RobotWithTip robot{std::move(*model), -1, {}};
  robot.tip = tip_name.empty() ? robot.model.defaultTip() : robot.model.findLink(tip_name);
  if (robot.tip < 0) {
    return makeError({.file = file,
                      .place = "--tip",
                      .found = Text("no link is named '%1'", tip_name),
                      .expected = Text("one of %1", listed(robot.model.links, &kinematics::Link::name))});
  }
  robot.variables = kinematics::variablesOfChain(robot.model, robot.tip);
  return robot;
}

namespace {

struct Carrier {
  kinematics::RobotModel model;
  int link = -1;
  Pose X_LE;
};

Expected<Carrier> readCarrier(const std::string& option, const std::string& text) {
  const auto mounting = parseMounting(option, text);
  HAPTICELL_TRY(mounting);
  auto carrier = readRobotWithTip(mounting->what, mounting->link, workcell::RobotContent::kKinematics);
  HAPTICELL_TRY(carrier);
  if (!kinematics::isMoved(carrier->model, carrier->tip)) {
    const std::string& link = carrier->model.links[static_cast<std::size_t>(carrier->tip)].name;
    return makeError({.file = mounting->what,
                      .place = option,
                      .found = Text("link '%1' does not move", link),
                      .expected = "a link that a joint moves"});
  }
  return Carrier{std::move(carrier->model), carrier->tip, mounting->X_LE};
}

}  // namespace

Expected<void> addExternalAxes(const AxisOptions& options, RobotWithTip& robot) {
  const std::string tip = robot.model.links[static_cast<std::size_t>(robot.tip)].name;
  if (!options.on.empty()) {
    const auto carrier = readCarrier("--on", options.on);
    HAPTICELL_TRY(carrier);
    auto mounted = kinematics::mountRobot(carrier->model, carrier->link, carrier->X_LE, robot.model);
    HAPTICELL_TRY(mounted);
    robot.model = std::move(*mounted);
  }
  if (!options.part_on.empty()) {
    const auto positioner = readCarrier("--part-on", options.part_on);
    HAPTICELL_TRY(positioner);
    const std::string root = positioner->model.links[0].name;
    const auto seen = kinematics::seenFrom(positioner->model, positioner->link);
    HAPTICELL_TRY(seen);
    auto mounted = kinematics::mountRobot(*seen, seen->findLink(root), positioner->X_LE.inverse(), robot.model);
    HAPTICELL_TRY(mounted);
    robot.model = std::move(*mounted);
  }
  robot.tip = robot.model.findLink(tip);
  robot.variables = kinematics::variablesOfChain(robot.model, robot.tip);
  return {};
}

}  // namespace hapticell::cli
