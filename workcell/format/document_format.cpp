// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/document_format.h"

#include "workcell/format/entity_format.h"
#include "workcell/format/guide_format.h"
#include "workcell/format/pair_format.h"
#include "workcell/format/source_format.h"
#include "workcell/format/state_reader.h"
#include "workcell/format/work_task_format.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

Json jsonFromState(const DocumentState& state, const fs::path& folder) {
  Json json;
  json["format"] = kDocumentFormat;
  json["version"] = kDocumentVersion;
  json["entities"] = Json::array();
  for (const auto& entity : state.entities) json["entities"].push_back(jsonFromEntity(*entity, folder));
  json["pair_sets"] = Json::array();
  for (const PairSet& set : state.pair_sets) json["pair_sets"].push_back(jsonFromPairSet(set));
  if (!state.pair_rules.empty()) json["pair_rules"] = Json::array();
  for (const PairRule& rule : state.pair_rules) json["pair_rules"].push_back(jsonFromPairRule(rule));
  if (!state.guides.empty()) json["guides"] = Json::array();
  for (const Guide& guide : state.guides) json["guides"].push_back(jsonFromGuide(guide));
  if (!state.work_tasks.empty()) json["work_tasks"] = Json::array();
  for (const auto& task : state.work_tasks) json["work_tasks"].push_back(jsonFromWorkTask(task));
  if (state.view) {
    const dvec3 eye = state.view->p_WEye, target = state.view->p_WTarget;
    json["view"] = {{"eye", {eye.x, eye.y, eye.z}}, {"target", {target.x, target.y, target.z}}};
  }
  json["trajectories"] = Json::array();
  for (const TrajectoryReference& reference : state.trajectories) {
    json["trajectories"].push_back({{"name", reference.name}, {"file", relativeName(reference.path, folder)}});
  }
  return json;
}

Expected<DocumentState> stateFromJson(const Json& json, const fs::path& folder, Diagnostics& diagnostics,
                                      const LoadOptions& options) {
  return StateReader(folder, diagnostics, options).read(json);
}

}  // namespace hapticell::workcell
