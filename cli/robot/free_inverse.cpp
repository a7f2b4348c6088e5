// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/command_listener.h"
#include "cli/robot/free_inverse.h"

#include "cli/kit/result_writer.h"
#include "geometry/system/listed.h"
#include "manipulation/checks/inverse_batch.h"
#include "manipulation/scene/scene_service.h"
#include "trajectory/files/pose_csv.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

using manipulation::FreeAnswer;
using nlohmann::ordered_json;

Expected<const workcell::Entity*> robotOf(const workcell::Document& document, const FreeInverseOptions& options) {
  if (options.entity.empty())
    return makeError({.place = "--entity", .found = "no entity", .expected = "the name of a robot of the cell"});
  const workcell::Entity* robot = document.findByName(options.entity);
  if (robot != nullptr) return robot;
  const std::string known = listed(document.state().entities, [](const auto& one) { return one->name; });
  return makeError({.file = options.workcell,
                    .place = "--entity",
                    .found = Text("no entity is named '%1'", options.entity),
                    .expected = Text("one of %1", known)});
}

ordered_json solutionJson(const manipulation::FreeSolution& solution) {
  return {{"joints", solution.joints}, {"configuration", solution.configuration}};
}

ordered_json answerJson(const FreeAnswer& answer, bool all) {
  const bool blocked = answer.status == kinematics::InverseStatus::kSolved && !answer.isFree();
  ordered_json json{{"status", blocked ? "colliding" : toString(answer.status)}, {"checked", answer.checked}};
  if (!answer.isFree()) {
    json["joints"] = nullptr;
  } else {
    json.update(solutionJson(answer.free.front()));
  }
  if (!all) return json;
  json["solutions"] = ordered_json::array();
  for (const auto& solution : answer.free) json["solutions"].push_back(solutionJson(solution));
  return json;
}

/// `per_second`: solutions free of contact that were found in a second of wall time, on all threads;
/// `per_second_a_core`: in a second of one core's time, whatever else the machine did.
ordered_json timingJson(const manipulation::InverseBatch& batch) {
  const auto rate = [&](std::size_t count) {
    return batch.seconds > 0.0 ? static_cast<double>(count) / batch.seconds : 0.0;
  };
  const double of_a_core = batch.cpu_seconds > 0.0 ? static_cast<double>(batch.free) / batch.cpu_seconds : 0.0;
  return {{"seconds", batch.seconds},
          {"threads", batch.threads},
          {"per_second", rate(batch.free)},
          {"per_second_a_core", of_a_core},
          {"checked_per_second", rate(batch.checked)},
          {"poses_per_second", rate(batch.answers.size())}};
}

}  // namespace

void addFreeInverse(Subcommand command, FreeInverseOptions& options) {
  command.flag("--collision-free", options.asked,
               "Only solutions that touch nothing in a cell, with exact meshes: needs --workcell and --entity");
  command.option("--workcell", options.workcell, "Cell for --collision-free (.hcell)").takes(ValueKind::kWorkcell);
  command.option("--entity", options.entity, "Robot of that cell, with its tool; poses are in its root link");
  command.option("--clearance", options.clearance, "Metres that a solution keeps from the cell (default: 0)")
      .within(0.0, 10.0);
  command.flag("--until-missing", options.until_missing, "End at the first pose without a free solution");
  command.option("--jobs", options.jobs, "Threads (default: one a core)").withinWhole(1, 4096);
}

Expected<FreeInverseAnswer> solveFree(const FreeInverseOptions& options, const std::string& poses_file) {
  if (options.workcell.empty())
    return makeError({.place = "--workcell", .found = "no cell", .expected = "a workcell document (.hcell)"});
  const auto poses = trajectory::readPoseCsv(poses_file);
  HAPTICELL_TRY(poses);
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  for (const Text& note : notes.warnings) warn(note);
  HAPTICELL_TRY(document);
  const auto robot = robotOf(*document, options);
  HAPTICELL_TRY(robot);
  auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(*document, {}));
  manipulation::InverseBatchOptions batch_options;
  batch_options.clearance = options.clearance;
  batch_options.until_missing = options.until_missing;
  batch_options.threads = options.jobs;
  batch_options.stop = stopFlag();
  const auto batch = manipulation::freeInverse(std::move(scene), (*robot)->id, *poses, batch_options, {});
  stopWhereAsked();
  HAPTICELL_TRY(batch);
  FreeInverseAnswer answer;
  ordered_json results = ordered_json::array();
  for (const FreeAnswer& one : batch->answers) {
    answer.all_solved = answer.all_solved && one.isFree();
    results.push_back(answerJson(one, options.all));
  }
  answer.all_solved = answer.all_solved && batch->answers.size() == poses->size();
  ordered_json joint_names = ordered_json::array();
  for (const int joint : (*robot)->robot()->moving)
    joint_names.push_back((*robot)->robot()->joints[static_cast<std::size_t>(joint)].name);
  answer.document = {{"robot", (*robot)->name},          {"joint_names", std::move(joint_names)},
                     {"inverse_model", batch->inverse_model}, {"poses", poses->size()},
                     {"checked", batch->checked},        {"free", batch->free},
                     {"results", std::move(results)},    {"timing", timingJson(*batch)}};
  if (!batch->note.empty()) answer.document["note"] = batch->note;
  if (!batch->base_contact.empty()) answer.document["base_contact"] = batch->base_contact;
  return answer;
}

}  // namespace hapticell::cli
