// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/motion_of_robot.h"

#include <algorithm>

#include "cli/trajectory/trajectory_report.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

/// The text of a trajectory by its path's extension; .htraj where there is no path.
Expected<std::string> trajectoryText(const Trajectory& trajectory, const std::string& path, std::string& extension) {
  extension = fs::path(path).extension().string();
  if (path.empty()) extension = ".htraj";
  if (extension == ".csv") return toCsvText(trajectory);
  if (extension == ".htraj" || extension == ".json") return toJsonText(trajectory);
  return makeError({.file = path,
                    .place = "--output",
                    .found = Text("the extension '%1'", extension),
                    .expected = ".htraj, .json or .csv",
                    .fix = "Use trajectory export for other formats."});
}

}  // namespace

Expected<MotionOfRobot> withRobot(const Trajectory& given, const TrajectoryOptions& options,
                                  std::vector<Text>& assumptions) {
  MotionOfRobot result{given, {}};
  if (options.limits.robot.empty() || !given.hasJoints()) return result;
  auto tool = ToolPoses::create(options.limits.robot, given);
  HAPTICELL_TRY(tool);
  if (!given.has_poses) {
    result.motion = tool->posesOf(given);
    assumptions.push_back("The file has no poses. They were computed for the robot's tip in its root link.");
  } else if (!tool->match()) {
    assumptions.push_back(
        "The file's poses do not match its joints for this robot with any base or tool. Poses between given frames are "
        "marked (pose_apart).");
    return result;
  } else if (const std::size_t apart = posesApart(given); apart > 0) {
    result.motion = tool->posesOf(given);
    assumptions.push_back("In " + std::to_string(apart) +
                          " given frames poses and joints do not agree (pose_apart); the joints are used.");
  }
  result.tool = std::move(*tool);
  return result;
}

Expected<Promises> withPosesByJoints(Expected<Promises> promises, const std::optional<ToolPoses>& tool,
                                     const fs::path& written) {
  // m, rad: as kProgramPromise's position: written digits and one more rounding. Half: digits of files fail; twice: 2
  // um off passes.
  constexpr double kSamePose = 1e-6;
  if (!promises || !tool) return promises;
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  const auto off = tool->largestError(*motion);
  promises->list.push_back({"pose_by_joints", kSamePose, std::max(off.position, off.angle), "m or rad"});
  return promises;
}

Expected<void> saveKept(const Trajectory& trajectory, const TrajectoryOptions& options, const MeasureFile& measure,
                        ordered_json& result) {
  std::string extension;
  const auto text = trajectoryText(trajectory, options.output, extension);
  HAPTICELL_TRY(text);
  return writeKept(options.output, *text, extension, options.allow_miss, measure, result);
}

}  // namespace hapticell::cli
