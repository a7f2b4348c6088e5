// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_toml.h"

#include <cmath>

#include "geometry/system/nesting_limit.h"
#include "workcell/robots/robot_toml_reader.h"
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
                      .place = "line " + std::to_string(problem.source().begin.line),
                      .found = "text that is not TOML (" + std::string(problem.description()) + ")",
                      .expected = "a robot.toml"});
  }
}

}  // namespace

Expected<TomlRobot> RobotTomlReader::read() {
  readHead();
  readLook();
  readJoints();
  if (!error_) readKind();
  if (!error_) readTools();
  root_.refuseOthers();
  if (error_) return failed();
  robot_.model.name = robot_.sheet.name;
  return std::move(robot_);
}

Expected<RobotSheet> RobotTomlReader::readSheet() {
  readHead();
  if (error_) return tl::unexpected(failed().error());
  return robot_.sheet;
}

Expected<TomlRobot> RobotTomlReader::failed() {
  error_->file = file_.string();
  return makeError(*error_);
}

void RobotTomlReader::failWith(const Error& cause, const toml::node* at) {
  if (error_) return;
  Error plain = cause;
  plain.fix.clear();
  root_.fail(at, plain.message(), "", cause.fix);
}

void RobotTomlReader::readHead() {
  std::string format;
  double version = 1.0;
  int unit = 0;
  root_.require("format");
  root_.read("format", format);
  if (!error_ && format != "hapticell-robot") {
    root_.failKey("format", "the format \"" + format.substr(0, 60) + "\"", "\"hapticell-robot\"");
  }
  root_.read("version", version, 1.0, 1.0, 1e6);
  if (!error_ && version > 1.0) {
    root_.fail(root_.raw().get("version"), "version " + std::to_string(static_cast<int>(version)),
               "1, the newest that this program knows", "Open it with a newer HaptiCell.");
  }
  root_.require("name");
  root_.read("name", robot_.sheet.name);
  root_.read("maker", robot_.sheet.maker);
  root_.read("kind", robot_.sheet.kind);
  root_.read("source", robot_.sheet.source);
  root_.read("payload", robot_.sheet.payload, 1.0, 0.0, 1e5);
  root_.readWord("unit", {"m", "mm", "in"}, unit);
  unit_ = unit == 0 ? 1.0 : unit == 1 ? 1e-3 : 0.0254;
  root_.read("reach", robot_.sheet.reach, unit_, 0.0, 1e6);
}

void RobotTomlReader::readLook() {
  const toml::table* table = root_.table("look");
  if (!table) return;
  TomlFields look(*table, "[look]", error_);
  look.readColor("color", look_.main);
  look.readColor("second_color", look_.second);
  look.read("bulk", look_.bulk, 1.0, 0.2, 5.0);
  look.read("balanced", look_.balanced);
  look.read("round", look_.round);
  look.readList("side", look_.side, unit_);
  look.readList("radius", look_.radius, unit_);
  look.readWord("style", {"arm", "cobot", "scara", "gantry", "none"}, style_);
  for (const double r : look_.radius) {
    if (!(r > 0.0)) look.failKey("radius", "a radius that is none", "lengths above 0");
  }
  look.refuseOthers();
}

void RobotTomlReader::readJoints() {
  const toml::table* table = root_.table("joints");
  if (!table) return;
  TomlFields joints(*table, "[joints]", error_);
  joints.readList("names", names_);
  joints.readList("lower", lower_);
  joints.readList("upper", upper_);
  joints.readList("velocity", velocity_);
  joints.readList("home", home_);
  joints.refuseOthers();
  joints_node_ = table;
}

std::vector<kinematics::JointData> RobotTomlReader::jointData(const std::vector<bool>& slides) {
  std::vector<JointData> data;
  const std::size_t n = slides.size();
  const auto check = [&](const char* what, std::size_t count, bool needed) {
    if (error_ || count == n || (count == 0 && !needed)) return;
    TomlFields(joints_node_ ? *joints_node_ : root_.raw(), "[joints]", error_)
        .failKey(what, std::to_string(count) + " numbers in " + what, std::to_string(n) + ", one a joint");
  };
  check("lower", lower_.size(), true);
  check("upper", upper_.size(), true);
  check("velocity", velocity_.size(), false);
  check("names", names_.size(), false);
  check("home", home_.size(), false);
  if (error_) return data;
  for (std::size_t k = 0; k < n; ++k) {
    const double unit = slides[k] ? unit_ : kDegree;
    JointData joint{names_.empty() ? "joint_" + std::to_string(k + 1) : names_[k], lower_[k] * unit, upper_[k] * unit,
                    velocity_.empty() ? 0.0 : velocity_[k] * unit};
    if (joint.lower > joint.upper) {
      TomlFields(*joints_node_, "[joints]", error_)
          .failKey("lower", "joint '" + joint.name + "' has its lower limit over the upper", "lower <= upper");
    }
    for (const JointData& other : data) {
      if (other.name == joint.name)
        TomlFields(*joints_node_, "[joints]", error_)
            .failKey("names", "the name '" + joint.name + "' twice", "each name once");
    }
    if (!home_.empty()) rest_.push_back(home_[k] * unit);
    data.push_back(std::move(joint));
  }
  return data;
}

void RobotTomlReader::readKind() {
  static constexpr const char* kKinds[] = {"opw", "dh", "chain", "delta", "hexapod", "urdf"};
  std::vector<std::string> there;
  for (const char* kind : kKinds) {
    if (root_.has(kind)) there.push_back(kind);
  }
  if (there.size() != 1) {
    return root_.fail(
        nullptr, there.empty() ? "no table that says how it moves" : "both [" + there[0] + "] and [" + there[1] + "]",
        "one of [opw], [dh], [[chain]], [delta], [hexapod], [urdf]");
  }
  if (there[0] == "opw") readOpw();
  if (there[0] == "dh") readDh();
  if (there[0] == "chain") readChain();
  if (there[0] == "delta") readDelta();
  if (there[0] == "hexapod") readHexapod();
  if (there[0] == "urdf") readUrdfWithLoops();
  if (!error_ && !robot_.model.closure && !rest_.empty()) robot_.model.home = rest_;
}

void RobotTomlReader::takeModel(Expected<RobotModel> model, const toml::node* at) {
  if (error_) return;
  if (!model) return failWith(model.error(), at);
  robot_.model = std::move(*model);
}

void RobotTomlReader::readTools() {
  const toml::array* list = root_.tables("tool");
  if (!list) return;
  for (const toml::node& node : *list) {
    TomlFields fields(*node.as_table(), "[[tool]] " + std::to_string(robot_.tools.size() + 1), error_);
    ToolFrame tool;
    const int tip = robot_.model.defaultTip();
    tool.tip_link = tip < 0 ? "" : robot_.model.links[static_cast<std::size_t>(tip)].name;
    fields.require("name");
    fields.read("name", tool.name);
    fields.read("link", tool.tip_link);
    fields.readPose(tool.X_LT, unit_);
    if (!error_ && robot_.model.findLink(tool.tip_link) < 0)
      fields.failKey("link", "there is no link '" + tool.tip_link + "'", "the name of a link");
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
