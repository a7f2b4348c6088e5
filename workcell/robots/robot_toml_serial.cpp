// SPDX-License-Identifier: Apache-2.0
// Serial kinds of a robot.toml: OPW parameters, Denavit-Hartenberg tables, chains of frames.
#include <cmath>

#include "kinematics/closures/arm_builder.h"
#include "workcell/robots/robot_toml_reader.h"

namespace hapticell::workcell {

void RobotTomlReader::readOpw() {
  const toml::table* table = root_.table("opw");
  if (!table) return;
  TomlFields fields(*table, "[opw]", error_);
  kinematics::OpwParameters p;
  for (const char* key : {"c1", "c2", "c3", "c4"}) fields.require(key);
  fields.read("a1", p.a1, unit_);
  fields.read("a2", p.a2, unit_);
  fields.read("b", p.b, unit_);
  fields.read("c1", p.c1, unit_);
  fields.read("c2", p.c2, unit_, 1e-9);
  fields.read("c3", p.c3, unit_, 1e-9);
  fields.read("c4", p.c4, unit_);
  std::vector<double> offsets, signs;
  fields.readList("offsets", offsets, kDegree);
  fields.readList("signs", signs);
  if (!error_ && fields.has("offsets") && offsets.size() != 6)
    fields.failKey("offsets", std::to_string(offsets.size()) + " offsets", "6, in degrees");
  for (const double sign : signs) {
    if (!error_ && (std::abs(sign) != 1.0 || signs.size() != 6))
      fields.failKey("signs", "signs that are none", "six times 1 or -1");
  }
  fields.refuseOthers();
  const std::vector<JointData> joints = jointData(std::vector<bool>(6, false));
  if (error_) return;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!offsets.empty()) p.offsets[k] = offsets[k];
    if (!signs.empty()) p.signs[k] = signs[k];
  }
  robot_.model = kinematics::buildOpw(robot_.sheet.name, p, joints);
  if (style_ < 0 || style_ == 0) addArmBody(robot_.model, p, look_);
  if (style_ == 1) addCobotBody(robot_.model, look_);
}

Pose RobotTomlReader::readFlange() {
  Pose flange;
  const toml::table* table = root_.table("flange");
  if (!table) return flange;
  TomlFields fields(*table, "[flange]", error_);
  fields.readPose(flange, unit_);
  fields.refuseOthers();
  return flange;
}

void RobotTomlReader::addChainBody() {
  if (error_ || style_ == 4) return;
  if (style_ == 2) return addScaraBody(robot_.model, look_);
  if (style_ == 3) return addGantryBody(robot_.model, look_);
  addCobotBody(robot_.model, look_);
}

void RobotTomlReader::readDh() {
  const toml::table* table = root_.table("dh");
  if (!table) return;
  TomlFields fields(*table, "[dh]", error_);
  int convention = 0;
  fields.require("convention");
  fields.readWord("convention", {"standard", "modified"}, convention);
  std::vector<double> theta, d, a, alpha;
  std::vector<std::string> types;
  fields.require("d");
  fields.require("a");
  fields.require("alpha");
  fields.readList("theta", theta, kDegree);
  fields.readList("d", d, unit_);
  fields.readList("a", a, unit_);
  fields.readList("alpha", alpha, kDegree);
  fields.readList("types", types);
  if (error_) return;
  const std::size_t n = d.size();
  const bool fits = n > 0 && n <= 16 && a.size() == n && alpha.size() == n && (theta.empty() || theta.size() == n) &&
                    (types.empty() || types.size() == n);
  if (!fits)
    return fields.failKey("d", "lists of unequal length", "theta, d, a, alpha and types of one length, 1 to 16");
  std::vector<kinematics::DhRow> rows;
  std::vector<bool> slides;
  for (std::size_t k = 0; k < n; ++k) {
    if (!types.empty() && types[k] != "revolute" && types[k] != "prismatic")
      return fields.failKey("types", "the joint type '" + types[k] + "'", "revolute or prismatic");
    slides.push_back(!types.empty() && types[k] == "prismatic");
    rows.push_back({theta.empty() ? 0.0 : theta[k], d[k], a[k], alpha[k], slides.back()});
  }
  fields.refuseOthers();
  const std::vector<JointData> joints = jointData(slides);
  const Pose flange = readFlange();
  if (error_) return;
  robot_.model = kinematics::buildDh(
      robot_.sheet.name, convention == 0 ? kinematics::DhConvention::kStandard : kinematics::DhConvention::kModified,
      rows, joints, flange);
  addChainBody();
}

void RobotTomlReader::readChain() {
  const toml::array* list = root_.tables("chain");
  if (!list) return;
  std::vector<kinematics::ChainJoint> chain;
  std::vector<bool> slides;
  for (const toml::node& node : *list) {
    kinematics::ChainJoint joint;
    TomlFields fields(*node.as_table(), "[[chain]] " + std::to_string(chain.size() + 1), error_);
    int type = 0;
    fields.readWord("type", {"revolute", "prismatic"}, type);
    fields.readPose(joint.X_PJ, unit_);
    fields.readPoint("axis", joint.axis_J, 1.0);
    if (!error_ && !(glm::length(joint.axis_J) > 1e-9))
      fields.failKey("axis", "an axis of length zero", "a direction, such as [0, 0, 1]");
    fields.refuseOthers();
    if (error_) return;
    joint.axis_J = glm::normalize(joint.axis_J);
    joint.type = type == 1 ? kinematics::JointType::kPrismatic : kinematics::JointType::kRevolute;
    slides.push_back(type == 1);
    chain.push_back(joint);
  }
  if (chain.empty() || chain.size() > 16)
    return root_.failKey("chain", std::to_string(chain.size()) + " joints", "1 to 16");
  const std::vector<JointData> joints = jointData(slides);
  const Pose flange = readFlange();
  if (error_) return;
  for (std::size_t k = 0; k < chain.size(); ++k) chain[k].data = joints[k];
  robot_.model = kinematics::buildChain(robot_.sheet.name, chain, flange);
  addChainBody();
}

}  // namespace hapticell::workcell
