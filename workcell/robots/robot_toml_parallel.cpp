// SPDX-License-Identifier: Apache-2.0
// Kinds of a robot.toml with closed loops: Delta, hexapod, a URDF with its loops.
#include <cmath>

#include "kinematics/closures/delta_robot.h"
#include "kinematics/closures/hexapod_robot.h"
#include "kinematics/closures/loop_closure.h"
#include "workcell/robots/robot_toml_reader.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::workcell {

void RobotTomlReader::readDelta() {
  const toml::table* table = root_.table("delta");
  if (!table) return;
  TomlFields fields(*table, "[delta]", error_);
  kinematics::DeltaGeometry g;
  kinematics::DeltaOptions options;
  for (const char* key : {"base_radius", "upper_arm", "lower_arm", "platform_radius"}) fields.require(key);
  fields.read("base_radius", g.base_radius, unit_, 1e-9);
  fields.read("upper_arm", g.upper_arm, unit_, 1e-9);
  fields.read("lower_arm", g.lower_arm, unit_, 1e-9);
  fields.read("platform_radius", g.platform_radius, unit_, 1e-9);
  fields.read("rod_spacing", g.rod_spacing, unit_, 0.0);
  fields.read("first_angle", g.first_angle, kDegree);
  fields.read("upward", g.upward);
  fields.read("ball_limit", options.ball_limit, kDegree, 1.0, 90.0);
  fields.read("tool_length", options.tool_length, unit_, 0.0);
  fields.refuseOthers();
  const std::vector<JointData> joints = jointData(std::vector<bool>(lower_.size() == 4 ? 4 : 3, false));
  if (error_) return;
  takeModel(kinematics::buildDelta(robot_.sheet.name, g, options, joints, rest_), table);
  if (!error_ && style_ != 4) addDeltaBody(robot_.model, g, options.tool_length, look_);
}

void RobotTomlReader::readHexapod() {
  const toml::table* table = root_.table("hexapod");
  if (!table) return;
  TomlFields fields(*table, "[hexapod]", error_);
  kinematics::HexapodGeometry g;
  kinematics::HexapodOptions options;
  std::vector<std::vector<double>> base, platform;
  fields.require("base");
  fields.require("platform");
  fields.require("home");
  fields.readRows("base", 3, base);
  fields.readRows("platform", 3, platform);
  if (const toml::table* home = fields.table("home")) {
    TomlFields pose(*home, "[hexapod.home]", error_);
    pose.readPose(options.X_BPHome, unit_);
    pose.refuseOthers();
  }
  fields.read("swivel_limit", options.swivel_limit, kDegree, 1.0, 180.0);
  fields.read("tool_length", options.tool_length, unit_, 0.0);
  if (!error_ && (base.size() != 6 || platform.size() != 6))
    fields.failKey("base", std::to_string(base.size()) + " and " + std::to_string(platform.size()) + " hinges",
                   "6 on the base and 6 on the platform");
  fields.refuseOthers();
  const std::vector<JointData> joints = jointData(std::vector<bool>(6, true));
  if (error_) return;
  for (std::size_t i = 0; i < 6; ++i) {
    g.p_BA[i] = unit_ * dvec3(base[i][0], base[i][1], base[i][2]);
    g.p_PC[i] = unit_ * dvec3(platform[i][0], platform[i][1], platform[i][2]);
  }
  takeModel(kinematics::buildHexapod(robot_.sheet.name, g, options, joints), table);
  if (!error_ && style_ != 4) addHexapodBody(robot_.model, g, options.tool_length, look_);
}

