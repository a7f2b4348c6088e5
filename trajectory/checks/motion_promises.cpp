// SPDX-License-Identifier: Apache-2.0
#include "trajectory/checks/motion_promises.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trajectory/checks/motion_measures.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::trajectory_checks {

namespace {

using trajectory::PathTolerance;
using trajectory::Trajectory;

/// m, rad: rounding of numbers in files and of the measuring at some 1e6 times a double's. Half, twice: no effect,
/// tolerances asked for are 1e-6 and more.
constexpr double kRounding = 1e-9;
/// That differences of frames may use of limits: twice what retiming leaves free (kFullUse), for rounding in files.
/// Half: written files may fail their own check; twice: 0.2 % over a limit passes.
constexpr double kOfLimits = 1.001;

Text atTime(double t) {
  return Text("at %1 s", trajectory::shortestText(std::round(1e4 * t) / 1e4));
}

void addDistances(Promises& promises, const Distances& off, const PathTolerance& tolerance, const Trajectory& given,
                  bool poses) {
  const auto add = [&](const char* name, double asked, double measured, const char* unit, double t) {
    promises.list.push_back({name, asked, measured, unit, atTime(t), false, kRounding + 1e-6 * asked});
  };
  if (given.has_poses && poses) {
    add("position", tolerance.position, off.position, "m", off.t_position);
    add("angle", tolerance.angle, off.angle, "rad", off.t_angle);
  }
  if (given.hasJoints() && std::isfinite(tolerance.joint))
    add("joint", tolerance.joint, off.joint, "rad or m", off.t_joint);
}

void addShare(Promises& promises, const char* name, const std::vector<double>& derivatives,
              const std::vector<double>& times, const std::vector<double>& limits) {
  double most = 0.0, t = 0.0;
  for (std::size_t j = 0; j < limits.size() && j < derivatives.size(); ++j) {
    const double share = derivatives[j] / limits[j];
    if (share > most) t = times[j];
    most = std::max(most, share);
  }
  if (!limits.empty()) promises.list.push_back({name, kOfLimits, most, "", atTime(t), false});
}

}  // namespace

Expected<Promises> simplifyPromises(const Trajectory& given, const PathTolerance& tolerance,
                                    const std::filesystem::path& written) {
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  Promises promises;
  promises.help = "Use a larger tolerance.";
  const auto off = passing(given, *motion, {tolerance.position, tolerance.angle, tolerance.joint});
  addDistances(promises, off, tolerance, given, true);
  return promises;
}

Expected<Promises> smoothPromises(const Trajectory& given, const PathTolerance& tolerance,
                                  const std::filesystem::path& written, const PosesByJoints& poses_by_joints) {
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  Promises promises;
  promises.help = "Use a larger tolerance.";
  addDistances(promises, atSameTimes(given, *motion), tolerance, given, true);
  if (!poses_by_joints || !motion->hasJoints() || !given.has_poses) return promises;
  const auto placed = poses_by_joints(*motion);
  HAPTICELL_TRY(placed);
  const Distances off = atSameTimes(given, *placed);
  promises.help = "Use a larger tolerance, or move the motion into the reach of the robot.";
  promises.list.push_back({"tool_position", tolerance.position, off.position, "m", atTime(off.t_position), false,
                           kRounding + 1e-6 * tolerance.position});
  promises.list.push_back({"tool_angle", tolerance.angle, off.angle, "rad", atTime(off.t_angle), false,
                           kRounding + 1e-6 * tolerance.angle});
  return promises;
}

Expected<Promises> retimePromises(const Trajectory& given, const trajectory::RetimingOptions& options,
                                  const RetimeAsked& asked, const std::filesystem::path& written) {
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  Promises promises;
  promises.help = "Use a shorter --sample, a larger --tolerance or other limits.";
  const PathTolerance& near = options.tolerance;
  if (asked.passes) {
    const bool poses =
        !motion->hasJoints() || asked.poses_by_joints || options.mode == trajectory::TimingMode::kConstantSpeed;
    // Poses that were made apart from the joints have no say in where a frame is passed.
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    const auto off =
        passing(given, *motion, {poses ? near.position : kAnywhere, poses ? near.angle : kAnywhere, near.joint});
    addDistances(promises, off, near, given, poses);
  }
  if (options.mode == trajectory::TimingMode::kTimeOptimal) {
    const auto& limits = options.limits;
    const double least = limits.jerk.empty() ? 0.0 : *std::min_element(limits.jerk.begin(), limits.jerk.end());
    const auto derivatives = derivativesOf(*motion, motion->hasJoints(), least);
    addShare(promises, "velocity", derivatives.speed, derivatives.t_speed, limits.velocity);
    addShare(promises, "acceleration", derivatives.acceleration, derivatives.t_acceleration, limits.acceleration);
    addShare(promises, "jerk", derivatives.jerk, derivatives.t_jerk, limits.jerk);
  } else {
    const auto most = greatestSpeed(*motion, options.metres_per_radian);
    promises.list.push_back({"speed", kOfLimits * options.speed, most.speed, "m/s", atTime(most.t), false});
  }
  return promises;
}

Expected<Promises> resamplePromises(const Trajectory& given, const std::filesystem::path& written) {
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  Promises promises;
  // Times of a copy begin at 0.
  Trajectory moved = motion->emptyCopy();
  const double shift = given.empty() || motion->empty() ? 0.0 : given[0].t - (*motion)[0].t;
  for (std::size_t i = 0; i < motion->size(); ++i) {
    Trajectory::Frame frame = (*motion)[i];
    frame.t += shift;
    moved.addFrame(frame, motion->joints(i));
  }
  addDistances(promises, atSameTimes(moved, given), {1e-9, 1e-9, 1e-9}, given, true);
  return promises;
}

Expected<Promises> copyPromises(const Trajectory& given, bool with_poses, double time_tolerance,
                                const std::filesystem::path& written) {
  const auto motion = trajectory::readTrajectory(written);
  HAPTICELL_TRY(motion);
  Promises promises;
  const double lost = std::abs(static_cast<double>(given.size()) - static_cast<double>(motion->size()));
  promises.list.push_back({"frames_lost", 0.0, lost, "frames"});
  if (lost > 0.0) return promises;
  double time = 0.0, pose = 0.0, joint = 0.0;
  const double shift = given.empty() ? 0.0 : given[0].t - (*motion)[0].t;
  for (std::size_t i = 0; i < given.size(); ++i) {
    time = std::max(time, std::abs((*motion)[i].t + shift - given[i].t));
    const auto off = trajectory::distanceBetween((*motion)[i].X_WT, given[i].X_WT);
    pose = std::max({pose, off.position, off.angle});
    for (std::size_t j = 0; j < given.joint_names.size() && j < motion->joint_names.size(); ++j)
      joint = std::max(joint, std::abs(motion->joints(i)[j] - given.joints(i)[j]));
  }
  promises.list.push_back({"time", time_tolerance, time, "s"});
  if (with_poses && given.has_poses) promises.list.push_back({"pose", 1e-9, pose, "m or rad"});
  if (given.hasJoints()) promises.list.push_back({"joint", 1e-12, joint, "rad or m"});
  return promises;
}

}  // namespace hapticell::trajectory_checks
