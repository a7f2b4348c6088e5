// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/srdf.h"

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/system/listed.h"
#include "geometry/system/nesting_limit.h"
#include "workcell/text/file_content.h"
#include "workcell/text/text_cursor.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

using kinematics::RobotModel;

std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

class SrdfReader {
 public:
  SrdfReader(std::string file, RobotModel& model, Diagnostics& diagnostics)
      : file_(std::move(file)), model_(model), diagnostics_(diagnostics) {}

  void read(const TiXmlElement& robot) {
    for (const TiXmlElement* child = robot.FirstChildElement(); child; child = child->NextSiblingElement()) {
      if (child->ValueStr() == "group") readGroup(*child);
      if (child->ValueStr() == "disable_collisions") readPair(*child);
    }
    for (const TiXmlElement* child = robot.FirstChildElement("group_state"); child;
         child = child->NextSiblingElement("group_state")) {
      readState(*child);
    }
    if (unknown_.empty()) return;
    diagnostics_.warn(Text("%1: the robot does not have these links or joints: %2", file_, listed(unknown_)));
  }

 private:
  int link(const std::string& name) {
    const int index = model_.findLink(name);
    if (index < 0) unknown_.insert(name);
    return index;
  }

  void addJoint(kinematics::JointGroup& group, int joint) {
    if (std::find(group.joints.begin(), group.joints.end(), joint) == group.joints.end()) group.joints.push_back(joint);
  }

  void readGroup(const TiXmlElement& element) {
    kinematics::JointGroup group;
    group.name = attribute(element, "name");
    for (const TiXmlElement* part = element.FirstChildElement(); part; part = part->NextSiblingElement()) {
      const std::string kind = part->Value(), name = attribute(*part, "name");
      if (kind == "joint") {
        const int joint = model_.findJoint(name);
        joint < 0 ? void(unknown_.insert(name)) : addJoint(group, joint);
      } else if (kind == "link") {
        const int at = link(name);
        const int joint = at < 0 ? -1 : model_.links[static_cast<std::size_t>(at)].parent_joint;
        if (joint >= 0) addJoint(group, joint);
      } else if (kind == "chain") {
        readChain(*part, group);
      } else if (kind == "group") {
        for (const auto& other : model_.groups) {
          if (other.name != name) continue;
          for (const int joint : other.joints) addJoint(group, joint);
        }
      }
    }
    if (!group.name.empty()) model_.groups.push_back(std::move(group));
  }

  void readChain(const TiXmlElement& element, kinematics::JointGroup& group) {
    group.base_link = attribute(element, "base_link");
    group.tip_link = attribute(element, "tip_link");
    const int base = link(group.base_link), tip = link(group.tip_link);
    if (base < 0 || tip < 0) return;
    std::vector<int> chain;
    for (int at = tip; at != base && at >= 0;) {
      const int joint = model_.links[static_cast<std::size_t>(at)].parent_joint;
      if (joint < 0) break;
      chain.push_back(joint);
      at = model_.joints[static_cast<std::size_t>(joint)].parent_link;
    }
    for (auto joint = chain.rbegin(); joint != chain.rend(); ++joint) addJoint(group, *joint);
  }

  void readPair(const TiXmlElement& element) {
    const int first = link(attribute(element, "link1")), second = link(attribute(element, "link2"));
    if (first >= 0 && second >= 0) model_.disabled_pairs.push_back({first, second, attribute(element, "reason")});
  }

  void readState(const TiXmlElement& element) {
    kinematics::NamedPose pose{attribute(element, "name"), kinematics::restPositions(model_)};
    bool any = false;
    for (const TiXmlElement* part = element.FirstChildElement("joint"); part;
         part = part->NextSiblingElement("joint")) {
      const std::string name = attribute(*part, "name");
      const int joint = model_.findJoint(name);
      const auto value = parseNumber(attribute(*part, "value"));
      if (joint < 0 || !value || !std::isfinite(*value)) {
        unknown_.insert(name);
        continue;
      }
      const int variable = model_.joints[static_cast<std::size_t>(joint)].variable;
      if (variable < 0) continue;
      pose.q[static_cast<std::size_t>(variable)] = *value;
      any = true;
    }
    if (any && !pose.name.empty()) model_.named_poses.push_back(std::move(pose));
  }

  std::string file_;
  RobotModel& model_;
  Diagnostics& diagnostics_;
  std::set<std::string> unknown_;
};

std::optional<fs::path> srdfIn(const fs::path& folder, const std::string& stem, const std::string& robot) {
  std::error_code problem;
  for (const std::string& name : {stem, robot}) {
    const fs::path exact = folder / (name + ".srdf");
    if (!name.empty() && name.find('/') == std::string::npos && fs::is_regular_file(exact, problem)) return exact;
  }
  std::vector<fs::path> all;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem)) {
    if (at->path().extension() == ".srdf") all.push_back(at->path());
  }
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

}  // namespace

std::optional<fs::path> findSrdf(const fs::path& robot_file, const std::string& robot_name) {
  const fs::path folder = fs::absolute(robot_file).parent_path();
  for (const fs::path& place : {folder, folder / "config", folder.parent_path() / "config"}) {
    if (auto found = srdfIn(place, robot_file.stem().string(), robot_name)) return found;
  }
  return std::nullopt;
}

Expected<void> readSrdf(const fs::path& file, RobotModel& model, Diagnostics& diagnostics) {
  const Expected<std::string> content = readFileContent(file);
  HAPTICELL_TRY(content);
  const auto refuse = [&](int line, const Text& found, const Text& expected) {
    return makeError({.file = file.string(),
                      .place = line > 0 ? Text("line %1", line) : Text(),
                      .found = found,
                      .expected = expected,
                      .fix = "Correct the file, or move it out of the folder of the robot."});
  };
  if (content->find('\0') != std::string::npos) return refuse(0, Text("a NUL byte"), Text("XML text"));
  auto flat = geometry::checkNesting(*content, geometry::NestedText::kXml, file.string());
  if (!flat) return flat;
  TiXmlDocument document;
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) return refuse(document.ErrorRow(), Text("invalid XML (%1)", document.ErrorDesc()), "SRDF");
  const TiXmlElement* robot = document.RootElement();
  if (!robot || robot->ValueStr() != "robot")
    return refuse(robot ? robot->Row() : 0, Text("<robot> is missing"), "<robot name=\"…\"> (SRDF)");
  SrdfReader(file.string(), model, diagnostics).read(*robot);
  for (const kinematics::NamedPose& pose : model.named_poses) {
    if (pose.name == "home" && !model.closure) model.home = pose.q;
  }
  return {};
}

}  // namespace hapticell::workcell
