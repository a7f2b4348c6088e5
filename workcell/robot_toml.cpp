// SPDX-License-Identifier: Apache-2.0
#include "workcell/robot_toml.h"

#include <cmath>
#include <limits>

#include "kinematics/delta_robot.h"
#include "kinematics/hexapod_robot.h"
#include "kinematics/loop_closure.h"
#include "workcell/file_content.h"
#include "workcell/robot_body.h"
#include "workcell/toml_fields.h"
#include "workcell/urdf_reader.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

using kinematics::JointData;
using kinematics::RobotModel;

constexpr double kDegree = M_PI / 180.0;

/// What the file's tables have in common.
class RobotReader {
 public:
  RobotReader(const toml::table& root, fs::path file, Diagnostics& diagnostics)
      : root_(root, "", error_), file_(std::move(file)), diagnostics_(diagnostics) {}

  Expected<TomlRobot> read() {
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

  Expected<RobotSheet> readSheet() {
    readHead();
    if (error_) return tl::unexpected(failed().error());
    return robot_.sheet;
  }

 private:
  Expected<TomlRobot> failed() {
    error_->file = file_.string();
    return makeError(*error_);
  }

  void failWith(const Error& cause, const toml::node* at) {
    if (error_) return;
    Error plain = cause;
    plain.fix.clear();
    root_.fail(at, plain.message(), "", cause.fix);
  }

  void readHead() {
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

  void readLook() {
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

  /// Limits and speeds in degrees, or in the unit of lengths where the joint slides.
  void readJoints() {
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

  /// As many joints as the kind has; `slides[k]` tells the unit of joint k.
  std::vector<JointData> jointData(const std::vector<bool>& slides) {
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

  void readKind() {
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

  void takeModel(Expected<RobotModel> model, const toml::node* at) {
    if (error_) return;
    if (!model) return failWith(model.error(), at);
    robot_.model = std::move(*model);
  }

  void readOpw() {
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

  Pose readFlange() {
    Pose flange;
    const toml::table* table = root_.table("flange");
    if (!table) return flange;
    TomlFields fields(*table, "[flange]", error_);
    fields.readPose(flange, unit_);
    fields.refuseOthers();
    return flange;
  }

  void addChainBody() {
    if (error_ || style_ == 4) return;
    if (style_ == 2) return addScaraBody(robot_.model, look_);
    if (style_ == 3) return addGantryBody(robot_.model, look_);
    addCobotBody(robot_.model, look_);
  }

  void readDh() {
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

  void readChain() {
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

  void readDelta() {
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

  void readHexapod() {
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

  void readUrdfWithLoops() {
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

  /// A moving joint becomes a fixed one.
  void lock(RobotModel& model, const std::string& name, TomlFields& fields) {
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

  void readLoops(const RobotModel& tree, std::vector<kinematics::LoopConstraint>& loops) {
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

  void readEnd(const RobotModel& tree, TomlFields& fields, const char* key, int& link, Pose& X) {
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

  void readTools() {
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

  std::optional<Error> error_;
  TomlFields root_;
  fs::path file_;
  Diagnostics& diagnostics_;
  TomlRobot robot_;
  RobotLook look_;
  int style_ = -1;  // Not said.
  double unit_ = 1.0;
  std::vector<std::string> names_;
  std::vector<double> lower_, upper_, velocity_, home_, rest_;
  const toml::table* joints_node_ = nullptr;
};

Expected<toml::table> parse(const fs::path& path) {
  const Expected<std::string> text = readFileContent(path);
  if (!text) return makeError(text.error());
  try {
    return toml::parse(*text);
  } catch (const toml::parse_error& problem) {
    return makeError({path.string(), "line " + std::to_string(problem.source().begin.line),
                      "text that is not TOML (" + std::string(problem.description()) + ")", "a robot.toml", ""});
  }
}

}  // namespace

Expected<TomlRobot> readRobotToml(const fs::path& path, Diagnostics& diagnostics) {
  const auto root = parse(path);
  if (!root) return makeError(root.error());
  return RobotReader(*root, path, diagnostics).read();
}

Expected<RobotSheet> readRobotSheet(const fs::path& path) {
  const auto root = parse(path);
  if (!root) return makeError(root.error());
  Diagnostics ignored;
  return RobotReader(*root, path, ignored).readSheet();
}

}  // namespace hapticell::workcell
