// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/package_command.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "cli/kit/result_writer.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/scratch_folder.h"
#include "manipulation/checks/link_pairs.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/srdf_writer.h"
#include "workcell/robots/urdf_writer.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using kinematics::RobotModel;
using nlohmann::ordered_json;
using workcell::Entity;

/// A name as packages of ROS have them: small letters, digits, underscores.
std::string packageName(const fs::path& folder) {
  std::string name;
  for (const char c : folder.filename().string())
    name += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : '_';
  if (name.empty() || !std::isalpha(static_cast<unsigned char>(name.front()))) name.insert(0, "robot_");
  return name;
}

std::string limitsText(const RobotModel& model) {
  std::string text = "# For MoveIt. The speeds are those of the URDF; accelerations are not known.\njoint_limits:\n";
  for (const int index : model.moving) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(index)];
    text += "  " + ordered_json(joint.name).dump() + ":\n    has_velocity_limits: true\n    max_velocity: " +
            ordered_json(kinematics::greatestSpeed(joint)).dump() +
            "\n    has_acceleration_limits: false\n    max_acceleration: 0.0\n";
  }
  return text;
}

std::string manifestText(const std::string& name) {
  return "<?xml version=\"1.0\"?>\n<package format=\"3\">\n  <name>" + name +
         "</name>\n  <version>0.0.1</version>\n  <description>A robot of a HaptiCell workcell</description>\n"
         "  <maintainer email=\"nobody@example.com\">nobody</maintainer>\n  <license>Proprietary</license>\n"
         "  <buildtool_depend>ament_cmake</buildtool_depend>\n  <exec_depend>robot_state_publisher</exec_depend>\n"
         "  <exec_depend>joint_state_publisher</exec_depend>\n  <exec_depend>rviz2</exec_depend>\n"
         "  <export>\n    <build_type>ament_cmake</build_type>\n  </export>\n</package>\n";
}

std::string buildText(const std::string& name) {
  return "cmake_minimum_required(VERSION 3.8)\nproject(" + name +
         ")\nfind_package(ament_cmake REQUIRED)\ninstall(DIRECTORY urdf config launch DESTINATION "
         "share/${PROJECT_NAME})\nament_package()\n";
}

std::string launchText(const std::string& name) {
  return "from pathlib import Path\n\nfrom ament_index_python.packages import get_package_share_directory\n"
         "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
         "def generate_launch_description():\n    share = Path(get_package_share_directory(\"" +
         name +
         "\"))\n    description = (share / \"urdf/robot.urdf\").read_text()\n    return LaunchDescription([\n"
         "        Node(package=\"robot_state_publisher\", executable=\"robot_state_publisher\",\n"
         "             parameters=[{\"robot_description\": description}]),\n"
         "        Node(package=\"joint_state_publisher\", executable=\"joint_state_publisher\"),\n"
         "        Node(package=\"rviz2\", executable=\"rviz2\"),\n    ])\n";
}

Expected<std::shared_ptr<const Entity>> packagedRobot(const PackageWords& words) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(words.workcell, notes);
  for (const Text& note : notes.warnings) warn(note);
  HAPTICELL_TRY(document);
  std::shared_ptr<const Entity> found;
  int robots = 0;
  for (const auto& entity : document->state().entities) {
    if (!workcell::isMachine(*entity) || (!words.entity.empty() && entity->name != words.entity)) continue;
    found = entity;
    ++robots;
  }
  if (robots == 1) return found;
  return makeError({words.workcell, words.entity.empty() ? Text("robots") : Text("entity '%1'", words.entity),
                    Text("%1 robots", robots), "one robot", "Name it by --entity."});
}

/// The written files in the folder.
Expected<void> writeFiles(const Entity& robot, std::span<const kinematics::DisabledPair> pairs, const fs::path& folder,
                          const std::string& name) {
  Diagnostics notes;
  std::error_code fault;
  fs::create_directories(folder / "urdf", fault);
  fs::create_directories(folder / "config", fault);
  fs::create_directories(folder / "launch", fault);
  if (fault) return makeError({folder.string(), "", systemText(fault.value()), "a folder to write", ""});
  const fs::path urdf = folder / "urdf/robot.urdf";
  HAPTICELL_TRY(workcell::writeUrdf(robot, urdf, notes));
  for (const Text& note : notes.warnings) warn(note);
  auto text = geometry::readRegularFile(urdf);
  HAPTICELL_TRY(text);
  const std::string relative = "filename=\"robot_meshes/", whole = "filename=\"package://" + name + "/urdf/robot_meshes/";
  for (std::size_t at = text->find(relative); at != std::string::npos; at = text->find(relative, at + whole.size()))
    text->replace(at, relative.size(), whole);
  return writeFilesAtomically({{folder / "package.xml", manifestText(name)},
                               {folder / "CMakeLists.txt", buildText(name)},
                               {folder / "launch/display.launch.py", launchText(name)},
                               {folder / "config/joint_limits.yaml", limitsText(*robot.robot())},
                               {folder / "config/robot.srdf", workcell::srdfText(robot.name, *robot.robot(), pairs)},
                               {urdf, *text}});
}

