// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_check.h"

#include <chrono>
#include <cmath>
#include <memory>

#include "cli/kit/result_writer.h"
#include "cli/trajectory/motion_file.h"
#include "manipulation/checks/kept_free.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/scene/scene_service.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

using manipulation::PathFinding;
using nlohmann::ordered_json;

ordered_json findingJson(const PathFinding& finding) {
  ordered_json json{{"kind", manipulation::toString(finding.kind)}, {"t_in", finding.t_in}, {"t_out", finding.t_out}};
  if (finding.kind == PathFinding::Kind::kCollision) {
    json["pair"] = {finding.first, finding.second};
    json["point"] = cli::toJson(finding.p_W);
    return json;
  }
  if (finding.kind == PathFinding::Kind::kConfiguration) {
    json["change"] = finding.first;
    return json;
  }
  if (!finding.first.empty()) json["joint"] = finding.first;
  if (finding.kind != PathFinding::Kind::kSingularity) json["beyond"] = finding.worst;
  return json;
}

ordered_json listOf(const std::vector<PathFinding>& findings) {
  ordered_json list = ordered_json::array();
  for (const PathFinding& finding : findings) list.push_back(findingJson(finding));
  return list;
}

Expected<manipulation::PathCheckOptions> pathOptions(const TrajectoryCheckOptions& options,
                                                     const trajectory::Trajectory& trajectory) {
  manipulation::PathCheckOptions path;
  const std::string& moved_by = options.moved_by.empty() ? trajectory.moved : options.moved_by;
  if (moved_by.empty()) return path;
  auto parsed = manipulation::parseMovedBy(moved_by);
  HAPTICELL_TRY(parsed);
  path.hold.moved_by = std::move(*parsed);
  return path;
}

/// What a motion goes through.
struct Cell {
  workcell::Document document;
  std::shared_ptr<const manipulation::PreparedScene> scene;
  manipulation::PathCheckOptions path;
  std::string entity;
};

/// Motions on the same clock as this one: those that were named, and those of the cell that were recorded with it.
Expected<std::vector<std::shared_ptr<const trajectory::Trajectory>>> motionsTogether(
    const trajectory::Trajectory& trajectory, const workcell::Document& document,
    const TrajectoryCheckOptions& options) {
  std::vector<std::shared_ptr<const trajectory::Trajectory>> motions;
  for (const std::string& file : options.together) {
    auto motion = readMotionFile(file);
    HAPTICELL_TRY(motion);
    if (motion->entity.empty())
      return makeError({.file = file,
                        .place = "--together",
                        .found = "a motion that does not name what moves",
                        .expected = "a motion that names its entity (.htraj)"});
    motions.push_back(std::make_shared<const trajectory::Trajectory>(std::move(*motion)));
  }
  if (trajectory.take.empty()) return motions;
  for (const workcell::TrajectoryReference& reference : document.state().trajectories) {
    auto motion = trajectory::readTrajectory(reference.path);
    if (!motion) {
      warn(motion.error().message());
    } else if (motion->take == trajectory.take && motion->entity != trajectory.entity) {
      motions.push_back(std::make_shared<const trajectory::Trajectory>(std::move(*motion)));
    }
  }
  return motions;
}

Expected<Cell> cellFor(const trajectory::Trajectory& trajectory, const TrajectoryCheckOptions& options) {
  Diagnostics notes;
  auto document = workcell::loadDocument(options.workcell, notes);
  for (const Text& note : notes.warnings) warn(note);
  HAPTICELL_TRY(document);
  auto path = pathOptions(options, trajectory);
  HAPTICELL_TRY(path);
  const std::string& name = options.entity.empty() ? trajectory.entity : options.entity;
  if (name.empty())
    return makeError({.place = "--entity",
                      .found = "the trajectory does not name the entity that moves",
                      .expected = "the name of an entity"});
  auto axes = motionsTogether(trajectory, *document, options);
  HAPTICELL_TRY(axes);
  path->axes = std::move(*axes);
  auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(*document, {}));
  return Cell{std::move(*document), std::move(scene), std::move(*path), name};
}

KeptFreeResult resultOf(manipulation::KeptFree kept) {
  ordered_json report{{"checks", kept.checks}, {"findings", listOf(kept.check.findings)}};
  report["nearer"] = ordered_json::array();
  for (const auto& nearer : kept.nearer)
    report["nearer"].push_back({{"t_in", nearer.t_in}, {"t_out", nearer.t_out}, {"share", nearer.share}});
  return {std::move(kept.trajectory), std::move(report)};
}

}  // namespace

