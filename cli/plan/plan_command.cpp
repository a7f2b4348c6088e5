// SPDX-License-Identifier: Apache-2.0
#include "cli/plan/plan_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/kept_result.h"
#include "cli/kit/result_writer.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/listed.h"
#include "geometry/system/scratch_folder.h"
#include "manipulation/scene/scene_service.h"
#include "planning/axis_motions.h"
#include "planning/plan.h"
#include "planning/timed_plan.h"
#include "planning/written_plan.h"
#include "trajectory/files/pose_csv.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/csv_table.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct PlanOptions {
  std::string workcell, entity, hand, to, to_frame, to_joints, through, output;
  std::vector<std::string> through_frames;
  bool out = false, keep_axes = false;
  double clearance = 0.005, time = 10.0;
  int seed = 1, jobs = 0;
};

/// How much of the slack the corners are rounded off by, one after the other until the written file keeps the
/// clearance; the last is exact but rests at corners.
constexpr double kRoundings[] = {1.0, 0.4, 0.1};

Expected<std::vector<double>> numbersOf(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = trajectory::parseNumber(std::string_view(text).substr(begin, end - begin));
    if (!number)
      return makeError(
          {.place = Text(option), .found = "'" + text + "'", .expected = "finite numbers separated by commas"});
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

Expected<Pose> poseOf(const std::string& option, const std::string& text) {
  const auto numbers = numbersOf(option, text);
  HAPTICELL_TRY(numbers);
  const std::vector<double>& n = *numbers;
  Pose pose;
  if (n.size() == 7) pose = {{n[0], n[1], n[2]}, dquat(n[3], n[4], n[5], n[6])};
  // A quaternion typed with three digits is within this of length 1. Half: such ones are refused; twice: slips pass.
  constexpr double kNearlyUnit = 1e-2;
  if (n.size() != 7 || std::abs(glm::length(pose.q) - 1.0) > kNearlyUnit)
    return makeError({.place = Text(option),
                      .found = "'" + text + "'",
                      .expected = "x,y,z,qw,qx,qy,qz: metres and a quaternion of length 1"});
  pose.q = glm::normalize(pose.q);
  return pose;
}

/// The pose of a frame of the cell, of an entity's frame, or of an entity, by its name.
Expected<Pose> framePose(const std::string& option, const std::string& name, const planning::Problem& problem) {
  const auto found = problem.scene->findFrame(name);
  if (found.entity == nullptr)
    return makeError({.place = Text(option),
                      .found = Text("no frame is named '%1'", name),
                      .expected = "a frame of the cell or of an entity"});
  return found.entity->X_WE * found.X_EF;
}

/// `problem` has its scene, for frames.
Expected<planning::Goal> goalOf(const PlanOptions& options, const planning::Problem& problem) {
  if (!options.to_frame.empty()) {
    const auto pose = framePose("--to-frame", options.to_frame, problem);
    HAPTICELL_TRY(pose);
    return planning::Goal(planning::goal::ToPose{*pose});
  }
  if (options.out) return planning::Goal(planning::goal::OutOfCell{});
  if (!options.to_joints.empty()) {
    auto joints = numbersOf("--to-joints", options.to_joints);
    HAPTICELL_TRY(joints);
    return planning::Goal(planning::goal::ToJoints{std::move(*joints)});
  }
  const auto pose = poseOf("--to", options.to);
  HAPTICELL_TRY(pose);
  return planning::Goal(planning::goal::ToPose{*pose});
}

/// What can be said of the options without the cell.
Expected<void> checkOptions(const PlanOptions& options) {
  const auto count = [](const std::string& option) { return option.empty() ? 0 : 1; };
  const int given = count(options.to) + count(options.to_frame) + count(options.to_joints) + (options.out ? 1 : 0);
  if (given != 1)
    return makeError({.place = "--to, --to-frame, --to-joints, --out",
                      .found = Text("%1 goals", given),
                      .expected = "exactly one of these options"});
  if (const auto extension = std::filesystem::path(options.output).extension();
      extension != ".htraj" && extension != ".csv")
    return makeError({.file = options.output,
                      .place = "--output",
                      .found = Text("the extension '%1'", extension.string()),
                      .expected = ".htraj or .csv"});
  return {};
}

Expected<planning::Problem> problemOf(const PlanOptions& options) {
  HAPTICELL_TRY(checkOptions(options));
  planning::Problem problem;
  problem.clearance = options.clearance;
  problem.seed = static_cast<std::uint64_t>(options.seed);
  problem.time_limit_s = options.time;
  problem.threads = options.jobs;
  problem.leaves_contact = true;
  if (!options.through.empty()) {
    auto poses = trajectory::readPoseCsv(options.through);
    HAPTICELL_TRY(poses);
    problem.through = std::move(*poses);
  }
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  for (const Text& note : notes.warnings) warn(note);
  HAPTICELL_TRY(document);
  const workcell::Entity* entity = document->findByName(options.entity);
  if (entity == nullptr) {
    const std::string known = listed(document->state().entities, [](const auto& one) { return one->name; });
    return makeError({.file = options.workcell,
                      .place = "--entity",
                      .found = Text("no entity is named '%1'", options.entity),
                      .expected = Text("one of %1", known)});
  }
  problem.entity = entity->id;
  problem.with_axes = entity->figure() == nullptr && !options.keep_axes;
  if (!options.hand.empty()) problem.hand = options.hand == "left" ? mannequin::Side::kLeft : mannequin::Side::kRight;
  problem.scene = manipulation::SceneService().prepare(manipulation::sourceOf(*document, {}));
  auto goal = goalOf(options, problem);
  HAPTICELL_TRY(goal);
  problem.goal = std::move(*goal);
  // Joints of the robot alone say that its axes stay.
  const auto* joints = std::get_if<planning::goal::ToJoints>(&problem.goal);
  if (joints != nullptr && entity->robot() && joints->joints.size() == entity->robot()->dof()) problem.with_axes = false;
  for (const std::string& name : options.through_frames) {
    const auto pose = framePose("--through-frame", name, problem);
    HAPTICELL_TRY(pose);
    problem.through.push_back(*pose);
  }
  return problem;
}

ordered_json poseJson(const Pose& X) {
  return {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z};
}

ordered_json headJson(const planning::PlanResult& result, const PlanOptions& options) {
  ordered_json json{{"solved", result.isSolved()}, {"entity", options.entity}, {"time_s", result.seconds}};
  if (!result.note.empty()) json["notes"] = {result.note};
  return json;
}

ordered_json failureJson(const planning::PlanResult& result, const PlanOptions& options) {
  const planning::Failure& failure = *result.failure;
  ordered_json json = headJson(result, options);
  json["length"] = nullptr;
  json["clearance_min_m"] = nullptr;
  json["checks"] = result.checks;
  json["reason"] = failure.reason;
  json["constraint"] = planning::toString(failure.kind);
  json["blocked_by"] = failure.blocked_by.empty() ? ordered_json(nullptr) : ordered_json(failure.blocked_by);
  json["nearest"] = nullptr;
  if (failure.nearest) {
    json["nearest"] = {{"pose", poseJson(*failure.X_WT_nearest)}, {"distance", failure.nearest_distance}};
    if (!failure.nearest->joints.empty()) json["nearest"]["joints"] = failure.nearest->joints;
  }
  return json;
}

/// What begins or ends in contact, or nearer than the clearance, and until when.
void addTight(const std::vector<planning::TightPair>& tight, ordered_json& json) {
  for (const planning::TightPair& one : tight) {
    json[one.is_reached ? "reached" : "left"].push_back(
        {{"moved", one.moved}, {"met", one.met}, {"gap_m", one.gap}, {one.is_reached ? "from_s" : "until_s", one.t}});
    json["notes"].push_back(one.text());
  }
}

std::string textOf(const trajectory::Trajectory& motion, const std::filesystem::path& file) {
  return file.extension() == ".csv" ? toCsvText(motion) : toJsonText(motion);
}

/// Files that belong together: those of the axes' motions, then that of the entity.
using PlanFiles = std::vector<FileToWrite>;

/// "path-rail.htraj" for the axis "rail" beside "path.htraj"; what does not belong in a file's name becomes "_", and a
/// name that another axis has already gets a number.
std::filesystem::path fileOfAxis(const std::filesystem::path& output, std::string axis, const PlanFiles& others) {
  for (char& letter : axis) {
    if (std::string_view("/\\:*?\"<>|").find(letter) != std::string_view::npos) letter = '_';
  }
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? axis : axis + "-" + std::to_string(number);
    const auto file = output.parent_path() / (output.stem().string() + "-" + name + output.extension().string());
    const auto isTaken = [&](const FileToWrite& other) { return other.path == file; };
    if (std::none_of(others.begin(), others.end(), isTaken)) return file;
  }
}

