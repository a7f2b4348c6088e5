// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_smoothing.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/trajectory/motion_of_robot.h"
#include "cli/trajectory/trajectory_report.h"
#include "trajectory/checks/motion_measures.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

Expected<trajectory::PathTolerance> toleranceOf(const TrajectoryOptions& options) {
  if (!(options.tolerance > 0.0) || !(options.angle_tolerance > 0.0) || !(options.joint_tolerance >= 0.0)) {
    return makeError({.place = "--tolerance, --angle-tolerance",
                      .found = "a value that is not above 0",
                      .expected = "metres and radians"});
  }
  const double joint = options.joint_tolerance > 0.0 ? options.joint_tolerance : options.tolerance;
  return trajectory::PathTolerance{options.tolerance, options.angle_tolerance, joint};
}

/// Joints and poses smoothed each by itself; with the robot the joints alone, as closely as its tool needs.
trajectory::Smoothed smoothWith(const Trajectory& given, trajectory::PathTolerance tolerance,
                                const std::optional<ToolPoses>& tool) {
  // Rounds with 0.4 of the joints' tolerance each: to a 250th. Half: to a 16th, some robots' tools leave the tolerance;
  // twice: time.
  constexpr int kTries = 6;
  const trajectory::PathTolerance asked = tolerance;
  for (int round = 0;; ++round, tolerance.joint *= 0.4) {
    auto result = trajectory::smoothed(given, {tolerance});
    if (!tool) return result;
    result.trajectory = tool->posesOf(result.trajectory);
    const auto off = trajectory_checks::atSameTimes(given, result.trajectory);
    result.report.max_deviation = {off.position, off.angle};
    result.report.rms_jerk_after = rmsJerk(result.trajectory);
    if (round == kTries || asked.shareOf({off.position, off.angle}) <= 1.0) return result;
  }
}

}  // namespace

Expected<ordered_json> simplifyTrajectory(const Trajectory& given, const TrajectoryOptions& options) {
  const auto tolerance = toleranceOf(options);
  HAPTICELL_TRY(tolerance);
  const Trajectory few = simplified(given, *tolerance);
  const auto deviation = largestDeviation(given, few);
  ordered_json result{
      {"frames_before", given.size()}, {"frames_after", few.size()}, {"max_deviation", distanceJson(deviation.pose)}};
  if (given.hasJoints()) result["max_joint_deviation"] = deviation.joint;
  const auto measure = [&](const fs::path& file) {
    return trajectory_checks::simplifyPromises(given, *tolerance, file);
  };
  HAPTICELL_TRY(saveKept(few, options, measure, result));
  return result;
}

Expected<ordered_json> smoothTrajectory(const Trajectory& file, const TrajectoryOptions& options) {
  const auto tolerance = toleranceOf(options);
  HAPTICELL_TRY(tolerance);
  std::vector<Text> assumptions;
  const auto with = withRobot(file, options, assumptions);
  HAPTICELL_TRY(with);
  const Trajectory& given = with->motion;
  trajectory::PathTolerance asked = *tolerance;
  // In the cell the joints are found for the poses, by the inverse model.
  if (!options.check.workcell.empty()) asked.joint = std::numeric_limits<double>::infinity();
  auto result = smoothWith(given, *tolerance, options.check.workcell.empty() ? with->tool : std::nullopt);
  ordered_json kept = nullptr;
  trajectory_checks::PosesByJoints placed;
  if (!options.check.workcell.empty()) {
    auto free = keepFree(given, std::move(result.trajectory), options.check);
    HAPTICELL_TRY(free);
    result.trajectory = std::move(free->trajectory);
    kept = std::move(free->report);
    placed = std::move(free->poses_by_joints);
  }
  const auto& report = result.report;
  ordered_json json{{"frames", given.size()},
                    {"spans", report.spans},
                    {"frames_drawn_back", report.frames_drawn_back},
                    {"max_deviation", distanceJson(report.max_deviation)},
                    {"rms_deviation", report.rms_deviation},
                    {"rms_jerk_before", report.rms_jerk_before},
                    {"rms_jerk_after", report.rms_jerk_after}};
  json["tremor"] = {{"position", report.tremor.position}, {"angle", report.tremor.angle}};
  if (!kept.is_null()) json["kept_free"] = std::move(kept);
  json["assumptions"] = assumptions;
  json["warnings"] = ordered_json::array();
  if (report.tremor_exceeds_tolerance) {
    json["warnings"].push_back("Hand tremor is larger than the tolerance, so much of it remains.");
  }
  if (report.frames_drawn_back > 0) {
    json["warnings"].push_back(std::to_string(report.frames_drawn_back) +
                               " frames are at the edge of the tolerance. The motion is not smooth there.");
  }
  noteApart(result.trajectory, json["warnings"]);
  const auto measure = [&](const fs::path& written) {
    return withPosesByJoints(trajectory_checks::smoothPromises(given, asked, written, placed),
                             options.check.workcell.empty() ? with->tool : std::nullopt, written);
  };
  HAPTICELL_TRY(saveKept(result.trajectory, options, measure, json));
  return json;
}

}  // namespace hapticell::cli