Expected<KeptFreeResult> keepFree(const trajectory::Trajectory& given, trajectory::Trajectory processed,
                                  const TrajectoryCheckOptions& options) {
  const auto cell = cellFor(given, options);
  HAPTICELL_TRY(cell);
  trajectory::Trajectory recording = given;
  recording.entity = processed.entity = cell->entity;
  if (const workcell::Entity* entity = cell->document.findByName(cell->entity)) {
    auto consistent = manipulation::jointsFromPoses(*entity, processed);
    HAPTICELL_TRY(consistent);
    if (!recording.has_poses) {
      auto posed = manipulation::posesFromJoints(*entity, recording);
      HAPTICELL_TRY(posed);
      recording = std::move(*posed);
    }
    processed = std::move(*consistent);
  }
  auto kept = manipulation::keptFree(cell->scene, recording, processed, cell->path, {});
  HAPTICELL_TRY(kept);
  KeptFreeResult result = resultOf(std::move(*kept));
  if (const workcell::Entity* entity = cell->document.findByName(cell->entity); entity && entity->robot()) {
    result.poses_by_joints = [robot = std::make_shared<const workcell::Entity>(*entity)](const auto& motion) {
      return manipulation::posesFromJoints(*robot, motion);
    };
  }
  return result;
}

Expected<KeptFreeResult> retimeFree(const trajectory::Trajectory& given, const trajectory::RetimingOptions& retiming,
                                    const TrajectoryCheckOptions& options, trajectory::RetimingReport& report) {
  const auto cell = cellFor(given, options);
  HAPTICELL_TRY(cell);
  trajectory::Trajectory named = given;
  named.entity = cell->entity;
  auto made = manipulation::retimedFree(cell->scene, named, retiming, cell->path, {});
  HAPTICELL_TRY(made);
  report = made->report;
  return resultOf(std::move(made->kept));
}

void addCheckOptions(Subcommand command, TrajectoryCheckOptions& options) {
  command.option("--workcell", options.workcell, "Cell to move through (.hcell)")
      .takes(ValueKind::kWorkcell)
      .required();
  command.option("--entity", options.entity, "Entity that moves (default: from the trajectory)");
  command.option("--moved-by", options.moved_by,
                 "How it is moved: tcp, base, self_origin, ... (default: from the trajectory)");
  command.option(
      "--together", options.together,
      "Motions of the axes that carry the robot, on the same clock (those of the same take in the cell are included)");
  command.flag("--fail-on-contact", options.fail_on_contact, "Exit 1 if a collision is found");
  command.flag("--fail-on-limit", options.fail_on_limit, "Exit 1 if a limit is exceeded");
}

Expected<ordered_json> checkTrajectory(const trajectory::Trajectory& trajectory,
                                       const TrajectoryCheckOptions& options) {
  const auto cell = cellFor(trajectory, options);
  HAPTICELL_TRY(cell);

  const auto begin = std::chrono::steady_clock::now();
  const auto result = manipulation::checkPath(cell->scene, cell->entity, trajectory, cell->path, {});
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  HAPTICELL_TRY(result);

  bool has_contact = false, has_limit = false;
  for (const PathFinding& finding : result->findings) {
    const bool is_contact = finding.kind == PathFinding::Kind::kCollision;
    has_contact = has_contact || is_contact;
    const bool is_told_only =
        finding.kind == PathFinding::Kind::kSingularity || finding.kind == PathFinding::Kind::kConfiguration;
    has_limit = has_limit || (!is_contact && !is_told_only);
  }
  ordered_json json{{"frames", trajectory.size()},
                    {"free", !has_contact},
                    {"within_limits", !has_limit},
                    {"findings", listOf(result->findings)},
                    {"touching_at_start", listOf(result->touching_at_start)}};
  const bool is_near = std::isfinite(result->least_clearance);
  json["least_clearance"] = is_near ? ordered_json(result->least_clearance) : ordered_json(nullptr);
  if (is_near) json["nearest"] = {{"pair", {result->nearest_first, result->nearest_second}}, {"t", result->t_nearest}};
  json["notes"] = result->notes;
  json["timing"] = {{"check_ms", took.count()}};
  json["found"] = (options.fail_on_contact && has_contact) || (options.fail_on_limit && has_limit);
  return json;
}

}  // namespace hapticell::cli
