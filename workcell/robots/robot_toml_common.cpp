// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_toml_common.h"

#include <array>
#include <utility>

namespace hapticell::workcell {

using kinematics::JointData;

void RobotTomlCommon::readHead() {
  std::string format;
  double version = 1.0;
  int unit = 0;
  root_.require("format");
  root_.read("format", format);
  if (!error_ && format != "hapticell-robot") {
    root_.failKey("format", Text("the format \"%1\"", format.substr(0, 60)), "\"hapticell-robot\"");
  }
  root_.read("version", version, 1.0, 1.0, 1e6);
  if (!error_ && version > 1.0) {
    root_.fail(root_.raw().get("version"), Text("version %1", static_cast<int>(version)),
               Text("1, the newest version that this program can read"), Text("Open it with a newer HaptiCell."));
  }
  root_.require("name");
  root_.read("name", sheet_.name);
  root_.read("maker", sheet_.maker);
  root_.read("kind", sheet_.kind);
  root_.read("source", sheet_.source);
  root_.read("payload", sheet_.payload, 1.0, 0.0, 1e5);
  root_.readWord("unit", {"m", "mm", "in"}, unit);
  static constexpr std::array<double, 3> kMetres = {1.0, 1e-3, 0.0254};
  unit_ = kMetres.at(static_cast<std::size_t>(unit));
  root_.read("reach", sheet_.reach, unit_, 0.0, 1e6);
}

void RobotTomlCommon::readLook() {
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
  int style = -1;
  look.readWord("style", {"arm", "cobot", "scara", "gantry", "none"}, style);
  style_ = static_cast<BodyStyle>(style + 1);
  for (const double r : look_.radius) {
    if (!(r > 0.0)) look.failKey("radius", Text("an invalid radius"), Text("lengths above 0"));
  }
  look.refuseOthers();
}

void RobotTomlCommon::readJoints() {
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

std::vector<JointData> RobotTomlCommon::jointData(const std::vector<bool>& slides) {
  std::vector<JointData> data;
  const std::size_t n = slides.size();
  const auto check = [&](const char* what, std::size_t count, bool needed) {
    if (error_ || count == n || (count == 0 && !needed)) return;
    TomlFields(joints_node_ ? *joints_node_ : root_.raw(), "[joints]", error_)
        .failKey(what, Text("%1 numbers in %2", count, what), Text("%1, one per joint", n));
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
          .failKey("lower", Text("joint '%1' has a lower limit above its upper limit", joint.name), "lower <= upper");
    }
    for (const JointData& other : data) {
      if (other.name == joint.name)
        TomlFields(*joints_node_, "[joints]", error_)
            .failKey("names", Text("the name '%1' twice", joint.name), Text("each name once"));
    }
    if (!home_.empty()) rest_.push_back(home_[k] * unit);
    data.push_back(std::move(joint));
  }
  return data;
}

void RobotTomlCommon::failWith(const Error& cause, const toml::node* at) {
  if (error_) return;
  Error plain = cause;
  plain.fix = {};
  root_.fail(at, plain.text(), {}, cause.fix);
}

Error RobotTomlCommon::failure() const {
  Error error = *error_;
  error.file = file_.string();
  return error;
}

}  // namespace hapticell::workcell
