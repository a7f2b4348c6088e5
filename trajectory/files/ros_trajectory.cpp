// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/ros_trajectory.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "trajectory/motion/number_text.h"

namespace hapticell::trajectory {

namespace {

std::string list(std::span<const double> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + shortestText(values[i]);
  return text + "]";
}

/// Quoted where YAML would take it for something else.
std::string yamlText(const std::string& name) {
  const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '/' || c == '.';
  });
  if (is_plain && std::isalpha(static_cast<unsigned char>(name.front())) != 0) return name;
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? "''" : std::string(1, c);
  return text + "'";
}

std::vector<double> velocitiesAt(const Trajectory& trajectory, std::size_t i) {
  std::vector<double> velocities(trajectory.joint_names.size(), 0.0);
  // Programs start and end at rest.
  if (i == 0 || i + 1 >= trajectory.size()) return velocities;
  const auto before = trajectory.joints(i - 1);
  const auto after = trajectory.joints(i + 1);
  const double dt = trajectory[i + 1].t - trajectory[i - 1].t;
  for (std::size_t j = 0; j < velocities.size(); ++j) velocities[j] = (after[j] - before[j]) / dt;
  return velocities;
}

}  // namespace

Expected<std::string> toRosText(const Trajectory& trajectory) {
  if (!trajectory.hasJoints()) {
    return makeError({.place = "joints",
                      .found = "none",
                      .expected = "the trajectory of a robot",
                      .fix = "Export the poses as csv or json instead."});
  }
  std::string text =
      "# trajectory_msgs/msg/JointTrajectory; rad, m, s\nheader:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: ''\n";
  text += "joint_names:\n";
  for (const std::string& joint : trajectory.joint_names) text += "- " + yamlText(joint) + "\n";
  text += "points:\n";
  const double start = trajectory.empty() ? 0.0 : trajectory[0].t;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const auto nanoseconds = std::llround((trajectory[i].t - start) * 1e9);
    text += "- positions: " + list(trajectory.joints(i)) + "\n";
    text += "  velocities: " + list(velocitiesAt(trajectory, i)) + "\n";
    text += "  accelerations: []\n  effort: []\n  time_from_start:\n";
    text += "    sec: " + std::to_string(nanoseconds / 1'000'000'000) + "\n";
    text += "    nanosec: " + std::to_string(nanoseconds % 1'000'000'000) + "\n";
  }
  return text;
}

}  // namespace hapticell::trajectory
