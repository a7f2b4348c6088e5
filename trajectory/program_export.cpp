// SPDX-License-Identifier: Apache-2.0
#include "trajectory/program_export.h"

#include <algorithm>
#include <cctype>

#include "trajectory/program_writers.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::trajectory {

namespace {

/// The longest name that the controller takes.
std::size_t longestName(ProgramFormat format) {
  switch (format) {
    case ProgramFormat::kKrl:
      return 24;
    case ProgramFormat::kRapid:
      return 32;
    case ProgramFormat::kFanuc:
      return 30;
    case ProgramFormat::kUrScript:
      return 60;
    case ProgramFormat::kVal3:
      return 15;
  }
  return 15;
}

std::string fitName(const std::string& wanted, ProgramFormat format) {
  std::string name;
  for (const char c : wanted) {
    const bool is_fit = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
    name += is_fit ? c : '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) name.insert(0, "p");
  name.resize(std::min(name.size(), longestName(format)));
  if (format == ProgramFormat::kFanuc) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  }
  return name;
}

/// A blend must not reach into a neighbour's.
std::vector<double> blendsOf(const Trajectory& trajectory, double wanted) {
  std::vector<double> blends(trajectory.size(), 0.0);
  for (std::size_t i = 1; i + 1 < trajectory.size(); ++i) {
    if (trajectory[i].dwell > 0.0) continue;
    const double before = glm::length(trajectory[i].X_WT.p - trajectory[i - 1].X_WT.p);
    const double after = glm::length(trajectory[i + 1].X_WT.p - trajectory[i].X_WT.p);
    blends[i] = std::min(wanted, 0.45 * std::min(before, after));
  }
  return blends;
}

}  // namespace

std::string ProgramInput::configurationAt(std::size_t i) const {
  return options.configuration && hasJoints() ? options.configuration(trajectory.joints(i)) : std::string();
}

std::string numberList(std::initializer_list<double> values, int decimals, std::string_view separator) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += separator;
    text += fixedText(value, decimals);
  }
  return text;
}

std::string jointList(std::span<const double> joints, int decimals, double unit, std::string_view separator) {
  std::string text;
  for (const double joint : joints) {
    if (!text.empty()) text += separator;
    text += fixedText(joint * unit, decimals);
  }
  return text;
}

Expected<std::vector<ProgramFile>> exportProgram(const Trajectory& trajectory, ProgramFormat format,
                                                 const ProgramOptions& options) {
  if (trajectory.empty()) return makeError({"", "frames", "none", "at least one frame", ""});
  if (trajectory.hasJoints() && trajectory.joint_names.size() != 6) {
    return makeError({"", "joints", std::to_string(trajectory.joint_names.size()) + " joints", "six, or none",
                      "Export it as csv, json or ros."});
  }
  const bool has_values = options.speed > 0.0 && options.acceleration > 0.0 && options.blend >= 0.0 &&
                          options.joint_speed > 0.0 && options.joint_speed <= 1.0;
  if (!has_values) {
    return makeError({"", "speed, acceleration, blend", "a value outside its range",
                      "positive speeds, a joint speed up to 1, a blend from 0", ""});
  }
  const std::string name = fitName(options.name.empty() ? trajectory.name : options.name, format);
  const ProgramInput input{trajectory, options, name, blendsOf(trajectory, options.blend)};
  switch (format) {
    case ProgramFormat::kKrl:
      return writeKrl(input);
    case ProgramFormat::kRapid:
      return writeRapid(input);
    case ProgramFormat::kFanuc:
      return writeFanuc(input);
    case ProgramFormat::kUrScript:
      return writeUrScript(input);
    case ProgramFormat::kVal3:
      return writeVal3(input);
  }
  return std::vector<ProgramFile>{};
}

std::vector<ProgramFile> placedProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                       const std::filesystem::path& wanted) {
  std::vector<ProgramFile> placed;
  for (const ProgramFile& file : files) {
    const std::filesystem::path name(file.name);
    std::filesystem::path path = wanted;
    if (format == ProgramFormat::kVal3) {
      path = wanted / name.filename();
    } else if (files.size() > 1 || !path.has_extension()) {
      path.replace_extension(name.extension());
    }
    placed.push_back({path.string(), file.content});
  }
  return placed;
}

}  // namespace hapticell::trajectory
