// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_cell.h"

#include <utility>

#include "agents/task/agent_section.h"
#include "agents/wishes/agent.h"
#include "manipulation/scene/scene_service.h"
#include "workcell/format/document_io.h"

namespace hapticell::agents {

const char* toString(RunMode mode) {
  constexpr const char* kWords[] = {"operator", "agents", "both"};
  return kWords[static_cast<std::size_t>(mode)];
}

AgentCell::AgentCell() = default;
AgentCell::~AgentCell() = default;

Expected<std::shared_ptr<const AgentCell>> AgentCell::load(const std::filesystem::path& file,
                                                           const config::Configuration& configuration) {
  auto task = AgentTask::read(file);
  HAPTICELL_TRY(task);
  Diagnostics diagnostics;
  const auto document = workcell::loadDocument(task->cell, diagnostics);
  HAPTICELL_TRY(document);
  auto scene =
      manipulation::SceneService().prepare(manipulation::sourceOf(*document, manipulation::pairDefaults(configuration)));
  std::shared_ptr<AgentCell> cell(new AgentCell());
  cell->task_ = std::move(*task);
  cell->scene_ = std::move(scene);
  cell->notes_ = std::move(diagnostics.warnings);
  HAPTICELL_TRY(cell->prepare(configuration));
  return cell;
}

Expected<std::shared_ptr<const AgentCell>> AgentCell::create(AgentTask task,
                                                             std::shared_ptr<const manipulation::PreparedScene> scene,
                                                             const config::Configuration& configuration) {
  std::shared_ptr<AgentCell> cell(new AgentCell());
  cell->task_ = std::move(task);
  cell->scene_ = std::move(scene);
  HAPTICELL_TRY(cell->prepare(configuration));
  return cell;
}

Expected<void> AgentCell::prepare(const config::Configuration& configuration) {
  const auto lacking = [&](Text place, const std::string& name) {
    return makeError({.file = task_.file.string(),
                      .place = std::move(place),
                      .found = Text("no entity is named '%1'", name),
                      .expected = "an entity of the cell"});
  };
  entity_ = scene_->find(task_.entity);
  if (entity_ == nullptr) return lacking(std::string("entity"), task_.entity);
  if (!task_.goal.look_at.empty()) {
    const workcell::Entity* seen = scene_->find(task_.goal.look_at);
    if (seen == nullptr) return lacking(std::string("look_at"), task_.goal.look_at);
    look_at_ = seen->id;
  }
  auto body = MovedBody::create(*entity_, task_.moved_by);
  HAPTICELL_TRY(body);
  start_ = std::move(*body);
  auto clearances = Clearances::create(scene_, entity_->id, start_->configuration(), configuration);
  HAPTICELL_TRY(clearances);
  clearances_ = std::make_unique<const Clearances>(std::move(*clearances));
  for (const NearPair& pair : clearances_->touchingAtStart()) {
    if (start_->isFixed(pair.link)) continue;
    return makeError({.file = task_.file.string(),
                      .place = Text("entity '%1'", task_.entity),
                      .found = Text("%1 are in contact at the start", clearances_->wordsOf(pair)),
                      .expected = "a start free of contact",
                      .fix = "Move them apart by a millimetre, or leave the pair out by a rule of the cell."});
  }
  if (!clearances_->note().empty()) notes_.push_back(clearances_->note());
  return tryAgents();
}

Expected<void> AgentCell::tryAgents() const {
  for (const AgentSection& section : task_.agents) {
    const auto agent = makeAgent({section, task_, *start_, look_at_, clearances_->obstacles(), 0});
    HAPTICELL_TRY(agent);
  }
  return {};
}

}  // namespace hapticell::agents
