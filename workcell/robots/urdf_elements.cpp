// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_elements.h"

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "workcell/robots/urdf_lines.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

using kinematics::JointType;

constexpr double kEndless = std::numeric_limits<double>::infinity();
// SDF writes 1e16 for no limit. Half, twice: no effect.
constexpr double kBeyondAnyLimit = 1e15;

std::string attributeOf(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

/// The numbers in a text, between blanks or commas with a blank behind ("0, 0, 1"); empty if one is not a number. "inf"
/// and "nan" are numbers here.
std::optional<std::vector<double>> urdfNumbers(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word.size() > 1 && word.back() == ',') word.pop_back();
    const std::optional<double> value = parseNumber(word);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

/// `count` finite numbers, or `otherwise` where the attribute is not there or empty.
Expected<std::vector<double>> readNumbers(const TiXmlElement& element, const char* attribute,
                                          std::vector<double> otherwise, const UrdfLines& lines) {
  const std::string text = attributeOf(element, attribute);
  const auto numbers = urdfNumbers(text);
  if (numbers && numbers->empty()) return otherwise;
  const bool finite =
      numbers && std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); });
  if (finite && numbers->size() == otherwise.size()) return *numbers;
  return lines.refuse(element.Row(), Text("<%1> has %2=\"%3\"", element.ValueStr(), attribute, text.substr(0, 200)),
                      otherwise.size() == 1 ? Text("a finite number") : Text("%1 finite numbers", otherwise.size()));
}

/// Turns about the fixed x, y and z axes, in this order (REP 103).
dquat fromRollPitchYaw(double roll, double pitch, double yaw) {
  const double sr = std::sin(roll / 2.0), cr = std::cos(roll / 2.0), sp = std::sin(pitch / 2.0),
               cp = std::cos(pitch / 2.0), sy = std::sin(yaw / 2.0), cy = std::cos(yaw / 2.0);
  return glm::normalize(dquat(cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
                              cr * cp * sy - sr * sp * cy));
}

Expected<Pose> readOrigin(const TiXmlElement& element, const UrdfLines& lines) {
  const TiXmlElement* origin = element.FirstChildElement("origin");
  if (!origin) return Pose();
  const auto xyz = readNumbers(*origin, "xyz", {0.0, 0.0, 0.0}, lines),
             rpy = readNumbers(*origin, "rpy", {0.0, 0.0, 0.0}, lines);
  HAPTICELL_TRY(xyz);
  HAPTICELL_TRY(rpy);
  const Pose pose{{(*xyz)[0], (*xyz)[1], (*xyz)[2]}, fromRollPitchYaw((*rpy)[0], (*rpy)[1], (*rpy)[2])};
  if (!pose.isValid())
    return lines.refuse(origin->Row(), Text("an invalid origin (\"%1\")", attributeOf(*origin, "xyz")),
                        Text("a finite pose within 1e12 m"));
  return pose;
}

/// Three or four numbers from 0 to 1; never a reason to refuse a robot.
std::optional<std::array<float, 4>> readColor(const TiXmlElement& color, const UrdfLines& lines,
                                              Diagnostics& diagnostics) {
  const std::string text = attributeOf(color, "rgba");
  const auto numbers = urdfNumbers(text);
  const bool finite =
      numbers && std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); });
  if (!finite || numbers->size() < 3 || numbers->size() > 4) {
    diagnostics.warn(Text("%1: the color rgba=\"%2\" is not four numbers; the shapes are shown grey",
                          lines.words(color.Row()), text.substr(0, 100)));
    return std::nullopt;
  }
  std::array<float, 4> channels{0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t i = 0; i < numbers->size(); ++i)
    channels[i] = static_cast<float>(std::clamp((*numbers)[i], 0.0, 1.0));
  return channels;
}

