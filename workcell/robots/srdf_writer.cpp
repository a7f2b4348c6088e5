// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/srdf_writer.h"

#include <algorithm>
#include <charconv>

#include "geometry/system/markup.h"

namespace hapticell::workcell {

namespace {

using kinematics::RobotModel;

std::string shortNumber(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string groupText(const RobotModel& model, const kinematics::JointGroup& group) {
  std::string text = "  <group name=\"" + escapedMarkup(group.name) + "\">\n";
  if (!group.base_link.empty() && !group.tip_link.empty()) {
    text += "    <chain base_link=\"" + escapedMarkup(group.base_link) + "\" tip_link=\"" +
            escapedMarkup(group.tip_link) + "\"/>\n";
  } else {
    for (const int joint : group.joints)
      text += "    <joint name=\"" + escapedMarkup(model.joints[static_cast<std::size_t>(joint)].name) + "\"/>\n";
  }
  return text + "  </group>\n";
}

std::string poseText(const RobotModel& model, const std::string& group, const kinematics::NamedPose& pose) {
  std::string text =
      "  <group_state name=\"" + escapedMarkup(pose.name) + "\" group=\"" + escapedMarkup(group) + "\">\n";
  for (std::size_t i = 0; i < model.moving.size(); ++i) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    text += "    <joint name=\"" + escapedMarkup(joint.name) + "\" value=\"" + shortNumber(pose.q[i]) + "\"/>\n";
  }
  return text + "  </group_state>\n";
}

}  // namespace

std::string srdfText(const std::string& name, const RobotModel& model,
                     std::span<const kinematics::DisabledPair> pairs) {
  std::vector<kinematics::JointGroup> groups = model.groups;
  const int tip = model.defaultTip();
  if (groups.empty() && tip > 0)
    groups.push_back({"arm", {}, model.links.front().name, model.links[static_cast<std::size_t>(tip)].name});
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + escapedMarkup(name) + "\">\n";
  for (const kinematics::JointGroup& group : groups) text += groupText(model, group);
  std::vector<kinematics::NamedPose> poses = model.named_poses;
  const bool has_home = std::ranges::any_of(poses, [](const auto& pose) { return pose.name == "home"; });
  if (!has_home) poses.push_back({"home", kinematics::restPositions(model)});
  if (!groups.empty() && model.dof() > 0)
    for (const kinematics::NamedPose& pose : poses) text += poseText(model, groups.front().name, pose);
  for (const kinematics::DisabledPair& pair : pairs) {
    text += "  <disable_collisions link1=\"" + escapedMarkup(model.links[static_cast<std::size_t>(pair.first)].name) +
            "\" link2=\"" + escapedMarkup(model.links[static_cast<std::size_t>(pair.second)].name) + "\" reason=\"" +
            escapedMarkup(pair.reason) + "\"/>\n";
  }
  return text + "</robot>\n";
}

}  // namespace hapticell::workcell
