// SPDX-License-Identifier: Apache-2.0
#include "workcell/robot_reader.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "workcell/sdf_reader.h"
#include "workcell/srdf.h"
#include "workcell/xacro.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

std::string lowerExtension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string headOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(65536, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

}  // namespace

std::optional<RobotFormat> robotFormatOf(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  const std::string extension = lowerExtension(file), head = headOf(file);
  if (extension == ".toml") return RobotFormat::kToml;
  const std::size_t begin = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (begin == std::string::npos || head[begin] != '<') return std::nullopt;
  if (extension == ".xacro") return RobotFormat::kXacro;
  if (head.find("<robot") != std::string::npos) {
    const bool xacro = extension != ".urdf" && head.find("<xacro:") != std::string::npos;
    return xacro ? RobotFormat::kXacro : RobotFormat::kUrdf;
  }
  if (extension == ".sdf" || extension == ".world" || head.find("<sdf") != std::string::npos) return RobotFormat::kSdf;
  return extension == ".urdf" ? std::optional(RobotFormat::kUrdf) : std::nullopt;
}

const char* formatName(RobotFormat format) {
  switch (format) {
    case RobotFormat::kXacro:
      return "xacro";
    case RobotFormat::kSdf:
      return "sdf";
    case RobotFormat::kToml:
      return "toml";
    case RobotFormat::kUrdf:
      break;
  }
  return "urdf";
}

Expected<TomlRobot> readRobot(const fs::path& file, Diagnostics& diagnostics, ImportMonitor* monitor,
                              RobotContent content) {
  const RobotFormat format = robotFormatOf(file).value_or(RobotFormat::kUrdf);  // Whose reader says what it is instead.
  if (format == RobotFormat::kToml) return readRobotToml(file, diagnostics);
  Expected<kinematics::RobotModel> model = [&]() -> Expected<kinematics::RobotModel> {
    if (format == RobotFormat::kSdf) return readSdf(file, diagnostics);
    if (format == RobotFormat::kUrdf) return readUrdf(file, diagnostics, monitor, content);
    const auto expanded = expandXacro(file);
    if (!expanded) return makeError(expanded.error());
    return readUrdfText(*expanded, file, diagnostics, monitor, content);
  }();
  if (!model) return makeError(model.error());
  TomlRobot robot;
  robot.model = std::move(*model);
  robot.sheet.name = robot.model.name;
  if (const auto srdf = format == RobotFormat::kSdf ? std::nullopt : findSrdf(file, robot.model.name)) {
    if (auto read = readSrdf(*srdf, robot.model, diagnostics); !read) return makeError(read.error());
  }
  return robot;
}

}  // namespace hapticell::workcell