/// What differs between the robot and what was read; empty: nothing that counts.
Text differenceOf(const RobotModel& wanted, const RobotModel& read, std::size_t pairs) {
  if (read.dof() != wanted.dof()) return Text("%1 moving joints instead of %2", read.dof(), wanted.dof());
  for (std::size_t i = 0; i < wanted.dof(); ++i) {
    const kinematics::Joint& a = wanted.joints[static_cast<std::size_t>(wanted.moving[i])];
    const kinematics::Joint& b = read.joints[static_cast<std::size_t>(read.moving[i])];
    const bool limits = a.type == kinematics::JointType::kContinuous || (a.lower == b.lower && a.upper == b.upper);
    if (a.name != b.name || a.type != b.type || !limits) return Text("joint '%1' with other limits", a.name);
  }
  if (read.disabled_pairs.size() != pairs)
    return Text("%1 disabled pairs instead of %2", read.disabled_pairs.size(), pairs);
  std::vector<Pose> X_wanted, X_read;
  kinematics::forwardKinematics(wanted, kinematics::restPositions(wanted), X_wanted);
  kinematics::forwardKinematics(read, kinematics::restPositions(wanted), X_read);
  const int base = read.findLink(wanted.links.front().name);
  for (std::size_t i = 0; i < wanted.links.size() && !wanted.closure; ++i) {
    const int link = read.findLink(wanted.links[i].name);
    if (link < 0 || base < 0) return Text("no link '%1'", wanted.links[i].name);
    const Pose X = X_read[static_cast<std::size_t>(base)].inverse() * X_read[static_cast<std::size_t>(link)];
    if (glm::length(X.p - X_wanted[i].p) > 1e-9) return Text("link '%1' at another place", wanted.links[i].name);
    if (read.links[static_cast<std::size_t>(link)].collisions.size() != wanted.links[i].collisions.size())
      return Text("link '%1' with other shapes", wanted.links[i].name);
  }
  return {};
}

}  // namespace

Expected<ordered_json> writeRosPackage(const PackageWords& words) {
  std::error_code ignored;
  const bool is_taken = fs::exists(words.output, ignored) &&
                        (!fs::is_directory(words.output, ignored) || !fs::is_empty(words.output, ignored));
  if (is_taken) return makeError({words.output, "--output", "a folder that is not empty", "a new folder", ""});
  const auto robot = packagedRobot(words);
  HAPTICELL_TRY(robot);
  const RobotModel& model = *(*robot)->robot();
  const auto use = manipulation::linkPairUse(model, {words.samples, 1});
  const auto pairs = manipulation::pairsWithoutCheck(model, use, words.samples);
  const fs::path place = fs::absolute(words.output).lexically_normal();
  const fs::path folder = place.has_filename() ? place : place.parent_path();
  auto scratch = ScratchFolder::make(folder.parent_path());
  HAPTICELL_TRY(scratch);
  const std::string name = packageName(folder);
  HAPTICELL_TRY(writeFiles(**robot, pairs, scratch->path(), name));
  Diagnostics unheard;
  const auto read = workcell::EntityLoader(scratch->path()).load((scratch->path() / "urdf/robot.urdf").string(), 0.0, unheard);
  HAPTICELL_TRY(read);
  if (const Text difference = differenceOf(model, *read->robot(), pairs.size()); !difference.empty())
    return makeError({folder.string(), "package", difference, "the robot of the cell", "This is a bug. Please report it."});
  HAPTICELL_TRY(scratch->moveTo(folder));
  std::map<std::string, int> reasons;
  for (const kinematics::DisabledPair& pair : pairs) ++reasons[pair.reason];
  return ordered_json{{"package", name},          {"folder", folder.string()},      {"links", model.links.size()},
                      {"joints", model.dof()},    {"checked_pairs", use.size()},    {"samples", words.samples},
                      {"pairs", ordered_json(reasons)}};
}

}  // namespace hapticell::cli
