// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_structure.h"

#include <tinyxml.h>

#include <algorithm>
#include <map>
#include <set>

#include "workcell/robots/urdf_lines.h"
#include "xacro/xml_document.h"

namespace hapticell::workcell {

namespace {

// Guards time and memory. Half, twice: other files are refused with a message.
constexpr std::size_t kMostLinks = 5000;

class StructureReader {
 public:
  StructureReader(const UrdfLines& lines, Diagnostics& diagnostics) : lines_(lines), diagnostics_(diagnostics) {}

  Expected<UrdfStructure> read(const TiXmlElement& robot);

 private:
  const UrdfLines& lines_;
  Diagnostics& diagnostics_;
  UrdfStructure structure_;
  std::map<std::string, int> link_lines_, joint_lines_;
  std::map<std::string, const UrdfJoint*> mimics_;
  std::map<std::string, UrdfMaterial> materials_;
  std::map<std::string, int> undefined_, textured_;  ///< Materials without a color, with a line.

  struct Unexpanded {
    int line = 0;  ///< Of the first.
    int count = 0;
  };
  std::map<std::string, Unexpanded> unexpanded_;  ///< Calls of macros that are not in the file.

  Expected<void> readElement(const TiXmlElement& element);
  void reportUnexpanded();
  Expected<void> addWorld();
  Expected<void> addLink(UrdfLink link);
  Expected<void> addJoint(UrdfJoint joint);
  void defineMaterial(UrdfMaterial material, bool at_top);
  void defineMaterialsBelow(const TiXmlElement& element);
  void colorShapes();
  std::optional<std::array<float, 4>> colorOf(const UrdfShape& shape);
  void reportColors();
  void reportVelocities();
  Expected<void> checkEnds() const;
  Expected<void> checkMimics();
  Expected<std::string> findRoot();
  Expected<std::vector<UrdfJoint>> sortFrom(const std::string& root) const;
};

template <class T>
Text listOfNames(const T& names) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (++count > 8) return Text("%1 and %2 more", text, names.size() - 8);
    text += std::string(count > 1 ? ", " : "") + "'" + name + "'";
  }
  return text;
}

Expected<void> StructureReader::addLink(UrdfLink link) {
  const auto [known, fresh] = link_lines_.emplace(link.name, link.line);
  if (!fresh) {
    return lines_.refuse(link.line,
                         Text("a second link '%1' (the first is on %2)", link.name, lines_.words(known->second)),
                         Text("each name once"), Text("Rename one of them."));
  }
  structure_.links.push_back(std::move(link));
  return {};
}

Expected<void> StructureReader::addJoint(UrdfJoint joint) {
  const auto [known, fresh] = joint_lines_.emplace(joint.joint.name, joint.line);
  if (!fresh) {
    return lines_.refuse(
        joint.line, Text("a second joint '%1' (the first is on %2)", joint.joint.name, lines_.words(known->second)),
        Text("each name once"), Text("Rename one of them."));
  }
  structure_.joints.push_back(std::move(joint));
  return {};
}

/// The first definition of a name counts; others are told where their color differs. One without color, texture or
/// name defines nothing.
void StructureReader::defineMaterial(UrdfMaterial material, bool at_top) {
  if (material.name.empty() || (!material.color && !material.textured)) return;
  const auto [known, fresh] = materials_.emplace(material.name, material);
  if (fresh || !at_top || known->second.color == material.color) return;
  diagnostics_.warn(Text("%1: the material '%2' is defined twice with different colors; the first one, on %3, is used",
                         lines_.words(material.line), material.name, lines_.words(known->second.line)));
}

void StructureReader::defineMaterialsBelow(const TiXmlElement& element) {
  for (const TiXmlElement* visual = element.FirstChildElement("visual"); visual;
       visual = visual->NextSiblingElement("visual")) {
    Diagnostics said_elsewhere;
    if (const TiXmlElement* material = visual->FirstChildElement("material"))
      defineMaterial(readUrdfMaterial(*material, lines_, said_elsewhere), false);
  }
}

Expected<void> StructureReader::readElement(const TiXmlElement& element) {
  const std::string& name = element.ValueStr();
  static const std::set<std::string> kOfXacro = {"xacro:macro", "xacro:property", "xacro:include",     "xacro:arg",
                                                 "xacro:if",    "xacro:unless",   "xacro:insert_block"};
  if (kOfXacro.count(name) > 0)
    return lines_.refuse(element.Row(), "<" + name + ">", Text("plain URDF"),
                         Text("To have the file expanded, rename it to *.xacro."));
  if (name.starts_with("xacro:")) ++unexpanded_.try_emplace(name, Unexpanded{element.Row(), 0}).first->second.count;
  if (name == "material") {
    defineMaterial(readUrdfMaterial(element, lines_, diagnostics_), true);
  } else if (name == "link") {
    auto link = readUrdfLink(element, lines_, diagnostics_);
    return link ? addLink(std::move(*link)) : makeError(link.error());
  } else if (name == "joint") {
    auto joint = readUrdfJoint(element, lines_, diagnostics_);
    return joint ? addJoint(std::move(*joint)) : makeError(joint.error());
  }
  return {};
}

