// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_report.h"

#include <algorithm>
#include <string>

#include "cli/kit/result_writer.h"
#include "cli/trajectory/tool_poses.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"

namespace hapticell::cli {

using nlohmann::ordered_json;
using trajectory::Trajectory;

namespace {

/// What a motion is like, for every command's report.
ordered_json summary(const Trajectory& trajectory) {
  double length = 0.0, turned = 0.0, speed = 0.0;
  dvec3 low(0.0), high(0.0);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const dvec3& p = trajectory[i].X_WT.p;
    low = i == 0 ? p : glm::min(low, p);
    high = i == 0 ? p : glm::max(high, p);
    if (i == 0) continue;
    const auto step = trajectory::distanceBetween(trajectory[i - 1].X_WT, trajectory[i].X_WT);
    length += step.position;
    turned += step.angle;
    speed = std::max(speed, step.position / (trajectory[i].t - trajectory[i - 1].t));
  }
  ordered_json result{
      {"frames", trajectory.size()}, {"duration", trajectory.duration()}, {"length", length}, {"rotation", turned},
      {"max_speed", speed},          {"rms_jerk", rmsJerk(trajectory)}};
  result["bounds"] = {{"min", toJson(low)}, {"max", toJson(high)}};
  return result;
}

}  // namespace

ordered_json distanceJson(const trajectory::PoseDistance& distance) {
  return {{"position", distance.position}, {"angle", distance.angle}};
}

std::size_t posesApart(const Trajectory& trajectory) {
  return static_cast<std::size_t>(std::count_if(trajectory.frames().begin(), trajectory.frames().end(),
                                                [](const auto& frame) { return frame.is_pose_apart; }));
}

void noteApart(const Trajectory& trajectory, ordered_json& notes) {
  if (const std::size_t apart = posesApart(trajectory); apart > 0) {
    notes.push_back("Poses and joints do not agree in " + std::to_string(apart) +
                    " frames (marked pose_apart). To make them agree, use --robot.");
  }
}

Expected<ordered_json> trajectoryInfo(const Trajectory& given, const TrajectoryOptions& options) {
  ordered_json result = summary(given);
  result["name"] = given.name;
  result["entity"] = given.entity;
  result["moved"] = given.moved;
  result["joints"] = given.joint_names;
  result["has_poses"] = given.has_poses;
  result["poses_apart"] = posesApart(given);
  if (!options.limits.robot.empty() && given.hasJoints() && given.has_poses) {
    const auto tool = ToolPoses::create(options.limits.robot, given);
    HAPTICELL_TRY(tool);
    result["pose_off_joints"] = distanceJson(tool->largestError(given));
  }
  const auto tremor = estimateTremor(given);
  result["tremor"] = {{"position", tremor.position}, {"angle", tremor.angle}};
  const auto moving = withoutStillFrames(given, {1e-6, 1e-6});
  result["still_frames"] = given.size() - moving.size();
  std::size_t by_hand = 0;
  for (const auto& frame : given.frames()) by_hand += frame.by_hand ? 1 : 0;
  result["frames_by_hand"] = by_hand;
  result["points"] = ordered_json::array();
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].name) result["points"].push_back({{"frame", i}, {"name", *given[i].name}});
  result["start"] = given.empty() ? ordered_json(nullptr) : ordered_json(given[0].t);
  result["notes"] = options.notes;
  return result;
}

}  // namespace hapticell::cli
