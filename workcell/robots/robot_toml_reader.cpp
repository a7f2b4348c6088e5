// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_toml_reader.h"

#include "geometry/system/nesting_limit.h"
#include "workcell/robots/parallel_kind_reader.h"
#include "workcell/robots/serial_kind_reader.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

Expected<toml::table> parse(const fs::path& path) {
  const Expected<std::string> text = readFileContent(path);
  HAPTICELL_TRY(text);
  auto flat = geometry::checkNesting(*text, geometry::NestedText::kToml, path.string());
  HAPTICELL_TRY(flat);
  try {
    return toml::parse(*text);
  } catch (const toml::parse_error& problem) {
    return makeError({.file = path.string(),
                      .place = Text("line %1", problem.source().begin.line),
                      .found = Text("text that is not TOML (%1)", problem.description()),
                      .expected = "a robot.toml"});
  }
}

}  // namespace

Expected<TomlRobot> RobotTomlReader::read() {
  common_.readHead();
  common_.readLook();
  common_.readJoints();
  if (!common_.error()) readKind();
  if (!common_.error()) readTools();
  common_.root().refuseOthers();
  if (common_.error()) return makeError(common_.failure());
  robot_.sheet = common_.sheet();
  robot_.model.name = robot_.sheet.name;
  return std::move(robot_);
}

Expected<RobotSheet> RobotTomlReader::readSheet() {
  common_.readHead();
  if (common_.error()) return makeError(common_.failure());
  return common_.sheet();
}

void RobotTomlReader::readKind() {
  static constexpr const char* kKinds[] = {"opw", "dh", "chain", "delta", "hexapod", "urdf"};
  std::vector<std::string> there;
  for (const char* kind : kKinds) {
    if (common_.root().has(kind)) there.push_back(kind);
  }
  if (there.size() != 1) {
    return common_.root().fail(
        nullptr,
        there.empty() ? Text("no table defines how the robot moves") : Text("both [%1] and [%2]", there[0], there[1]),
        Text("one of [opw], [dh], [[chain]], [delta], [hexapod], [urdf]"));
  }
  const std::string& kind = there[0];
  SerialKindReader serial(common_, robot_.model);
  ParallelKindReader parallel(common_, robot_.model, diagnostics_);
  if (kind == "opw") serial.readOpw();
  if (kind == "dh") serial.readDh();
  if (kind == "chain") serial.readChain();
  if (kind == "delta") parallel.readDelta();
  if (kind == "hexapod") parallel.readHexapod();
  if (kind == "urdf") parallel.readUrdfWithLoops();
  if (!common_.error() && !robot_.model.closure && !common_.rest().empty()) robot_.model.home = common_.rest();
}

void RobotTomlReader::readTools() {
  const toml::array* list = common_.root().tables("tool");
  if (!list) return;
  for (const toml::node& node : *list) {
    TomlFields fields(*node.as_table(), "[[tool]] " + std::to_string(robot_.tools.size() + 1), common_.error());
    ToolFrame tool;
    const int tip = robot_.model.defaultTip();
    tool.tip_link = tip < 0 ? "" : robot_.model.links[static_cast<std::size_t>(tip)].name;
    fields.require("name");
    fields.read("name", tool.name);
    fields.read("link", tool.tip_link);
    fields.readPose(tool.X_LT, common_.unit());
    if (!common_.error() && robot_.model.findLink(tool.tip_link) < 0)
      fields.failKey("link", Text("no link is named '%1'", tool.tip_link), Text("the name of a link"));
    fields.refuseOthers();
    robot_.tools.push_back(std::move(tool));
  }
}

Expected<TomlRobot> readRobotToml(const fs::path& path, Diagnostics& diagnostics) {
  const auto root = parse(path);
  HAPTICELL_TRY(root);
  return RobotTomlReader(*root, path, diagnostics).read();
}

Expected<RobotSheet> readRobotSheet(const fs::path& path) {
  const auto root = parse(path);
  HAPTICELL_TRY(root);
  Diagnostics ignored;
  return RobotTomlReader(*root, path, ignored).readSheet();
}

}  // namespace hapticell::workcell