std::optional<std::array<float, 4>> StructureReader::colorOf(const UrdfShape& shape) {
  if (shape.color) return shape.color;
  if (shape.material.empty()) return std::nullopt;
  const auto material = materials_.find(shape.material);
  if (material == materials_.end())
    undefined_.emplace(shape.material, shape.line);
  else if (!material->second.color && material->second.textured)
    textured_.emplace(shape.material, material->second.line);
  return material == materials_.end() ? std::nullopt : material->second.color;
}

void StructureReader::colorShapes() {
  for (UrdfLink& link : structure_.links) {
    for (UrdfShape& shape : link.visuals) shape.color = colorOf(shape);
  }
}

void StructureReader::reportColors() {
  for (const auto& [name, line] : undefined_)
    diagnostics_.warn(Text("%1: the material '%2' is not defined; its links are shown grey", lines_.words(line), name));
  for (const auto& [name, line] : textured_)
    diagnostics_.warn(
        Text("%1: the material '%2' has a texture and no color; textures are not shown, so its links are grey",
             lines_.words(line), name));
}

void StructureReader::reportVelocities() {
  std::vector<std::string> names;
  int line = 0;
  for (const UrdfJoint& joint : structure_.joints) {
    if (joint.joint.type == kinematics::JointType::kFixed || joint.states_velocity || !joint.mimicked.empty()) continue;
    if (joint.type == "continuous") continue;  // Limits are no part of it.
    names.push_back(joint.joint.name);
    if (line == 0) line = joint.line;
  }
  if (!names.empty())
    diagnostics_.warn(
        Text("%1: no finite velocity is stated for %2; if a velocity is needed, 180 deg/s or 1 m/s is assumed",
             lines_.words(line), listOfNames(names)));
}

void StructureReader::reportUnexpanded() {
  for (const auto& [name, calls] : unexpanded_)
    diagnostics_.warn(calls.count > 1 ? Text("%1: <%2> is left out (%3 times), because its macro is not in the file",
                                             lines_.words(calls.line), name, calls.count)
                                      : Text("%1: <%2> is left out (1 time), because its macro is not in the file",
                                             lines_.words(calls.line), name));
}

/// The world needs no link of its own in some tools (Drake, Bullet): what is joined to it stands on the cell.
Expected<void> StructureReader::addWorld() {
  if (link_lines_.count("world") > 0) return {};
  for (const UrdfJoint& joint : structure_.joints) {
    if (joint.parent != "world") continue;
    diagnostics_.warn(
        Text("%1: joint '%2' is attached to 'world', which is not a link of the file; 'world' is used as the root",
             lines_.words(joint.line), joint.joint.name));
    UrdfLink world;
    world.name = "world";
    world.line = joint.line;
    return addLink(std::move(world));
  }
  return {};
}

Expected<void> StructureReader::checkEnds() const {
  std::map<std::string, std::string> carried;
  for (const UrdfJoint& joint : structure_.joints) {
    for (const std::string& link : {joint.parent, joint.child}) {
      if (!link_lines_.count(link)) {
        return lines_.refuse(joint.line,
                             Text("joint '%1' names the link '%2', which is not in the file", joint.joint.name, link),
                             Text("the name of a link"), Text("Add the link or correct the name."));
      }
    }
    const auto [first, fresh] = carried.emplace(joint.child, joint.joint.name);
    if (!fresh) {
      return lines_.refuse(
          joint.line,
          Text("link '%1' is the child of two joints, '%2' and '%3'", joint.child, first->second, joint.joint.name),
          Text("a tree without cycles"),
          Text("URDF cannot describe closed loops: remove one of the joints, and close the loop in a robot.toml "
               "(docs/user/formats.md)."));
    }
  }
  return {};
}

Expected<void> StructureReader::checkMimics() {
  for (const UrdfJoint& joint : structure_.joints) {
    if (!joint.mimicked.empty()) mimics_[joint.joint.name] = &joint;
  }
  for (const auto& [name, first] : mimics_) {
    const UrdfJoint* mimic = first;
    for (std::size_t steps = 0;; ++steps) {
      if (!joint_lines_.count(mimic->mimicked))
        return lines_.refuse(mimic->mimic_line, Text("the mimicked joint '%1' is not in the file", mimic->mimicked),
                             Text("the name of a joint"));
      if (mimic->mimicked == name || steps > mimics_.size())
        return lines_.refuse(first->mimic_line, Text("joint '%1' mimics itself through other joints", name),
                             Text("a chain that ends at an independent joint"));
      const auto next = mimics_.find(mimic->mimicked);
      if (next == mimics_.end()) break;
      mimic = next->second;
    }
  }
  return {};
}