Expected<std::vector<std::filesystem::path>> writeInto(const std::filesystem::path& folder, const PlanFiles& files) {
  std::vector<std::filesystem::path> written;
  for (const FileToWrite& file : files) {
    written.push_back(folder / (std::to_string(written.size()) + file.path.extension().string()));
    HAPTICELL_TRY(writeFileAtomically(written.back(), file.content));
  }
  return written;
}

/// All or none: the entity's file is measured with those of the axes before the first is written.
Expected<void> writeAll(PlanFiles files, const std::string& text, const PlanOptions& options,
                        const MeasureFile& measure, ordered_json& json) {
  if (files.empty()) return writeKept(options.output, text, ".htraj", false, measure, json);
  const std::filesystem::path output = options.output;
  if (auto kept = writeKept("", text, output.extension().string(), false, measure, json); !kept) {
    Error missed = kept.error();
    if (missed.file.empty()) missed.file = options.output;
    return makeError(std::move(missed));
  }
  files.push_back({output, text});
  return writeFilesAtomically(files);
}

/// Times the plan and writes it, once the files as written keep what was asked.
Expected<ordered_json> writePlan(const planning::PlanResult& result, const planning::FreeSpace& space,
                                 const planning::Problem& problem, const PlanOptions& options) {
  const planning::Plan& plan = *result.plan;
  ordered_json json = headJson(result, options);
  json["length"] = plan.length;
  Expected<void> written;
  for (const double rounding : kRoundings) {
    const auto motion = planning::timedMotion(plan, space, {.sample_s = 0.01, .rounding = rounding});
    HAPTICELL_TRY(motion);
    auto motions = planning::motionsOfEntities(*motion, space);
    PlanFiles axes;
    // What was recorded together has one take, and no other plan has it; equal plans still give equal files.
    const std::string take = "plan " + workcell::contentName(toJsonText(*motion)).substr(0, 12);
    for (std::size_t k = 1; k < motions.size(); ++k) {
      motions.front().take = motions[k].take = take;
      const auto file = fileOfAxis(options.output, motions[k].entity, axes);
      axes.push_back({file, textOf(motions[k], file)});
    }
    const auto folder = ScratchFolder::make();
    HAPTICELL_TRY(folder);
    const auto trials = writeInto(folder->path(), axes);
    HAPTICELL_TRY(trials);
    double clearance = 0.0;
    std::vector<planning::TightPair> tight;
    const auto measure = [&](const std::filesystem::path& file) -> Expected<Promises> {
      auto check =
          planning::checkWrittenPlan({file, *trials}, plan, options.clearance, problem.scene, problem.entity);
      HAPTICELL_TRY(check);
      clearance = check->promises.list.front().measured;
      tight = std::move(check->tight);
      return std::move(check->promises);
    };
    written = writeAll(axes, textOf(motions.front(), options.output), options, measure, json);
    if (!written) continue;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      json["axes"].push_back({{"entity", motions[k + 1].entity},
                              {"joints", motions[k + 1].joint_names},
                              {"output", axes[k].path.string()}});
    }
    json["clearance_min_m"] = clearance;
    addTight(tight, json);
    json["checks"] = result.checks;
    json["planner"] = result.planner;
    json["waypoints"] = plan.waypoints.size();
    json["duration_s"] = motion->duration();
    json["frames"] = motion->size();
    json["output"] = options.output;
    return json;
  }
  return tl::unexpected(written.error());
}

