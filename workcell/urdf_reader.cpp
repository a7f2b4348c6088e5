// SPDX-License-Identifier: Apache-2.0
#include "workcell/urdf_reader.h"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <sstream>

#include "workcell/urdf_shapes.h"
#include "workcell/urdf_structure.h"
#include "workcell/xml_text.h"

namespace hapticell::workcell {

namespace {

using kinematics::Joint;
using kinematics::JointType;
using kinematics::RobotModel;

constexpr std::uintmax_t kLargestFile = 64u << 20;

/// Keeps urdfdom's complaints from standard error, and the first of them for our own message.
class FirstComplaint : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) text_ = text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

Expected<std::string> readFile(const std::filesystem::path& path) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) {
    return makeError({path.string(), "", "there is no such file", "a URDF file", ""});
  }
  if (std::filesystem::file_size(path, problem) > kLargestFile) {
    return makeError({path.string(), "", "a file over 64 MB", "a URDF file", ""});
  }
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) return makeError({path.string(), "", "it cannot be read", "", "Look at its permissions."});
  return content.str();
}

Expected<urdf::ModelInterfaceSharedPtr> parse(const std::string& content, const std::string& file) {
  static std::mutex mutex;  // the library's message handler is one for the process
  const std::lock_guard lock(mutex);
  FirstComplaint complaint;
  console_bridge::useOutputHandler(&complaint);
  urdf::ModelInterfaceSharedPtr model;
  std::string thrown;
  try {
    model = urdf::parseURDF(content);
  } catch (const std::exception& exception) {
    thrown = exception.what();
  }
  console_bridge::restorePreviousOutputHandler();
  // It goes on after some faults with half a link, so any complaint counts.
  if (model && complaint.text().empty()) return model;
  const std::string reason = !complaint.text().empty() ? complaint.text() : thrown;
  return makeError({file, "", reason.empty() ? "it is not accepted as URDF" : reason, "valid URDF", ""});
}

JointType typeOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return JointType::kRevolute;
    case urdf::Joint::CONTINUOUS:
      return JointType::kContinuous;
    case urdf::Joint::PRISMATIC:
      return JointType::kPrismatic;
    default:
      return JointType::kFixed;
  }
}

Joint toJoint(const urdf::Joint& source) {
  Joint joint;
  joint.name = source.name;
  joint.type = typeOf(source);
  joint.X_PJ = toPose(source.parent_to_joint_origin_transform);
  if (joint.type == JointType::kFixed) return joint;
  joint.axis_J = glm::normalize(dvec3(source.axis.x, source.axis.y, source.axis.z));
  if (source.limits) {
    joint.lower = source.limits->lower;
    joint.upper = source.limits->upper;
    joint.velocity = std::max(0.0, source.limits->velocity);
  }
  if (joint.type == JointType::kContinuous) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  }
  return joint;
}

/// Follows a chain of mimic joints to the one that moves by itself (there is one: the structure was checked).
void resolveMimic(const urdf::ModelInterface& source, RobotModel& model, Joint& joint) {
  kinematics::Mimic mimic{-1, 1.0, 0.0};
  std::string name = joint.name;
  for (urdf::JointConstSharedPtr at = source.getJoint(name); at && at->mimic; at = source.getJoint(name)) {
    mimic.offset += mimic.multiplier * at->mimic->offset;
    mimic.multiplier *= at->mimic->multiplier;
    name = at->mimic->joint_name;
  }
  mimic.joint = model.findJoint(name);
  joint.mimic = mimic;
}

void addTree(const urdf::ModelInterface& source, const UrdfStructure& structure, RobotModel& model,
             Diagnostics& diagnostics) {
  model.links.push_back({structure.root_link, -1, {}, {}});
  for (const UrdfJointElement& element : structure.joints) {
    const urdf::JointConstSharedPtr from = source.getJoint(element.name);
    Joint joint = toJoint(*from);
    if (element.type == "floating" || element.type == "planar") {
      diagnostics.warn("line " + std::to_string(element.line) + ": joint '" + joint.name + "' is " + element.type +
                       "; it is read as fixed");
    }
    joint.parent_link = model.findLink(element.parent);
    joint.child_link = static_cast<int>(model.links.size());
    model.links.push_back({element.child, static_cast<int>(model.joints.size()), {}, {}});
    if (joint.type != JointType::kFixed && !from->mimic) {
      joint.variable = static_cast<int>(model.moving.size());
      model.moving.push_back(static_cast<int>(model.joints.size()));
    }
    model.joints.push_back(std::move(joint));
  }
  for (Joint& joint : model.joints) {
    if (joint.type != JointType::kFixed && joint.variable < 0) resolveMimic(source, model, joint);
  }
}

}  // namespace

Expected<RobotModel> readUrdf(const std::filesystem::path& path, Diagnostics& diagnostics, ImportMonitor* monitor,
                              RobotContent content) {
  const auto text = readFile(path);
  if (!text) return makeError(text.error());
  return readUrdfText(*text, path, diagnostics, monitor, content);
}

Expected<RobotModel> readUrdfText(const std::string& text, const std::filesystem::path& path, Diagnostics& diagnostics,
                                  ImportMonitor* monitor, RobotContent content) {
  const XmlText sound = soundXmlText(text);
  if (sound.replaced > 0)
    diagnostics.warn("line " + std::to_string(sound.line) + ": text that is no UTF-8; " +
                     std::to_string(sound.replaced) + " bytes were taken for Latin-1");
  const auto structure = checkUrdfStructure(sound.text, path.string());
  if (!structure) return makeError(structure.error());
  const auto source = parse(sound.text, path.string());
  if (!source) return makeError(source.error());
  RobotModel model;
  model.name = structure->robot_name;
  addTree(**source, *structure, model, diagnostics);
  for (const Joint& joint : model.joints) {
    if (!joint.X_PJ.isValid())
      return makeError({path.string(), "joint '" + joint.name + "'", "an origin that is not a pose", "", ""});
  }
  if (content == RobotContent::kKinematics) return model;
  std::set<std::string> undefined;
  for (const UrdfElement& material : structure->undefined_materials) {
    diagnostics.warn("line " + std::to_string(material.line) + ": the material '" + material.name +
                     "' is defined nowhere; its links are shown grey");
    undefined.insert(material.name);
  }
  UrdfShapes shapes(path, undefined, diagnostics, monitor);
  shapes.readAhead(**source);
  for (kinematics::Link& link : model.links) {
    if (auto filled = shapes.fill(*(*source)->getLink(link.name), link); !filled) return makeError(filled.error());
  }
  shapes.reportReplacements();
  return model;
}

}  // namespace hapticell::workcell