/// One length of a shape; nothing where it is not written as a number.
std::optional<double> readLength(const TiXmlElement& element, const char* attribute) {
  const auto numbers = urdfNumbers(attributeOf(element, attribute));
  return numbers && numbers->size() == 1 && !std::isnan(numbers->front()) ? std::optional(numbers->front())
                                                                          : std::nullopt;
}

/// Makes a shape of lengths: all positive it is one, zero it is a placeholder, else it is invalid.
void judgeLengths(UrdfShape& shape, UrdfShape::Kind kind, const std::string& name,
                  const std::vector<std::optional<double>>& lengths) {
  const auto any = [&lengths](auto test) { return std::any_of(lengths.begin(), lengths.end(), test); };
  if (any([](const auto& length) { return !length || !std::isfinite(*length) || *length < 0.0; })) {
    shape.reason = Text("a %1 with a size that is not a number above 0", name);
  } else if (any([](const auto& length) { return *length == 0.0; })) {
    shape.kind = UrdfShape::Kind::kEmpty;
    shape.reason = Text("a %1 of size zero", name);
  } else {
    shape.kind = kind;
  }
}

void readGeometry(const TiXmlElement& geometry, UrdfShape& shape) {
  const TiXmlElement* element = geometry.FirstChildElement();
  if (!element) {
    shape.reason = Text("an empty <geometry>");
    return;
  }
  const std::string& name = element->ValueStr();
  const auto length = [element](const char* attribute) { return readLength(*element, attribute); };
  if (name == "box") {
    const auto numbers = urdfNumbers(attributeOf(*element, "size"));
    if (!numbers || numbers->size() != 3) {
      shape.reason = Text("a box with a size that is not three numbers");
      return;
    }
    shape.size = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    judgeLengths(shape, UrdfShape::Kind::kBox, "box", {(*numbers)[0], (*numbers)[1], (*numbers)[2]});
  } else if (name == "cylinder" || name == "capsule") {
    shape.radius = length("radius").value_or(0.0);
    shape.length = length("length").value_or(0.0);
    judgeLengths(shape, name == "cylinder" ? UrdfShape::Kind::kCylinder : UrdfShape::Kind::kCapsule, name,
                 {length("radius"), length("length")});
  } else if (name == "sphere") {
    shape.radius = length("radius").value_or(0.0);
    judgeLengths(shape, UrdfShape::Kind::kSphere, name, {length("radius")});
  } else if (name == "mesh") {
    shape.mesh = attributeOf(*element, "filename");
    const std::string scale = attributeOf(*element, "scale");
    const auto numbers = urdfNumbers(scale.empty() ? "1 1 1" : scale);
    if (numbers && numbers->size() == 1) shape.size = dvec3(numbers->front());
    if (numbers && numbers->size() == 3) shape.size = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    const double product = shape.size.x * shape.size.y * shape.size.z;
    const bool sound =
        numbers && (numbers->size() == 3 || numbers->size() == 1) && std::isfinite(product) && product != 0.0;
    if (shape.mesh.empty())
      shape.reason = Text("a mesh without filename");
    else if (!sound)
      shape.reason =
          Text("the mesh %1 with scale=\"%2\" instead of three numbers other than 0", shape.mesh, scale.substr(0, 100));
    else
      shape.kind = UrdfShape::Kind::kMesh;
  } else {
    shape.reason = Text("<%1>, which is not supported", name);
  }
}

Expected<UrdfShape> readShape(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics) {
  UrdfShape shape;
  shape.line = element.Row();
  const auto origin = readOrigin(element, lines);
  HAPTICELL_TRY(origin);
  shape.X_LS = *origin;
  const TiXmlElement* geometry = element.FirstChildElement("geometry");
  if (geometry)
    readGeometry(*geometry, shape);
  else
    shape.reason = Text("a <%1> without <geometry>", element.ValueStr());
  if (const TiXmlElement* material = element.FirstChildElement("material")) {
    UrdfMaterial read = readUrdfMaterial(*material, lines, diagnostics);
    shape.material = std::move(read.name);
    shape.color = read.color;
  }
  return shape;
}

