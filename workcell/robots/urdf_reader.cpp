// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_reader.h"

#include <map>

#include "geometry/system/regular_file.h"
#include "workcell/robots/urdf_lines.h"
#include "workcell/robots/urdf_shapes.h"
#include "workcell/robots/urdf_structure.h"
#include "workcell/text/read_record.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace {

using kinematics::Joint;
using kinematics::JointType;
using kinematics::RobotModel;

// 64 MB: guards memory. Half, twice: other files are refused with a message.
constexpr std::uintmax_t kLargestUrdf = 64u << 20;

/// Follows a chain of mimic joints to the one that moves by itself (there is one: the structure was checked).
void resolveMimic(const std::map<std::string, const UrdfJoint*>& sources, RobotModel& model, Joint& joint) {
  kinematics::Mimic mimic{-1, 1.0, 0.0};
  const UrdfJoint* at = sources.at(joint.name);
  for (; !at->mimicked.empty(); at = sources.at(at->mimicked)) {
    mimic.offset += mimic.multiplier * at->offset;
    mimic.multiplier *= at->multiplier;
  }
  mimic.joint = model.findJoint(at->joint.name);
  joint.mimic = mimic;
}

void addTree(const UrdfStructure& structure, RobotModel& model) {
  std::map<std::string, const UrdfJoint*> sources;
  std::map<std::string, int> links = {{structure.root_link, 0}};
  model.links.push_back({structure.root_link, -1, {}, {}});
  for (const UrdfJoint& source : structure.joints) {
    Joint joint = source.joint;
    sources[joint.name] = &source;
    joint.parent_link = links.at(source.parent);
    joint.child_link = static_cast<int>(model.links.size());
    links[source.child] = joint.child_link;
    model.links.push_back({source.child, static_cast<int>(model.joints.size()), {}, {}});
    if (joint.type != JointType::kFixed && source.mimicked.empty()) {
      joint.variable = static_cast<int>(model.moving.size());
      model.moving.push_back(static_cast<int>(model.joints.size()));
    }
    model.joints.push_back(std::move(joint));
  }
  for (Joint& joint : model.joints) {
    if (joint.type != JointType::kFixed && joint.variable < 0) resolveMimic(sources, model, joint);
  }
}

}  // namespace

Expected<RobotModel> readUrdf(const std::filesystem::path& path, Diagnostics& diagnostics, ImportMonitor* monitor,
                              RobotContent content) {
  const auto text = geometry::readRegularFile(path, kLargestUrdf);
  HAPTICELL_TRY(text);
  ReadRecord::note(path);
  return readUrdfText(*text, path, diagnostics, monitor, content);
}

Expected<RobotModel> readUrdfText(const std::string& text, const std::filesystem::path& path, Diagnostics& diagnostics,
                                  ImportMonitor* monitor, RobotContent content,
                                  const std::vector<xacro::Expanded::Place>* places) {
  const XmlText sound = soundXmlText(text);
  const UrdfLines lines(path.string(), places);
  if (sound.replaced > 0)
    diagnostics.warn(
        Text("line %1: text that is not UTF-8; %2 bytes were read as Latin-1", sound.line, sound.replaced));
  const auto structure = readUrdfStructure(sound.text, lines, diagnostics);
  HAPTICELL_TRY(structure);
  RobotModel model;
  model.name = structure->robot_name.empty() ? path.stem().string() : structure->robot_name;
  addTree(*structure, model);
  if (content == RobotContent::kKinematics) return model;
  UrdfShapes shapes(lines, diagnostics, monitor);
  shapes.readAhead(structure->links);
  std::map<std::string, kinematics::Link*> links;
  for (kinematics::Link& link : model.links) links[link.name] = &link;
  for (const UrdfLink& link : structure->links) {
    HAPTICELL_TRY(shapes.fill(link, *links.at(link.name)));
  }
  shapes.reportReplacements();
  return model;
}

}  // namespace hapticell::workcell
