// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_retiming.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/trajectory/motion_of_robot.h"
#include "cli/trajectory/trajectory_report.h"
#include "manipulation/checks/kept_free.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

Expected<trajectory::RetimingOptions> retimingOf(const Trajectory& given, const TrajectoryOptions& options,
                                                 std::vector<Text>& assumptions) {
  trajectory::RetimingOptions retiming;
  retiming.sample_s = options.sample;
  retiming.speed = options.speed;
  if (!(options.sample > 0.0))
    return makeError({.place = "--sample", .found = "a value that is not above 0", .expected = "seconds"});
  if (!(options.passing > 0.0) || !(options.angle_passing > 0.0))
    return makeError({.place = "--tolerance, --angle-tolerance",
                      .found = "a value that is not above 0",
                      .expected = "metres and radians"});
  retiming.tolerance = {options.passing, options.angle_passing, options.angle_passing};
  if (options.mode == "constant-speed") {
    retiming.mode = trajectory::TimingMode::kConstantSpeed;
    if (!options.limits.acceleration.empty()) retiming.acceleration = options.limits.acceleration.front();
  } else if (options.mode == "time-optimal") {
    auto limits = limitsFor(given, options.limits, assumptions);
    HAPTICELL_TRY(limits);
    retiming.limits = std::move(*limits);
  } else {
    return makeError(
        {.place = "--mode", .found = "'" + options.mode + "'", .expected = "time-optimal or constant-speed"});
  }
  return retiming;
}

ordered_json retimingJson(const trajectory::Retimed& made) {
  const auto& report = made.report;
  return {{"duration_before", report.duration_before},
          {"duration_after", report.duration_after},
          {"frames", made.trajectory.size()},
          {"still_frames", report.still_frames},
          {"rests_at_corners", report.corners},
          {"sample", report.sample_s},
          {"max_deviation", distanceJson(report.max_deviation)},
          {"max_joint_deviation", report.max_joint_deviation},
          {"limit_use",
           {{"velocity", report.use.velocity}, {"acceleration", report.use.acceleration}, {"jerk", report.use.jerk}}}};
}

}  // namespace

Expected<ordered_json> retimeTrajectory(const Trajectory& file, const TrajectoryOptions& options) {
  std::vector<Text> assumptions;
  const auto with = withRobot(file, options, assumptions);
  HAPTICELL_TRY(with);
  const Trajectory& given = with->motion;
  const auto asked = retimingOf(given, options, assumptions);
  HAPTICELL_TRY(asked);
  ordered_json kept = nullptr;
  trajectory_checks::PosesByJoints by_tool;
  if (with->tool) by_tool = [&](const Trajectory& motion) { return Expected<Trajectory>(with->tool->posesOf(motion)); };
  auto result = manipulation::retimedByJoints(given, *asked, by_tool);
  HAPTICELL_TRY(result);
  trajectory::Retimed made = std::move(*result);
  if (!options.check.workcell.empty()) {
    auto free = retimeFree(given, *asked, options.check, made.report);
    HAPTICELL_TRY(free);
    made.trajectory = std::move(free->trajectory);
    kept = std::move(free->report);
  }
  const bool drawn = !kept.is_null() && !kept["nearer"].empty();
  if (made.report.corners > 0) {
    assumptions.push_back("The motion stops at " + std::to_string(made.report.corners) +
                          " corners, because no continuous motion passes them within the tolerance.");
  }
  if (made.report.sample_s < 0.9 * options.sample)
    assumptions.push_back(
        "Frames are closer together than --sample, so that the motion between them stays on the path.");
  ordered_json json = retimingJson(made);
  json["assumptions"] = assumptions;
  noteApart(made.trajectory, json["assumptions"]);
  if (!kept.is_null()) json["kept_free"] = std::move(kept);
  const auto& tool = with->tool;
  const auto measure = [&](const fs::path& written) {
    return withPosesByJoints(trajectory_checks::retimePromises(given, *asked, {!drawn, tool.has_value()}, written),
                             tool, written);
  };
  HAPTICELL_TRY(saveKept(made.trajectory, options, measure, json));
  return json;
}

}  // namespace hapticell::cli