/// A limit: "inf" and what is beyond any machine are no limit.
Expected<double> readLimit(const TiXmlElement& limit, const char* attribute, const UrdfLines& lines) {
  const std::string text = attributeOf(limit, attribute);
  const auto numbers = urdfNumbers(text);
  if (numbers && numbers->empty()) return 0.0;  // URDF: not written means zero.
  if (!numbers || numbers->size() != 1 || std::isnan(numbers->front()))
    return lines.refuse(limit.Row(), Text("<%1> has %2=\"%3\"", "limit", attribute, text.substr(0, 100)),
                        Text("a number"));
  const double value = numbers->front();
  return std::abs(value) >= kBeyondAnyLimit ? std::copysign(kEndless, value) : value;
}

void makeEndless(kinematics::Joint& joint) {
  if (joint.type == JointType::kRevolute) joint.type = JointType::kContinuous;
  joint.lower = -kEndless;
  joint.upper = kEndless;
}

Expected<void> readLimits(const TiXmlElement& element, const UrdfLines& lines, UrdfJoint& joint,
                          Diagnostics& diagnostics) {
  const TiXmlElement* limit = element.FirstChildElement("limit");
  const auto velocity = limit ? urdfNumbers(attributeOf(*limit, "velocity")) : std::nullopt;
  const bool stated =
      velocity && velocity->size() == 1 && std::isfinite(velocity->front()) && velocity->front() < kBeyondAnyLimit;
  joint.states_velocity = stated;
  joint.joint.velocity = stated ? std::max(0.0, velocity->front()) : 0.0;
  if (joint.joint.type == JointType::kContinuous) {
    makeEndless(joint.joint);
    return {};
  }
  if (!limit) {
    diagnostics.warn(Text("%1: joint '%2' is %3 without <limit>; no limits are assumed", lines.words(joint.line),
                          joint.joint.name, joint.type));
    makeEndless(joint.joint);
    return {};
  }
  const auto lower = readLimit(*limit, "lower", lines), upper = readLimit(*limit, "upper", lines);
  HAPTICELL_TRY(lower);
  HAPTICELL_TRY(upper);
  joint.joint.lower = *lower;
  joint.joint.upper = *upper;
  const bool crossed = *lower > *upper;
  const std::string low = attributeOf(*limit, "lower"), high = attributeOf(*limit, "upper");
  if (crossed) {
    diagnostics.warn(
        Text("%1: joint '%2' has its lower limit %3 above its upper limit %4; no limits are assumed, as in PyBullet",
             lines.words(limit->Row()), joint.joint.name, low, high));
  }
  if (crossed || (std::isinf(*lower) && std::isinf(*upper))) makeEndless(joint.joint);
  return {};
}

Expected<void> readAxis(const TiXmlElement& element, const UrdfLines& lines, UrdfJoint& joint) {
  const TiXmlElement* axis = element.FirstChildElement("axis");
  joint.joint.axis_J = {1.0, 0.0, 0.0};
  if (!axis) return {};
  const auto xyz = readNumbers(*axis, "xyz", {1.0, 0.0, 0.0}, lines);
  HAPTICELL_TRY(xyz);
  const dvec3 direction((*xyz)[0], (*xyz)[1], (*xyz)[2]);
  if (glm::length(direction) < 1e-9 || !std::isfinite(glm::length(direction)))
    return lines.refuse(axis->Row(),
                        Text("joint '%1' has the axis \"%2\"", joint.joint.name, attributeOf(*axis, "xyz")),
                        Text("a direction, such as \"0 0 1\""));
  joint.joint.axis_J = glm::normalize(direction);
  return {};
}

