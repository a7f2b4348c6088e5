// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/pose_csv.h"

#include <cmath>

#include "trajectory/motion/csv_table.h"

namespace hapticell::trajectory {

namespace {

constexpr double kUnitTolerance = 1e-3;

std::string text(double value) {
  std::string number = std::to_string(value);
  // std::to_string writes the locale's decimal point.
  for (char& c : number) {
    if (c == ',') c = '.';
  }
  return number;
}

struct Place {
  const std::filesystem::path& file;
  std::size_t line;
};

/// Seven numbers from `first` on.
Expected<Pose> poseOf(const std::vector<double>& row, std::size_t first, const Place& place) {
  const dquat q(row[first + 3], row[first + 4], row[first + 5], row[first + 6]);
  const double norm = glm::length(q);
  if (!(std::abs(norm - 1.0) <= kUnitTolerance)) {
    return makeError({place.file.string(), "line " + std::to_string(place.line) + ", columns qw,qx,qy,qz",
                      "a quaternion of length " + text(norm), "a unit quaternion, w first", ""});
  }
  return Pose{{row[first], row[first + 1], row[first + 2]}, q / norm};
}

}  // namespace

Expected<std::vector<Pose>> readPoseCsv(const std::filesystem::path& file) {
  const auto table = readCsvTable(file, {"x", "y", "z", "qw", "qx", "qy", "qz"});
  if (!table) return tl::unexpected(table.error());
  std::vector<Pose> poses;
  poses.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto pose = poseOf(table->rows[i], 0, {file, table->lines[i]});
    if (!pose) return tl::unexpected(pose.error());
    poses.push_back(*pose);
  }
  return poses;
}

Expected<std::vector<HandSample>> readHandCsv(const std::filesystem::path& file) {
  const auto table = readCsvTable(file, {"t", "x", "y", "z", "qw", "qx", "qy", "qz"}, {"button"});
  if (!table) return tl::unexpected(table.error());
  std::vector<HandSample> samples;
  samples.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const std::vector<double>& row = table->rows[i];
    const std::string line = "line " + std::to_string(table->lines[i]);
    const auto pose = poseOf(row, 1, {file, table->lines[i]});
    if (!pose) return tl::unexpected(pose.error());
    if (!samples.empty() && !(row[0] > samples.back().t)) {
      return makeError({file.string(), line + ", column 't'", text(row[0]) + " s",
                        "a time after that of the row before, " + text(samples.back().t) + " s", ""});
    }
    if (row[8] != 0.0 && row[8] != 1.0) {
      return makeError({file.string(), line + ", column 'button'", text(row[8]), "0 or 1", ""});
    }
    samples.push_back({row[0], *pose, row[8] == 1.0});
  }
  return samples;
}

Expected<std::vector<std::vector<double>>> readJointCsv(const std::filesystem::path& file,
                                                        const std::vector<std::string>& joint_names) {
  auto table = readCsvTable(file, joint_names);
  if (!table) return tl::unexpected(table.error());
  return std::move(table->rows);
}

}  // namespace hapticell::trajectory
