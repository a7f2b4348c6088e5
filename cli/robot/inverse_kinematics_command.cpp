// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cli/kit/command_listener.h"
#include "cli/kit/result_writer.h"
#include "cli/kit/robot_options.h"
#include "cli/kit/timing.h"
#include "cli/robot/free_inverse.h"
#include "cli/robot/robot_commands.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/solution_list.h"
#include "trajectory/files/pose_csv.h"
#include "trajectory/motion/csv_table.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct InverseOptions {
  std::string robot;
  std::string poses;
  std::string tip;
  AxisOptions axes;
  std::string start;
  bool all = false;
  bool turns_once = false;
  bool fail_on_limit = false;
  FreeInverseOptions free;
};

Expected<std::vector<double>> readStart(const InverseOptions& options, const RobotWithTip& robot) {
  std::vector<double> q = kinematics::restPositions(robot.model);
  if (options.start.empty()) return q;
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= options.start.size();) {
    const std::size_t end = std::min(options.start.find(',', begin), options.start.size());
    const auto number = trajectory::parseNumber(std::string_view(options.start).substr(begin, end - begin));
    if (!number)
      return makeError(
          {.place = "--start", .found = "'" + options.start + "'", .expected = "finite numbers separated by commas"});
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (numbers.size() != robot.variables.size()) {
    return makeError(
        {.place = "--start",
         .found = Text("%1 numbers", numbers.size()),
         .expected = Text("%1, one for each joint that moves the tip, base first", robot.variables.size())});
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) q[static_cast<std::size_t>(robot.variables[i])] = numbers[i];
  return q;
}

/// Told, not refused: zeros are beyond the limits of many robots, and the answers do not depend on it.
std::vector<Text> beyondLimits(const RobotWithTip& robot, const std::vector<double>& q) {
  std::vector<Text> warnings;
  for (const int variable : robot.variables) {
    const auto index = static_cast<std::size_t>(variable);
    const kinematics::Joint& joint = robot.model.joints[static_cast<std::size_t>(robot.model.moving[index])];
    // rad or m beyond a limit: numbers typed with six digits. Half: 1.5708 for a limit of pi / 2 is refused; twice:
    // 2e-6 beyond passes.
    constexpr double kRounding = 1e-6;
    if (q[index] >= joint.lower - kRounding && q[index] <= joint.upper + kRounding) continue;
    warnings.push_back(Text("--start: joint '%1' at %2 is beyond its limits of %3 to %4", joint.name,
                            shortNumber(q[index]), shortNumber(joint.lower), shortNumber(joint.upper)));
  }
  return warnings;
}

ordered_json chainPositions(const RobotWithTip& robot, const std::vector<double>& q) {
  ordered_json joints = ordered_json::array();
  for (const int variable : robot.variables) joints.push_back(q[static_cast<std::size_t>(variable)]);
  return joints;
}

/// A search finds most solutions, not surely all: the answer itself is listed whether the search came upon it or not.
ordered_json alternatives(const RobotWithTip& robot, const std::vector<kinematics::ListedSolution>& all,
                          const kinematics::InverseSolution& answer) {
  // rad or m: a search finds the answer again but for its own error (kSameSearched of numeric_search.cpp). Half: it may
  // be listed twice; twice: two that nearly meet are one.
  constexpr double kSame = 1e-4;
  const auto isAnswer = [&](const kinematics::ListedSolution& one) {
    return std::equal(one.q.begin(), one.q.end(), answer.q.begin(), answer.q.end(),
                      [](double a, double b) { return std::abs(a - b) < kSame; });
  };
  ordered_json solutions = ordered_json::array();
  const auto add = [&](const std::vector<double>& joints, const std::string& configuration, bool within_limits) {
    const std::string unnamed = "solution " + std::to_string(solutions.size() + 1);
    solutions.push_back({{"joints", chainPositions(robot, joints)},
                         {"configuration", configuration.empty() ? unnamed : configuration},
                         {"within_limits", within_limits}});
  };
  if (answer.status == kinematics::InverseStatus::kSolved && std::none_of(all.begin(), all.end(), isAnswer)) {
    add(answer.q, "", true);
  }
  for (const kinematics::ListedSolution& one : all) {
    add(one.q, one.configuration, one.within_limits);
    if (!one.maker_flags.empty()) solutions.back()["maker_flags"] = one.maker_flags;
    if (!one.reason.empty()) solutions.back()["reason"] = english(one.reason);
  }
  return solutions;
}

struct Answer {
  ordered_json document;
  bool all_solved = true;
};

/// `timing`, with `per_second`: poses answered in a second.
ordered_json timingWithRate(const Timing& timing, std::size_t poses, double seconds) {
  ordered_json json = timing.toJson();
  json["per_second"] = seconds > 0.0 ? static_cast<double>(poses) / seconds : 0.0;
  return json;
}

