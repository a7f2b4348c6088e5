// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/pose_csv.h"

#include <cmath>

#include "trajectory/motion/csv_table.h"

namespace hapticell::trajectory {

namespace {

// Of a quaternion's length: files with three decimals read (they are off by less than 1e-3); as trajectory_io.cpp.
// Half: some of those are refused; twice: wrong columns still have lengths far from 1.
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
    return makeError({.file = place.file.string(),
                      .place = Text("line %1, columns qw,qx,qy,qz", place.line),
                      .found = Text("a quaternion of length %1", text(norm)),
                      .expected = "a unit quaternion, w first"});
  }
  return Pose{{row[first], row[first + 1], row[first + 2]}, q / norm};
}

}  // namespace

Expected<std::vector<Pose>> readPoseCsv(const std::filesystem::path& file) {
  const auto table = readCsvTable(file, {"x", "y", "z", "qw", "qx", "qy", "qz"});
  HAPTICELL_TRY(table);
  std::vector<Pose> poses;
  poses.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto pose = poseOf(table->rows[i], 0, {file, table->lines[i]});
    HAPTICELL_TRY(pose);
    poses.push_back(*pose);
  }
  return poses;
}

Expected<std::vector<HandSample>> readHandCsv(const std::filesystem::path& file) {
  const auto table = readCsvTable(file, {"t", "x", "y", "z", "qw", "qx", "qy", "qz"}, {"button"});
  HAPTICELL_TRY(table);
  std::vector<HandSample> samples;
  samples.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const std::vector<double>& row = table->rows[i];
    const std::size_t line = table->lines[i];
    const auto pose = poseOf(row, 1, {file, table->lines[i]});
    HAPTICELL_TRY(pose);
    if (!samples.empty() && !(row[0] > samples.back().t)) {
      return makeError({.file = file.string(),
                        .place = Text("line %1, column '%2'", line, "t"),
                        .found = Text("%1 s", text(row[0])),
                        .expected = Text("a time after that of the line before, %1 s", text(samples.back().t))});
    }
    if (row[8] != 0.0 && row[8] != 1.0) {
      return makeError({.file = file.string(),
                        .place = Text("line %1, column '%2'", line, "button"),
                        .found = text(row[8]),
                        .expected = "0 or 1"});
    }
    samples.push_back({row[0], *pose, row[8] == 1.0});
  }
  return samples;
}

Expected<std::vector<std::vector<double>>> readJointCsv(const std::filesystem::path& file,
                                                        const std::vector<std::string>& joint_names) {
  auto table = readCsvTable(file, joint_names);
  HAPTICELL_TRY(table);
  return std::move(table->rows);
}

}  // namespace hapticell::trajectory
