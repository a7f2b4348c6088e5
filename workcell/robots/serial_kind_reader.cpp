// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/serial_kind_reader.h"

#include <cmath>

namespace hapticell::workcell {

void SerialKindReader::readOpw() {
  const toml::table* table = common_.root().table("opw");
  if (!table) return;
  TomlFields fields(*table, "[opw]", common_.error());
  kinematics::OpwParameters p;
  for (const char* key : {"c1", "c2", "c3", "c4"}) fields.require(key);
  fields.read("a1", p.a1, common_.unit());
  fields.read("a2", p.a2, common_.unit());
  fields.read("b", p.b, common_.unit());
  fields.read("c1", p.c1, common_.unit());
  fields.read("c2", p.c2, common_.unit(), 1e-9);
  fields.read("c3", p.c3, common_.unit(), 1e-9);
  fields.read("c4", p.c4, common_.unit());
  std::vector<double> offsets, signs;
  fields.readList("offsets", offsets, kDegree);
  fields.readList("signs", signs);
  if (!common_.error() && fields.has("offsets") && offsets.size() != 6)
    fields.failKey("offsets", Text("%1 offsets", offsets.size()), Text("6, in degrees"));
  for (const double sign : signs) {
    if (!common_.error() && (std::abs(sign) != 1.0 || signs.size() != 6))
      fields.failKey("signs", Text("invalid signs"), Text("six numbers, each 1 or -1"));
  }
  fields.refuseOthers();
  const std::vector<kinematics::JointData> joints = common_.jointData(std::vector<bool>(6, false));
  if (common_.error()) return;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!offsets.empty()) p.offsets[k] = offsets[k];
    if (!signs.empty()) p.signs[k] = signs[k];
  }
  model_ = kinematics::buildOpw(common_.sheet().name, p, joints);
  if (common_.style() == BodyStyle::kOfTheKind || common_.style() == BodyStyle::kArm)
    addArmBody(model_, p, common_.look());
  if (common_.style() == BodyStyle::kCobot) addCobotBody(model_, common_.look());
}

Pose SerialKindReader::readFlange() {
  Pose flange;
  const toml::table* table = common_.root().table("flange");
  if (!table) return flange;
  TomlFields fields(*table, "[flange]", common_.error());
  fields.readPose(flange, common_.unit());
  fields.refuseOthers();
  return flange;
}

void SerialKindReader::addBody() {
  if (common_.error() || common_.style() == BodyStyle::kNone) return;
  if (common_.style() == BodyStyle::kScara) return addScaraBody(model_, common_.look());
  if (common_.style() == BodyStyle::kGantry) return addGantryBody(model_, common_.look());
  addCobotBody(model_, common_.look());
}

void SerialKindReader::readDh() {
  const toml::table* table = common_.root().table("dh");
  if (!table) return;
  TomlFields fields(*table, "[dh]", common_.error());
  int convention = 0;
  fields.require("convention");
  fields.readWord("convention", {"standard", "modified"}, convention);
  std::vector<double> theta, d, a, alpha;
  std::vector<std::string> types;
  fields.require("d");
  fields.require("a");
  fields.require("alpha");
  fields.readList("theta", theta, kDegree);
  fields.readList("d", d, common_.unit());
  fields.readList("a", a, common_.unit());
  fields.readList("alpha", alpha, kDegree);
  fields.readList("types", types);
  if (common_.error()) return;
  const std::size_t n = d.size();
  const bool fits = n > 0 && n <= 16 && a.size() == n && alpha.size() == n && (theta.empty() || theta.size() == n) &&
                    (types.empty() || types.size() == n);
  if (!fits)
    return fields.failKey("d", Text("lists of unequal length"),
                          Text("theta, d, a, alpha and types of one length, 1 to 16"));
  std::vector<kinematics::DhRow> rows;
  std::vector<bool> slides;
  for (std::size_t k = 0; k < n; ++k) {
    if (!types.empty() && types[k] != "revolute" && types[k] != "prismatic")
      return fields.failKey("types", Text("the joint type '%1'", types[k]), Text("revolute or prismatic"));
    slides.push_back(!types.empty() && types[k] == "prismatic");
    rows.push_back({theta.empty() ? 0.0 : theta[k], d[k], a[k], alpha[k], slides.back()});
  }
  fields.refuseOthers();
  const std::vector<kinematics::JointData> joints = common_.jointData(slides);
  const Pose flange = readFlange();
  if (common_.error()) return;
  model_ = kinematics::buildDh(
      common_.sheet().name, convention == 0 ? kinematics::DhConvention::kStandard : kinematics::DhConvention::kModified,
      rows, joints, flange);
  addBody();
}

void SerialKindReader::readChain() {
  const toml::array* list = common_.root().tables("chain");
  if (!list) return;
  std::vector<kinematics::ChainJoint> chain;
  std::vector<bool> slides;
  for (const toml::node& node : *list) {
    kinematics::ChainJoint joint;
    TomlFields fields(*node.as_table(), "[[chain]] " + std::to_string(chain.size() + 1), common_.error());
    int type = 0;
    fields.readWord("type", {"revolute", "prismatic"}, type);
    fields.readPose(joint.X_PJ, common_.unit());
    fields.readPoint("axis", joint.axis_J, 1.0);
    if (!common_.error() && !(glm::length(joint.axis_J) > 1e-9))
      fields.failKey("axis", Text("an axis of length zero"), Text("a direction, such as [0, 0, 1]"));
    fields.refuseOthers();
    if (common_.error()) return;
    joint.axis_J = glm::normalize(joint.axis_J);
    joint.type = type == 1 ? kinematics::JointType::kPrismatic : kinematics::JointType::kRevolute;
    slides.push_back(type == 1);
    chain.push_back(joint);
  }
  if (chain.empty() || chain.size() > 16)
    return common_.root().failKey("chain", Text("%1 joints", chain.size()), Text("%1 to %2", 1, 16));
  const std::vector<kinematics::JointData> joints = common_.jointData(slides);
  const Pose flange = readFlange();
  if (common_.error()) return;
  for (std::size_t k = 0; k < chain.size(); ++k) chain[k].data = joints[k];
  model_ = kinematics::buildChain(common_.sheet().name, chain, flange);
  addBody();
}

}  // namespace hapticell::workcell
