// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/parallel_kind_reader.h"

#include <cmath>

#include "kinematics/closures/delta_robot.h"
#include "kinematics/closures/hexapod_robot.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::workcell {

void ParallelKindReader::readDelta() {
  const toml::table* table = common_.root().table("delta");
  if (!table) return;
  TomlFields fields(*table, "[delta]", common_.error());
  kinematics::DeltaGeometry g;
  kinematics::DeltaOptions options;
  for (const char* key : {"base_radius", "upper_arm", "lower_arm", "platform_radius"}) fields.require(key);
  fields.read("base_radius", g.base_radius, common_.unit(), 1e-9);
  fields.read("upper_arm", g.upper_arm, common_.unit(), 1e-9);
  fields.read("lower_arm", g.lower_arm, common_.unit(), 1e-9);
  fields.read("platform_radius", g.platform_radius, common_.unit(), 1e-9);
  fields.read("rod_spacing", g.rod_spacing, common_.unit(), 0.0);
  fields.read("first_angle", g.first_angle, kDegree);
  fields.read("upward", g.upward);
  fields.read("ball_limit", options.ball_limit, kDegree, 1.0, 90.0);
  fields.read("tool_length", options.tool_length, common_.unit(), 0.0);
  fields.refuseOthers();
  const std::vector<kinematics::JointData> joints =
      common_.jointData(std::vector<bool>(common_.jointCount() == 4 ? 4 : 3, false));
  if (common_.error()) return;
  takeModel(kinematics::buildDelta(common_.sheet().name, g, options, joints, common_.rest()), table);
  if (!common_.error() && common_.style() != BodyStyle::kNone)
    addDeltaBody(model_, g, options.tool_length, common_.look());
}

void ParallelKindReader::readHexapod() {
  const toml::table* table = common_.root().table("hexapod");
  if (!table) return;
  TomlFields fields(*table, "[hexapod]", common_.error());
  kinematics::HexapodGeometry g;
  kinematics::HexapodOptions options;
  std::vector<std::vector<double>> base, platform;
  fields.require("base");
  fields.require("platform");
  fields.require("home");
  fields.readRows("base", 3, base);
  fields.readRows("platform", 3, platform);
  if (const toml::table* home = fields.table("home")) {
    TomlFields pose(*home, "[hexapod.home]", common_.error());
    pose.readPose(options.X_BPHome, common_.unit());
    pose.refuseOthers();
  }
  fields.read("swivel_limit", options.swivel_limit, kDegree, 1.0, 180.0);
  fields.read("tool_length", options.tool_length, common_.unit(), 0.0);
  if (!common_.error() && (base.size() != 6 || platform.size() != 6))
    fields.failKey("base", Text("%1 and %2 joints", base.size(), platform.size()),
                   Text("6 on the base and 6 on the platform"));
  fields.refuseOthers();
  const std::vector<kinematics::JointData> joints = common_.jointData(std::vector<bool>(6, true));
  if (common_.error()) return;
  for (std::size_t i = 0; i < 6; ++i) {
    g.p_BA[i] = common_.unit() * dvec3(base[i][0], base[i][1], base[i][2]);
    g.p_PC[i] = common_.unit() * dvec3(platform[i][0], platform[i][1], platform[i][2]);
  }
  takeModel(kinematics::buildHexapod(common_.sheet().name, g, options, joints), table);
  if (!common_.error() && common_.style() != BodyStyle::kNone)
    addHexapodBody(model_, g, options.tool_length, common_.look());
}

void ParallelKindReader::readUrdfWithLoops() {
  const toml::table* table = common_.root().table("urdf");
  if (!table) return;
  TomlFields fields(*table, "[urdf]", common_.error());
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
        return fields.fail(&node, Text("the start value of joint '%1' is not a number", key.str()),
                           Text("degrees or a length"));
      options.start.emplace_back(std::string(key.str()), *value);
    }
  }
  fields.refuseOthers();
  if (common_.error()) return;
  auto tree = readUrdf(common_.file().parent_path() / urdf, diagnostics_);
  if (!tree) return common_.failWith(tree.error(), table->get("file"));
  for (const std::string& name : locked) lock(*tree, name, fields);
  for (auto& [name, value] : options.start) {
    const int joint = tree->findJoint(name);
    const bool slides =
        joint >= 0 && tree->joints[static_cast<std::size_t>(joint)].type == kinematics::JointType::kPrismatic;
    value *= slides ? common_.unit() : kDegree;
  }
  std::vector<kinematics::LoopConstraint> loops;
  readLoops(*tree, loops);
  if (common_.error()) return;
  if (!loops.empty()) {
    if (auto closed = kinematics::LoopClosure::close(*tree, std::move(loops), options); !closed)
      return common_.failWith(closed.error(), table);
  }
  if (!tip.empty()) {
    tree->tip = tree->findLink(tip);
    if (tree->tip < 0) return fields.failKey("tip", Text("no link is named '%1'", tip), Text("the name of a link"));
  }
  model_ = std::move(*tree);
}

void ParallelKindReader::lock(kinematics::RobotModel& model, const std::string& name, TomlFields& fields) {
  const int index = model.findJoint(name);
  if (index < 0) return fields.failKey("locked", Text("no joint is named '%1'", name), Text("an existing name"));
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

void ParallelKindReader::readLoops(const kinematics::RobotModel& tree, std::vector<kinematics::LoopConstraint>& loops) {
  const toml::array* list = common_.root().tables("loop");
  if (!list) return;
  for (const toml::node& node : *list) {
    kinematics::LoopConstraint loop;
    const std::string section = "[[loop]] " + std::to_string(loops.size() + 1);
    TomlFields fields(*node.as_table(), section, common_.error());
    int kind = 0;
    fields.require("a");
    fields.require("b");
    fields.readWord("joint", {"ball", "hinge", "fixed"}, kind);
    loop.kind = static_cast<kinematics::LoopConstraint::Kind>(kind);
    loop.name = section;
    readEnd(tree, fields, "a", loop.link_a, loop.X_AC);
    readEnd(tree, fields, "b", loop.link_b, loop.X_BC);
    fields.refuseOthers();
    if (common_.error()) return;
    loops.push_back(std::move(loop));
  }
}

void ParallelKindReader::readEnd(const kinematics::RobotModel& tree, TomlFields& fields, const char* key, int& link,
                                 Pose& X) {
  const toml::table* table = fields.table(key);
  if (!table) return;
  TomlFields end(*table, fields.section() + ", " + key, common_.error());
  std::string name;
  end.require("link");
  end.read("link", name);
  end.readPose(X, common_.unit());
  link = tree.findLink(name);
  if (!common_.error() && link < 0)
    end.failKey("link", Text("no link is named '%1'", name), Text("the name of a link of the URDF"));
  end.refuseOthers();
}

void ParallelKindReader::takeModel(Expected<kinematics::RobotModel> model, const toml::node* at) {
  if (common_.error()) return;
  if (!model) return common_.failWith(model.error(), at);
  model_ = std::move(*model);
}

}  // namespace hapticell::workcell