/// The root; links that hang on nothing, carry nothing and have no shape are left out.
Expected<std::string> StructureReader::findRoot() {
  std::set<std::string> children, parents;
  for (const UrdfJoint& joint : structure_.joints) {
    children.insert(joint.child);
    parents.insert(joint.parent);
  }
  const auto is_root = [&](const UrdfLink& link) { return !children.count(link.name); };
  const auto idle = [&](const UrdfLink& link) {
    return is_root(link) && !parents.count(link.name) && link.visuals.empty() && link.collisions.empty();
  };
  auto& links = structure_.links;
  if (std::count_if(links.begin(), links.end(), is_root) > 1 && !structure_.joints.empty()) {
    for (const UrdfLink& link : links) {
      if (idle(link))
        diagnostics_.warn(Text("%1: no joint names the link '%2' and it has no shape; it is left out",
                               lines_.words(link.line), link.name));
    }
    std::erase_if(links, idle);
  }
  std::vector<const UrdfLink*> roots;
  for (const UrdfLink& link : links) {
    if (is_root(link)) roots.push_back(&link);
  }
  if (roots.empty()) {
    return lines_.refuse(structure_.joints.front().line,
                         Text("the joints form a cycle: every link is the child of another"),
                         Text("a tree with one root link"), Text("Remove the joint that closes the cycle."));
  }
  if (roots.size() > 1) {
    const Text two("two root links, '%1' (%2) and '%3'", roots[0]->name, lines_.words(roots[0]->line), roots[1]->name);
    return lines_.refuse(roots[1]->line, roots.size() > 2 ? Text("%1, and %2 more", two, roots.size() - 2) : two,
                         Text("one link that is not the child of a joint"), Text("Connect them with a fixed joint."));
  }
  return roots.front()->name;
}

Expected<std::vector<UrdfJoint>> StructureReader::sortFrom(const std::string& root) const {
  std::map<std::string, std::vector<const UrdfJoint*>> below;
  for (const UrdfJoint& joint : structure_.joints) below[joint.parent].push_back(&joint);
  std::vector<UrdfJoint> sorted;
  std::set<std::string> reached = {root};
  std::vector<const UrdfJoint*> open(below[root].rbegin(), below[root].rend());
  while (!open.empty()) {
    const UrdfJoint* joint = open.back();
    open.pop_back();
    sorted.push_back(*joint);
    reached.insert(joint->child);
    const auto& next = below[joint->child];
    open.insert(open.end(), next.rbegin(), next.rend());
  }
  for (const UrdfJoint& joint : structure_.joints) {
    if (!reached.count(joint.child)) {
      return lines_.refuse(
          joint.line,
          Text("the joints form a cycle: link '%1' (joint '%2') is attached to itself", joint.child, joint.joint.name),
          Text("a tree from the root link '%1'", root), Text("Remove the joint that closes the cycle."));
    }
  }
  return sorted;
}

Expected<UrdfStructure> StructureReader::read(const TiXmlElement& robot) {
  if (const char* name = robot.Attribute("name")) structure_.robot_name = name;
  // Only direct children count: <transmission> and <ros2_control> repeat <joint name=…>.
  for (const TiXmlElement* child = robot.FirstChildElement(); child; child = child->NextSiblingElement()) {
    HAPTICELL_TRY(readElement(*child));
  }
  for (const TiXmlElement* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link"))
    defineMaterialsBelow(*link);
  if (structure_.links.size() > kMostLinks)
    return lines_.refuse(robot.Row(), Text("%1 links", structure_.links.size()), Text("at most 5000"));
  if (structure_.links.empty()) {
    return lines_.refuse(robot.Row(), Text("<robot> has no links"), Text("at least one <link>"),
                         Text("If this is a file of macros, open the file that includes it."));
  }
  reportUnexpanded();
  HAPTICELL_TRY(addWorld());
  HAPTICELL_TRY(checkEnds());
  HAPTICELL_TRY(checkMimics());
  const auto root = findRoot();
  HAPTICELL_TRY(root);
  auto sorted = sortFrom(*root);
  HAPTICELL_TRY(sorted);
  structure_.root_link = *root;
  structure_.joints = std::move(*sorted);
  colorShapes();
  reportColors();
  reportVelocities();
  return std::move(structure_);
}

}  // namespace

const UrdfLink& UrdfStructure::link(const std::string& name) const {
  return *std::find_if(links.begin(), links.end(), [&name](const UrdfLink& link) { return link.name == name; });
}

Expected<UrdfStructure> readUrdfStructure(const std::string& content, const UrdfLines& lines,
                                          Diagnostics& diagnostics) {
  TiXmlDocument document;
  HAPTICELL_TRY(xacro::parseXml(content, lines.file(), document));
  const TiXmlElement* robot = document.RootElement();
  if (!robot || robot->ValueStr() != "robot") {
    return lines.refuse(robot ? robot->Row() : 0,
                        robot ? Text("the root element <%1>", robot->ValueStr()) : Text("no XML element"),
                        Text("<robot name=\"…\"> (URDF)"));
  }
  return StructureReader(lines, diagnostics).read(*robot);
}

}  // namespace hapticell::workcell