ExitStatus run(const PlanOptions& options, const ResultWriter& writer) {
  const auto fails = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  const auto problem = problemOf(options);
  if (!problem) return fails(problem.error());
  const auto space = planning::FreeSpace::create(problem->scene, problem->entity, {}, {}, problem->hand,
                                                 problem->with_axes);
  if (!space) return fails(space.error());
  const auto result = planning::plan(*problem, *space);
  if (!result) return fails(result.error());
  const auto json = result->isSolved() ? writePlan(*result, *space, *problem, options)
                                       : Expected<ordered_json>(failureJson(*result, options));
  if (!json) return fails(json.error());
  const auto written = writer.write(*json);
  if (!written) return fails(written.error());
  if (result->isSolved()) return ExitStatus::kDone;
  warn(Text("no plan: %1", result->failure->reason));
  return ExitStatus::kCheckFound;
}

}  // namespace

void addPlanCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("plan", "Plan a collision-free motion of a robot, a solid or a mannequin's hand in a cell");
  const auto options = std::make_shared<PlanOptions>();
  command.option("--workcell", options->workcell, "Cell (.hcell)").takes(ValueKind::kWorkcell).required();
  command.option("--entity", options->entity, "Robot, mechanism, mannequin or solid that moves").required();
  command.option("--hand", options->hand, "Hand of a mannequin that moves to the goal; its feet stay")
      .among({"left", "right"});
  command.option("--to", options->to,
                 "Goal: x,y,z,qw,qx,qy,qz of the tool centre point, of a solid's frame, or of the grip of the hand");
  command.option("--to-frame", options->to_frame, "Goal: this frame of the cell or of an entity, by its name");
  command.option("--to-joints", options->to_joints,
                 "Goal: joints of a robot, q1,q2,… (rad, m); those of its external axes first, or left out if they stay");
  command.flag("--keep-axes", options->keep_axes, "External axes that carry the robot (a rail, a table) stay");
  command.flag("--out", options->out, "Goal: the solid out of the box around everything else");
  command.option("--through", options->through, "Poses that the motion passes, in this order").takes(ValueKind::kTable);
  command.option("--through-frame", options->through_frames,
                 "Frames by their names that the motion passes, in this order, after the poses of --through");
  command.option("--clearance", options->clearance, "Clearance that the motion keeps from the cell, m (default: 0.005)")
      .within(0.0, 10.0);
  command.option("--seed", options->seed, "Equal seeds give equal motions (default: 1)").withinWhole(0, 2'000'000'000);
  command.option("--time", options->time, "Time limit of the search, s (default: 10)")
      .within(0.0, 86'400.0);
  command.option("--jobs", options->jobs, "Threads; the motion does not depend on it (default: one a core)")
      .withinWhole(0, 4096);
  command.option("-o,--output", options->output, "Motion to write (.htraj or .csv)")
      .takes(ValueKind::kMotion)
      .required();
  command.onChosen([options, &chosen] { chosen = [options](ResultWriter& writer) { return run(*options, writer); }; });
}

}  // namespace hapticell::cli