Expected<void> readMimic(const TiXmlElement& element, const UrdfLines& lines, UrdfJoint& joint) {
  const TiXmlElement* mimic = element.FirstChildElement("mimic");
  if (!mimic) return {};
  joint.mimicked = attributeOf(*mimic, "joint");
  joint.mimic_line = mimic->Row();
  const auto multiplier = readNumbers(*mimic, "multiplier", {1.0}, lines),
             offset = readNumbers(*mimic, "offset", {0.0}, lines);
  HAPTICELL_TRY(multiplier);
  HAPTICELL_TRY(offset);
  joint.multiplier = multiplier->front();
  joint.offset = offset->front();
  if (joint.mimicked.empty()) return lines.refuse(mimic->Row(), Text("<mimic> without joint"), "joint=\"…\"");
  return {};
}

Expected<JointType> typeOf(const UrdfJoint& joint, const UrdfLines& lines, Diagnostics& diagnostics) {
  static const std::set<std::string> kHeld = {"floating", "planar", "spherical", "ball"};
  if (joint.type == "revolute") return JointType::kRevolute;
  if (joint.type == "continuous") return JointType::kContinuous;
  if (joint.type == "prismatic") return JointType::kPrismatic;
  if (kHeld.count(joint.type)) {
    diagnostics.warn(
        Text("%1: joint '%2' is %3; it is read as fixed", lines.words(joint.line), joint.joint.name, joint.type));
  } else if (joint.type != "fixed") {
    return lines.refuse(joint.line, Text("joint '%1' has the type '%2'", joint.joint.name, joint.type),
                        Text("revolute, continuous, prismatic, fixed, floating or planar"));
  }
  return JointType::kFixed;
}

}  // namespace

UrdfMaterial readUrdfMaterial(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics) {
  UrdfMaterial material;
  material.name = attributeOf(element, "name");
  material.line = element.Row();
  material.textured = element.FirstChildElement("texture") != nullptr;
  if (const TiXmlElement* color = element.FirstChildElement("color"))
    material.color = readColor(*color, lines, diagnostics);
  return material;
}

Expected<UrdfLink> readUrdfLink(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics) {
  UrdfLink link{attributeOf(element, "name"), element.Row(), {}, {}};
  if (link.name.empty()) return lines.refuse(link.line, Text("a link without a name"), "name=\"…\"");
  for (const TiXmlElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    const bool visual = child->ValueStr() == "visual";
    if (!visual && child->ValueStr() != "collision") continue;
    auto shape = readShape(*child, lines, diagnostics);
    HAPTICELL_TRY(shape);
    (visual ? link.visuals : link.collisions).push_back(std::move(*shape));
  }
  return link;
}

Expected<UrdfJoint> readUrdfJoint(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics) {
  UrdfJoint joint;
  joint.joint.name = attributeOf(element, "name");
  joint.line = element.Row();
  joint.type = attributeOf(element, "type");
  if (joint.joint.name.empty()) return lines.refuse(joint.line, Text("a joint without a name"), "name=\"…\"");
  const auto type = typeOf(joint, lines, diagnostics);
  HAPTICELL_TRY(type);
  joint.joint.type = *type;
  const TiXmlElement *parent = element.FirstChildElement("parent"), *child = element.FirstChildElement("child");
  if (parent) joint.parent = attributeOf(*parent, "link");
  if (child) joint.child = attributeOf(*child, "link");
  if (joint.parent.empty() || joint.child.empty()) {
    return lines.refuse(joint.line,
                        joint.parent.empty() ? Text("joint '%1' has no parent link", joint.joint.name)
                                             : Text("joint '%1' has no child link", joint.joint.name),
                        Text("<parent link=\"…\"/> and <child link=\"…\"/>"));
  }
  const auto origin = readOrigin(element, lines);
  HAPTICELL_TRY(origin);
  joint.joint.X_PJ = *origin;
  if (joint.joint.type == JointType::kFixed) return joint;
  HAPTICELL_TRY(readAxis(element, lines, joint));
  HAPTICELL_TRY(readLimits(element, lines, joint, diagnostics));
  HAPTICELL_TRY(readMimic(element, lines, joint));
  return joint;
}

}  // namespace hapticell::workcell
