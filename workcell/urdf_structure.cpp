// SPDX-License-Identifier: Apache-2.0
#include "workcell/urdf_structure.h"

#include <tinyxml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace hapticell::workcell {

namespace {

constexpr int kDeepest = 200;  // the parser recurses; real files stay under ten

constexpr std::size_t kMostLinks = 5000;

/// One look over the raw text for how deep its elements nest, comments left out.
int deepestNesting(const std::string& text) {
  int depth = 0, deepest = 0;
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i + 1)) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = text.find("-->", i);
      if (i == std::string::npos) break;
      continue;
    }
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (next == '/') {
      --depth;
    } else if (next != '!' && next != '?') {
      const std::size_t end = text.find('>', i);
      const bool closed = end != std::string::npos && text[end - 1] == '/';
      deepest = std::max(deepest, depth + 1);
      if (!closed) ++depth;
    }
  }
  return deepest;
}

std::optional<std::vector<double>> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const char* begin = word.c_str() + (word[0] == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, problem] = std::from_chars(begin, word.c_str() + word.size(), value);
    if (problem != std::errc() || end != word.c_str() + word.size() || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

class Checker {
 public:
  explicit Checker(std::string file) : file_(std::move(file)) {}

  Expected<UrdfStructure> check(const TiXmlElement& robot);
  tl::unexpected<Error> refuse(int line, std::string found, std::string expected, std::string fix) const {
    return makeError(
        {file_, line > 0 ? "line " + std::to_string(line) : "", std::move(found), std::move(expected), std::move(fix)});
  }

 private:
  struct MimicOf {
    std::string joint;
    int line = 0;
  };

  std::string file_;
  std::vector<UrdfElement> links_;
  std::map<std::string, int> link_lines_, joint_lines_;
  std::vector<UrdfJointElement> joints_;
  std::map<std::string, MimicOf> mimics_;
  std::map<std::string, int> used_materials_;
  std::set<std::string> defined_materials_;

  Expected<void> readLink(const TiXmlElement& element);
  Expected<void> readJoint(const TiXmlElement& element);
  Expected<void> checkLimit(const TiXmlElement& element, const UrdfJointElement& joint) const;
  Expected<void> checkNumbers(const TiXmlElement& element) const;
  void noteMaterials(const TiXmlElement& element);
  std::vector<UrdfElement> undefinedMaterials() const;
  Expected<void> checkEnds() const;
  Expected<void> checkMimics() const;
  Expected<std::string> findRoot() const;
  Expected<std::vector<UrdfJointElement>> sortFrom(const std::string& root) const;
};

// Every attribute that must be a row of numbers, in the whole tree below `element`.
Expected<void> Checker::checkNumbers(const TiXmlElement& element) const {
  struct Row {
    const char *element, *attribute;
    std::size_t count;
  };
  static constexpr std::array<Row, 14> kRows = {{{"origin", "xyz", 3},
                                                 {"origin", "rpy", 3},
                                                 {"axis", "xyz", 3},
                                                 {"limit", "lower", 1},
                                                 {"limit", "upper", 1},
                                                 {"limit", "velocity", 1},
                                                 {"mimic", "multiplier", 1},
                                                 {"mimic", "offset", 1},
                                                 {"mesh", "scale", 3},
                                                 {"box", "size", 3},
                                                 {"cylinder", "radius", 1},
                                                 {"cylinder", "length", 1},
                                                 {"sphere", "radius", 1},
                                                 {"color", "rgba", 4}}};
  for (const TiXmlElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    for (const Row& row : kRows) {
      const char* value = child->ValueStr() == row.element ? child->Attribute(row.attribute) : nullptr;
      if (!value) continue;
      const auto numbers = numbersOf(value);
      if (!numbers || numbers->size() != row.count) {
        return refuse(child->Row(), std::string("<") + row.element + "> has " + row.attribute + "=\"" + value + "\"",
                      row.count == 1 ? "a finite number" : std::to_string(row.count) + " finite numbers", "");
      }
    }
    if (auto checked = checkNumbers(*child); !checked) return checked;
  }
  return {};
}

// A material with a color or texture defines its name, there or at the top of the file; one without refers to it.
void Checker::noteMaterials(const TiXmlElement& element) {
  if (element.ValueStr() == "material") {
    const std::string name = attribute(element, "name");
    const bool defines = element.FirstChildElement("color") || element.FirstChildElement("texture");
    if (defines) defined_materials_.insert(name);
    if (!defines) used_materials_.emplace(name, element.Row());
  }
  for (const TiXmlElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    noteMaterials(*child);
  }
}

std::vector<UrdfElement> Checker::undefinedMaterials() const {
  std::vector<UrdfElement> undefined;
  for (const auto& [name, line] : used_materials_) {
    if (!defined_materials_.count(name)) undefined.push_back({name, line});
  }
  return undefined;
}

Expected<void> Checker::readLink(const TiXmlElement& element) {
  const UrdfElement link{attribute(element, "name"), element.Row()};
  if (link.name.empty()) return refuse(link.line, "a link without a name", "name=\"…\"", "");
  const auto [known, fresh] = link_lines_.emplace(link.name, link.line);
  if (!fresh) {
    return refuse(link.line,
                  "a second link '" + link.name + "' (the first is on line " + std::to_string(known->second) + ")",
                  "each name once", "Rename one of them.");
  }
  links_.push_back(link);
  return checkNumbers(element);
}

Expected<void> Checker::checkLimit(const TiXmlElement& element, const UrdfJointElement& joint) const {
  if (joint.type != "revolute" && joint.type != "prismatic") return {};
  const TiXmlElement* limit = element.FirstChildElement("limit");
  if (!limit) {
    return refuse(joint.line, "joint '" + joint.name + "' is " + joint.type + " and has no <limit>",
                  "<limit lower=\"…\" upper=\"…\" velocity=\"…\" effort=\"…\"/>",
                  joint.type == "revolute" ? "Add its limits, or make it continuous." : "Add its limits.");
  }
  const auto value = [&](const char* name) {
    const std::string text = attribute(*limit, name);
    const auto numbers = numbersOf(text);
    return numbers && !numbers->empty() ? numbers->front() : 0.0;  // absent means zero (URDF)
  };
  if (value("lower") > value("upper")) {
    return refuse(limit->Row(),
                  "joint '" + joint.name + "' has its lower limit " + attribute(*limit, "lower") + " over the upper " +
                      attribute(*limit, "upper"),
                  "lower <= upper", "Swap the two.");
  }
  return {};
}

Expected<void> Checker::readJoint(const TiXmlElement& element) {
  UrdfJointElement joint;
  joint.name = attribute(element, "name");
  joint.line = element.Row();
  joint.type = attribute(element, "type");
  if (joint.name.empty()) return refuse(joint.line, "a joint without a name", "name=\"…\"", "");
  const auto [known, fresh] = joint_lines_.emplace(joint.name, joint.line);
  if (!fresh) {
    return refuse(joint.line,
                  "a second joint '" + joint.name + "' (the first is on line " + std::to_string(known->second) + ")",
                  "each name once", "Rename one of them.");
  }
  static const std::set<std::string> kTypes = {"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
  if (!kTypes.count(joint.type)) {
    return refuse(joint.line, "joint '" + joint.name + "' has the type '" + joint.type + "'",
                  "revolute, continuous, prismatic, fixed, floating or planar", "");
  }
  const TiXmlElement* parent = element.FirstChildElement("parent");
  const TiXmlElement* child = element.FirstChildElement("child");
  if (parent) joint.parent = attribute(*parent, "link");
  if (child) joint.child = attribute(*child, "link");
  if (joint.parent.empty() || joint.child.empty()) {
    return refuse(joint.line,
                  "joint '" + joint.name + "' names no " + (joint.parent.empty() ? "parent" : "child") + " link",
                  "<parent link=\"…\"/> and <child link=\"…\"/>", "");
  }
  if (auto checked = checkNumbers(element); !checked) return checked;
  if (auto checked = checkLimit(element, joint); !checked) return checked;
  const TiXmlElement* axis = element.FirstChildElement("axis");
  if (axis && joint.type != "fixed" && joint.type != "floating") {
    const auto numbers = numbersOf(attribute(*axis, "xyz"));
    if (!numbers || numbers->size() != 3 || std::hypot((*numbers)[0], (*numbers)[1], (*numbers)[2]) < 1e-9) {
      return refuse(axis->Row(), "joint '" + joint.name + "' has the axis \"" + attribute(*axis, "xyz") + "\"",
                    "a direction, such as \"0 0 1\"", "");
    }
  }
  if (const TiXmlElement* mimic = element.FirstChildElement("mimic"))
    mimics_[joint.name] = {attribute(*mimic, "joint"), mimic->Row()};
  joints_.push_back(std::move(joint));
  return {};
}

Expected<void> Checker::checkEnds() const {
  std::map<std::string, std::string> carried;
  for (const UrdfJointElement& joint : joints_) {
    for (const std::string& link : {joint.parent, joint.child}) {
      if (!link_lines_.count(link)) {
        return refuse(joint.line, "joint '" + joint.name + "' names the link '" + link + "', which is not in the file",
                      "the name of a link", "Add the link or correct the name.");
      }
    }
    const auto [first, fresh] = carried.emplace(joint.child, joint.name);
    if (!fresh) {
      return refuse(
          joint.line,
          "link '" + joint.child + "' is the child of two joints, '" + first->second + "' and '" + joint.name + "'",
          "a tree", "URDF cannot say closed loops: leave one of the joints out.");
    }
  }
  return {};
}

Expected<void> Checker::checkMimics() const {
  for (const auto& [name, first] : mimics_) {
    const MimicOf* mimic = &first;
    for (std::size_t steps = 0;; ++steps) {
      if (!joint_lines_.count(mimic->joint)) {
        return refuse(mimic->line, "the joint '" + mimic->joint + "' to be mimicked is not in the file",
                      "the name of a joint", "");
      }
      if (mimic->joint == name || steps > mimics_.size()) {
        return refuse(first.line, "joint '" + name + "' mimics itself in a circle",
                      "a joint that moves by itself at the end", "");
      }
      const auto next = mimics_.find(mimic->joint);
      if (next == mimics_.end()) break;
      mimic = &next->second;
    }
  }
  return {};
}

Expected<std::string> Checker::findRoot() const {
  std::set<std::string> children;
  for (const UrdfJointElement& joint : joints_) children.insert(joint.child);
  std::vector<const UrdfElement*> roots;
  for (const UrdfElement& link : links_) {
    if (!children.count(link.name)) roots.push_back(&link);
  }
  if (roots.empty()) {
    return refuse(joints_.front().line, "the joints form a cycle: every link is the child of another",
                  "a tree with one root link", "Leave out the joint that closes the cycle.");
  }
  if (roots.size() > 1) {
    return refuse(roots[1]->line,
                  "two root links, '" + roots[0]->name + "' (line " + std::to_string(roots[0]->line) + ") and '" +
                      roots[1]->name + "'" +
                      (roots.size() > 2 ? ", and " + std::to_string(roots.size() - 2) + " more" : ""),
                  "one link that is no joint's child", "Join them by a fixed joint.");
  }
  return roots.front()->name;
}

Expected<std::vector<UrdfJointElement>> Checker::sortFrom(const std::string& root) const {
  std::map<std::string, std::vector<const UrdfJointElement*>> below;
  for (const UrdfJointElement& joint : joints_) below[joint.parent].push_back(&joint);
  std::vector<UrdfJointElement> sorted;
  std::set<std::string> reached = {root};
  std::vector<const UrdfJointElement*> open(below[root].rbegin(), below[root].rend());
  while (!open.empty()) {
    const UrdfJointElement* joint = open.back();
    open.pop_back();
    sorted.push_back(*joint);
    reached.insert(joint->child);
    const auto& next = below[joint->child];
    open.insert(open.end(), next.rbegin(), next.rend());
  }
  for (const UrdfJointElement& joint : joints_) {
    if (!reached.count(joint.child)) {
      return refuse(joint.line,
                    "the joints form a cycle: link '" + joint.child + "' (joint '" + joint.name + "') hangs on itself",
                    "a tree from the root link '" + root + "'", "Leave out the joint that closes the cycle.");
    }
  }
  return sorted;
}

Expected<UrdfStructure> Checker::check(const TiXmlElement& robot) {
  UrdfStructure structure;
  structure.robot_name = attribute(robot, "name");
  if (structure.robot_name.empty()) return refuse(robot.Row(), "<robot> has no name", "name=\"…\"", "");
  // Only direct children count: <transmission> and <ros2_control> repeat <joint name=…>.
  for (const TiXmlElement* child = robot.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (child->ValueStr().starts_with("xacro:")) {
      return refuse(child->Row(), "<" + child->ValueStr() + ">", "plain URDF",
                    "Expand the file first: xacro FILE > robot.urdf.");
    }
    Expected<void> read;
    if (child->ValueStr() == "link" || child->ValueStr() == "material") noteMaterials(*child);
    if (child->ValueStr() == "link") read = readLink(*child);
    if (child->ValueStr() == "joint") read = readJoint(*child);
    if (child->ValueStr() == "material") read = checkNumbers(*child);
    if (!read) return makeError(read.error());
  }
  if (links_.size() > kMostLinks)
    return refuse(robot.Row(), std::to_string(links_.size()) + " links", "at most 5000", "");
  if (links_.empty()) return refuse(robot.Row(), "<robot> has no links", "at least one <link>", "");
  if (auto checked = checkEnds(); !checked) return makeError(checked.error());
  if (auto checked = checkMimics(); !checked) return makeError(checked.error());
  auto root = findRoot();
  if (!root) return makeError(root.error());
  auto sorted = sortFrom(*root);
  if (!sorted) return makeError(sorted.error());
  structure.root_link = *root;
  structure.joints = std::move(*sorted);
  structure.undefined_materials = undefinedMaterials();
  return structure;
}

}  // namespace

Expected<UrdfStructure> checkUrdfStructure(const std::string& content, const std::string& file) {
  Checker checker(file);
  if (content.find('\0') != std::string::npos) return checker.refuse(0, "a NUL byte", "XML text", "");
  if (deepestNesting(content) > kDeepest)
    return checker.refuse(0, "elements nested deeper than 200", "a URDF file", "");
  if (const auto entities = content.find("<!ENTITY"); entities != std::string::npos) {
    const auto line = static_cast<int>(
        1 + std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(entities), '\n'));
    return checker.refuse(line, "a document type with entities of its own (<!ENTITY ...>)", "a URDF file without them",
                          "Write out the text that they stand for.");
  }
  TiXmlDocument document;
  document.Parse(content.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    const auto last_line = static_cast<int>(1 + std::count(content.begin(), content.end(), '\n'));
    return checker.refuse(document.ErrorRow() > 0 ? document.ErrorRow() : last_line,
                          std::string("XML that does not parse (") + document.ErrorDesc() + ")", "well-formed XML", "");
  }
  const TiXmlElement* robot = document.RootElement();
  if (!robot || robot->ValueStr() != "robot") {
    return checker.refuse(robot ? robot->Row() : 0,
                          robot ? "the root element <" + robot->ValueStr() + ">" : "no XML element",
                          "<robot name=\"…\"> (URDF)", "");
  }
  return checker.check(*robot);
}

}  // namespace hapticell::workcell
