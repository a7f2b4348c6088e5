// SPDX-License-Identifier: Apache-2.0
#include "trajectory/ros_trajectory.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "trajectory/csv_table.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::trajectory {

namespace {

constexpr double kMostNanoseconds = 9e18;  ///< That a 64-bit count holds.

std::string list(std::span<const double> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + shortestText(values[i]);
  return text + "]";
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

/// The items between the brackets of "key: [a, b]".
std::vector<std::string> items(const std::string& line) {
  const auto open = line.find('[');
  const auto close = line.rfind(']');
  std::vector<std::string> result;
  if (open == std::string::npos || close == std::string::npos || close < open) return result;
  std::stringstream stream(line.substr(open + 1, close - open - 1));
  std::string item;
  while (std::getline(stream, item, ',')) {
    const auto first = item.find_first_not_of(" '\"");
    if (first == std::string::npos) continue;
    result.push_back(item.substr(first, item.find_last_not_of(" '\"") - first + 1));
  }
  return result;
}

/// Line by line: the message is flat enough that its keys tell where a line belongs.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : name_(file.string()), stream_(file) {}

  Expected<Trajectory> read() {
    if (!stream_) return makeError({name_, "", "the file cannot be opened", "a JointTrajectory in YAML", ""});
    std::string line;
    while (std::getline(stream_, line)) {
      ++line_number_;
      if (auto taken = take(line); !taken) return tl::unexpected(taken.error());
    }
    if (auto ended = endPoint(); !ended) return tl::unexpected(ended.error());
    if (trajectory_.joint_names.empty()) return fault("no joint_names", "a JointTrajectory in YAML");
    return std::move(trajectory_);
  }

 private:
  tl::unexpected<Error> fault(const std::string& found, const std::string& expected) const {
    return makeError({name_, "line " + std::to_string(line_number_), found, expected, ""});
  }

  Expected<void> take(const std::string& line) {
    const auto first = line.find_first_not_of(" -");
    if (first == std::string::npos || line[first] == '#') return {};
    const auto colon = line.find(':', first);
    const std::string key = colon == std::string::npos ? "" : line.substr(first, colon - first);
    const std::string rest = colon == std::string::npos ? "" : line.substr(colon + 1);
    if (key == "joint_names") {
      if (in_point_ || !trajectory_.empty())
        return fault("joint_names after a point", "joint_names once, before points");
      in_names_ = rest.find('[') == std::string::npos;
      trajectory_.joint_names = items(line);
      return {};
    }
    if (key.empty() && in_names_) {  // A point ends the names, so none follows one.
      trajectory_.joint_names.push_back(line.substr(first, line.find_last_not_of(" '\"\r") - first + 1));
      return {};
    }
    in_names_ = false;
    if (key == "positions") return takePositions(line);
    if (auto taken = takeTime(line, "nanosec:", 1); !taken) return taken;
    return takeTime(line, "sec:", 1'000'000'000);
  }

  Expected<void> takePositions(const std::string& line) {
    if (auto ended = endPoint(); !ended) return ended;
    for (const std::string& item : items(line)) {
      const auto number = parseNumber(item);
      if (!number) return fault("'" + item + "'", "a number");
      positions_.push_back(*number);
    }
    if (positions_.size() != trajectory_.joint_names.size()) {
      return fault(std::to_string(positions_.size()) + " positions",
                   std::to_string(trajectory_.joint_names.size()) + ", one a joint");
    }
    in_point_ = true;
    nanoseconds_ = 0;
    return {};
  }

  /// Whole numbers of seconds and nanoseconds, on lines of their own or in one: `{sec: 1, nanosec: 5}`.
  Expected<void> takeTime(const std::string& line, const std::string& key, std::int64_t unit_ns) {
    auto found = line.find(key);
    if (found != std::string::npos && found > 0 && line[found - 1] == 'o') found = line.find(key, found + key.size());
    if (!in_point_ || found == std::string::npos) return {};
    const auto begin = found + key.size();
    const auto end = line.find_first_of(",}", begin);
    const auto number = parseNumber(line.substr(begin, end == std::string::npos ? end : end - begin));
    if (!number || *number != std::floor(*number) || std::abs(*number) > 1e10) {
      return fault("a time that is no whole number", "whole seconds and nanoseconds");
    }
    if (std::abs(static_cast<double>(nanoseconds_) + static_cast<double>(unit_ns) * *number) > kMostNanoseconds) {
      return fault("a time of " + shortestText(*number) + " s", "at most 9e9 s");
    }
    nanoseconds_ += unit_ns * static_cast<std::int64_t>(*number);
    return {};
  }

  Expected<void> endPoint() {
    if (!in_point_) return {};
    in_point_ = false;
    const double time = static_cast<double>(nanoseconds_) / 1e9;
    if (!trajectory_.addFrame({time, Pose::identity()}, positions_)) {
      return fault("a time_from_start of " + shortestText(time) + " s", "times that increase");
    }
    positions_.clear();
    return {};
  }

  std::string name_;
  std::ifstream stream_;
  std::size_t line_number_ = 0;
  Trajectory trajectory_;
  bool in_names_ = false;
  bool in_point_ = false;
  std::vector<double> positions_;
  std::int64_t nanoseconds_ = 0;
};

}  // namespace

Expected<std::string> toRosText(const Trajectory& trajectory) {
  if (!trajectory.hasJoints()) {
    return makeError({"", "joints", "none", "a robot's trajectory", "Export its poses as csv or json instead."});
  }
  std::string text =
      "# trajectory_msgs/msg/JointTrajectory; rad, m, s\nheader:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: ''\n";
  text += "joint_names:\n";
  for (const std::string& joint : trajectory.joint_names) text += "- " + joint + "\n";
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

Expected<Trajectory> readRosTrajectory(const std::filesystem::path& file) {
  auto trajectory = Reader(file).read();
  if (trajectory) trajectory->name = file.stem().string();
  return trajectory;
}

}  // namespace hapticell::trajectory