Expected<Answer> solve(const InverseOptions& options) {
  if (options.robot.empty())
    return makeError({.place = "--robot",
                      .found = "no robot",
                      .expected = "a robot's file or library:NAME, or --collision-free with --workcell and --entity"});
  auto robot = readRobotWithTip(options.robot, options.tip, workcell::RobotContent::kKinematics);
  HAPTICELL_TRY(robot);
  HAPTICELL_TRY(addExternalAxes(options.axes, *robot));
  const auto poses = trajectory::readPoseCsv(options.poses);
  HAPTICELL_TRY(poses);
  const auto start = readStart(options, *robot);
  HAPTICELL_TRY(start);
  const std::vector<Text> warnings = options.start.empty() ? std::vector<Text>{} : beyondLimits(*robot, *start);
  for (const Text& warning : warnings) warn(warning);
  const auto inverse = kinematics::createInverse(robot->model, robot->tip);
  HAPTICELL_TRY(inverse);

  Answer answer;
  ordered_json results = ordered_json::array();
  Timing timing;
  timing.reserve(poses->size());
  std::vector<double> previous = *start;
  const auto all_begin = Timing::Clock::now();
  for (const Pose& X_BT : *poses) {
    stopWhereAsked();
    const auto begin = Timing::Clock::now();
    const kinematics::InverseSolution solution = (*inverse)->solve(X_BT, previous);
    timing.add(begin);
    ordered_json result{{"status", toString(solution.status)},
                        {"singular", solution.singular},
                        {"joints", chainPositions(*robot, solution.q)},
                        {"position_error", solution.position_error},
                        {"orientation_error", solution.orientation_error}};
    if (options.all) {
      kinematics::SolutionListOptions listing;
      listing.with_turns = !options.turns_once;
      const auto all = kinematics::listSolutions(robot->model, **inverse, X_BT, previous, listing);
      result["solutions"] = alternatives(*robot, all, solution);
    }
    results.push_back(std::move(result));
    answer.all_solved = answer.all_solved && solution.status == kinematics::InverseStatus::kSolved;
    previous = solution.q;
  }
  const double seconds = std::chrono::duration<double>(Timing::Clock::now() - all_begin).count();
  answer.document = {
      {"root", robot->model.links[0].name}, {"tip", robot->model.links[static_cast<std::size_t>(robot->tip)].name},
      {"joint_names", robot->jointNames()}, {"inverse_model", (*inverse)->name()},
      {"results", std::move(results)},      {"timing", timingWithRate(timing, poses->size(), seconds)}};
  if (!warnings.empty()) answer.document["warnings"] = warnings;
  return answer;
}

Expected<Answer> solveAsked(const InverseOptions& options) {
  if (!options.free.asked) return solve(options);
  FreeInverseOptions free = options.free;
  free.all = options.all;
  auto answer = solveFree(free, options.poses);
  HAPTICELL_TRY(answer);
  return Answer{std::move(answer->document), answer->all_solved};
}

ExitStatus run(const InverseOptions& options, const ResultWriter& writer) {
  const auto answer = solveAsked(options);
  const auto written = answer ? writer.write(answer->document) : Expected<void>(tl::unexpected<Error>(answer.error()));
  if (!written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return options.fail_on_limit && !answer->all_solved ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

}  // namespace

void addInverseKinematicsCommand(Subcommand app, Action& chosen) {
  Subcommand command =
      app.add("ik", "Compute joint positions that bring a robot's tip to poses, each closest to the one before");
  const auto options = std::make_shared<InverseOptions>();
  command.option("--robot", options->robot, "Robot: a file, or library:NAME").takes(ValueKind::kRobot);
  command.option("--poses", options->poses, "CSV with x,y,z,qw,qx,qy,qz: poses of the tip in the root link")
      .takes(ValueKind::kTable)
      .required();
  command.option("--tip", options->tip, "Link of the tip (default: the tool or the end of the arm)");
  command.option("--on", options->axes.on, "External axes that carry the robot: FILE[,link=L][,pose=x,y,z,qw,qx,qy,qz]")
      .takes(ValueKind::kRobot);
  command
      .option("--part-on", options->axes.part_on,
              "The same for the positioner that carries the part: poses are then in its link, and pose is its own")
      .takes(ValueKind::kRobot);
  command.option("--start", options->start,
                 "Joint positions before the first pose, separated by commas, base first (default: zeros)");
  command.flag("--all", options->all, "List all solutions of each pose, including full turns within the limits");
  command.flag("--turns-once", options->turns_once, "With --all: list each solution only with its closest turns");
  addFreeInverse(command, options->free);
  command.flag("--fail-on-limit", options->fail_on_limit, "Exit 1 if a pose is not solved");
  command.onChosen([options, &chosen] { chosen = [options](ResultWriter& writer) { return run(*options, writer); }; });
}

}  // namespace hapticell::cli