void RobotTomlReader::readUrdfWithLoops() {
  const toml::table* table = root_.table("urdf");
  if (!table) return;
  TomlFields fields(*table, "[urdf]", error_);
  std::string urdf, tip;
  kinematics::LoopOptions options;
  fields.require("file");
  fields.read("file", urdf);
  fields.readList("actuated", options.actuated);
  fields.read("tip", tip);
  std::vector<std::string> locked;
  fields.readList("locked", locked);
  if (const toml::table* start = fields.table("start")) {
    for (const auto& [key, node] : *start) {
      const auto value = node.is_number() ? node.value<double>() : std::nullopt;
      if (!value || !std::isfinite(*value))
        return fields.fail(&node, "the start of joint '" + std::string(key.str()) + "' is no number",
                           "degrees, or a length");
      options.start.emplace_back(std::string(key.str()), *value);
    }
  }
  fields.refuseOthers();
  if (error_) return;
  auto tree = readUrdf(file_.parent_path() / urdf, diagnostics_);
  if (!tree) return failWith(tree.error(), table->get("file"));
  for (const std::string& name : locked) lock(*tree, name, fields);
  for (auto& [name, value] : options.start) {
    const int joint = tree->findJoint(name);
    const bool slides =
        joint >= 0 && tree->joints[static_cast<std::size_t>(joint)].type == kinematics::JointType::kPrismatic;
    value *= slides ? unit_ : kDegree;
  }
  std::vector<kinematics::LoopConstraint> loops;
  readLoops(*tree, loops);
  if (error_) return;
  if (!loops.empty()) {
    if (auto closed = kinematics::LoopClosure::close(*tree, std::move(loops), options); !closed)
      return failWith(closed.error(), table);
  }
  if (!tip.empty()) {
    tree->tip = tree->findLink(tip);
    if (tree->tip < 0) return fields.failKey("tip", "there is no link '" + tip + "'", "the name of a link");
  }
  robot_.model = std::move(*tree);
}

void RobotTomlReader::lock(RobotModel& model, const std::string& name, TomlFields& fields) {
  const int index = model.findJoint(name);
  if (index < 0) return fields.failKey("locked", "there is no joint '" + name + "'", "the name of one");
  model.joints[static_cast<std::size_t>(index)].type = kinematics::JointType::kFixed;
  std::vector<int> moving;
  for (const int joint : model.moving) {
    if (joint != index) moving.push_back(joint);
  }
  model.moving = std::move(moving);
  for (kinematics::Joint& joint : model.joints) joint.variable = -1;
  for (std::size_t k = 0; k < model.moving.size(); ++k) {
    model.joints[static_cast<std::size_t>(model.moving[k])].variable = static_cast<int>(k);
  }
}

void RobotTomlReader::readLoops(const RobotModel& tree, std::vector<kinematics::LoopConstraint>& loops) {
  const toml::array* list = root_.tables("loop");
  if (!list) return;
  for (const toml::node& node : *list) {
    kinematics::LoopConstraint loop;
    const std::string section = "[[loop]] " + std::to_string(loops.size() + 1);
    TomlFields fields(*node.as_table(), section, error_);
    int kind = 0;
    fields.require("a");
    fields.require("b");
    fields.readWord("joint", {"ball", "hinge", "fixed"}, kind);
    loop.kind = static_cast<kinematics::LoopConstraint::Kind>(kind);
    loop.name = section;
    readEnd(tree, fields, "a", loop.link_a, loop.X_AC);
    readEnd(tree, fields, "b", loop.link_b, loop.X_BC);
    fields.refuseOthers();
    if (error_) return;
    loops.push_back(std::move(loop));
  }
}

void RobotTomlReader::readEnd(const RobotModel& tree, TomlFields& fields, const char* key, int& link, Pose& X) {
  const toml::table* table = fields.table(key);
  if (!table) return;
  TomlFields end(*table, fields.section() + ", " + key, error_);
  std::string name;
  end.require("link");
  end.read("link", name);
  end.readPose(X, unit_);
  link = tree.findLink(name);
  if (!error_ && link < 0) end.failKey("link", "there is no link '" + name + "'", "the name of a link of the URDF");
  end.refuseOthers();
}

}  // namespace hapticell::workcell
