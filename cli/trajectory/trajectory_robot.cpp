// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_robot.h"

#include <algorithm>
#include <array>
#include <memory>

#include "cli/kit/robot_options.h"
#include "kinematics/model/chain.h"
#include "manipulation/checks/program_configuration.h"

namespace hapticell::cli {

namespace {

using trajectory::Trajectory;

/// s to full speed, assumed where nobody gives an acceleration, and reported; our choice. Half: twice the acceleration
/// asked of the robot; twice: half.
constexpr double kTimeToSpeed = 0.25;
/// m/s, rad/s, assumed for a solid, and reported; our choice. Half, twice: motions take twice or half the time.
constexpr std::array<double, 2> kSolidSpeed{0.5, 2.0};

/// One number for all, or one each.
Expected<std::vector<double>> spread(const std::vector<double>& given, std::size_t count, const char* option) {
  if (given.size() == 1) return std::vector<double>(count, given.front());
  if (given.size() != count) {
    return makeError({.place = Text(option),
                      .found = Text("%1 numbers", given.size()),
                      .expected = Text("one value, or %1", count)});
  }
  return given;
}

/// The robot's speeds for the trajectory's joints, by name or, for columns q1, q2, ..., in order.
Expected<std::vector<double>> speedsOf(const RobotWithTip& robot, const Trajectory& trajectory) {
  std::vector<double> speeds;
  const auto names = robot.jointNames();
  for (std::size_t j = 0; j < trajectory.joint_names.size(); ++j) {
    const std::string& name = trajectory.joint_names[j];
    int index = robot.model.findJoint(name);
    if (index < 0 && name == "q" + std::to_string(j + 1) && j < names.size()) index = robot.model.findJoint(names[j]);
    if (index < 0)
      return makeError({.place = Text("joint '%1'", name),
                        .found = "the robot has no joint of this name",
                        .expected = "names of the robot's joints"});
    const double speed = robot.model.joints[static_cast<std::size_t>(index)].velocity;
    if (!(speed > 0.0)) {
      return makeError(
          {.place = Text("joint '%1'", name), .found = "the robot file has no speed limits", .expected = "--velocity"});
    }
    speeds.push_back(speed);
  }
  return speeds;
}

Expected<std::vector<double>> velocitiesFor(const Trajectory& trajectory, const RobotLimitOptions& options,
                                            std::vector<Text>& assumptions) {
  const std::size_t count = trajectory.hasJoints() ? trajectory.joint_names.size() : 6;
  if (!options.velocity.empty()) return spread(options.velocity, count, "--velocity");
  if (!trajectory.hasJoints()) {
    assumptions.push_back("No speeds were given; 0.5 m/s and 2 rad/s about each axis are used.");
    const auto [linear, angular] = kSolidSpeed;
    return std::vector<double>{linear, linear, linear, angular, angular, angular};
  }
  if (options.robot.empty()) {
    return makeError({.place = "--velocity", .found = "no joint limits", .expected = "--robot or --velocity"});
  }
  const auto robot = readRobotWithTip(options.robot, "");
  HAPTICELL_TRY(robot);
  return speedsOf(*robot, trajectory);
}

}  // namespace

Expected<trajectory::MotionLimits> limitsFor(const Trajectory& trajectory, const RobotLimitOptions& options,
                                             std::vector<Text>& assumptions) {
  trajectory::MotionLimits limits;
  auto velocity = velocitiesFor(trajectory, options, assumptions);
  HAPTICELL_TRY(velocity);
  limits.velocity = std::move(*velocity);
  if (options.acceleration.empty()) {
    for (const double speed : limits.velocity) limits.acceleration.push_back(speed / kTimeToSpeed);
    assumptions.push_back("No accelerations were given; each axis reaches its speed in 0.25 s.");
  } else {
    auto acceleration = spread(options.acceleration, limits.velocity.size(), "--acceleration");
    HAPTICELL_TRY(acceleration);
    limits.acceleration = std::move(*acceleration);
  }
  if (!options.jerk.empty()) {
    auto jerk = spread(options.jerk, limits.velocity.size(), "--jerk");
    HAPTICELL_TRY(jerk);
    limits.jerk = std::move(*jerk);
  }
  return limits;
}

Expected<void> addConfigurations(const Trajectory& trajectory, const std::string& robot_name,
                                 trajectory::ProgramFormat format, trajectory::ProgramOptions& program,
                                 std::vector<Text>& notes) {
  using trajectory::ProgramFormat;
  const bool has_flags =
      format == ProgramFormat::kKrl || format == ProgramFormat::kRapid || format == ProgramFormat::kFanuc;
  if (!has_flags || !trajectory.hasJoints()) return {};
  if (robot_name.empty()) {
    notes.push_back(
        Text("Without --robot, the configuration data are the format's defaults. Check them on the controller."));
    return {};
  }
  const auto robot = readRobotWithTip(robot_name, "");
  HAPTICELL_TRY(robot);
  const auto chain = kinematics::Chain::create(robot->model, robot->tip, Pose::identity());
  HAPTICELL_TRY(chain);
  if (chain->size() != 6) {
    notes.push_back(Text("The robot has no six-axis configuration. The configuration data are the format's defaults."));
    return {};
  }
  const auto shared = std::make_shared<const kinematics::Chain>(*chain);
  program.configuration = manipulation::programConfiguration(shared, format);
  return {};
}

}  // namespace hapticell::cli
