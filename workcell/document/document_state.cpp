// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/document_state.h"

#include <unordered_map>
#include <unordered_set>

namespace hapticell::workcell {

bool isCarriedBy(const DocumentState& state, const Entity& entity, EntityId carrier) {
  const Entity* at = &entity;
  // No more steps than entities: documents that were read may hang in circles.
  for (std::size_t step = 0; at != nullptr && step <= state.entities.size(); ++step) {
    if (at->id == carrier) return true;
    at = at->attachment.to.empty() ? nullptr : state.findByName(at->attachment.to);
  }
  return false;
}

std::vector<EntityId> familyOf(const DocumentState& state, EntityId id) {
  const Entity* root = state.find(id);
  std::vector<EntityId> family;
  if (!root) return family;
  std::unordered_map<std::string_view, std::vector<const Entity*>> below;
  for (const auto& entity : state.entities) {
    if (!entity->parent.empty()) below[entity->parent].push_back(entity.get());
  }
  std::unordered_set<EntityId> known{id};
  std::vector<const Entity*> open{root};
  while (!open.empty()) {
    const Entity* parent = open.back();
    open.pop_back();
    family.push_back(parent->id);
    const auto children = below.find(parent->name);
    if (children == below.end()) continue;
    for (const Entity* child : children->second) {
      if (known.insert(child->id).second) open.push_back(child);
    }
  }
  return family;
}

const Entity* DocumentState::find(EntityId id) const {
  for (const auto& entity : entities) {
    if (entity->id == id) return entity.get();
  }
  return nullptr;
}

const Entity* DocumentState::findByName(std::string_view name) const {
  for (const auto& entity : entities) {
    if (entity->name == name) return entity.get();
  }
  return nullptr;
}

const ergonomics::WorkTask* DocumentState::findWorkTask(std::string_view name) const {
  for (const ergonomics::WorkTask& task : work_tasks) {
    if (task.name == name) return &task;
  }
  return nullptr;
}

const ergonomics::WorkTask* DocumentState::workTaskOf(std::string_view mannequin) const {
  const ergonomics::WorkTask* anybody = nullptr;
  for (const ergonomics::WorkTask& task : work_tasks) {
    if (!task.mannequin.empty() && task.mannequin == mannequin) return &task;
    if (task.mannequin.empty() && !anybody) anybody = &task;
  }
  return anybody;
}

const Guide* DocumentState::findGuide(std::string_view name) const {
  for (const Guide& guide : guides) {
    if (guide.name == name) return &guide;
  }
  return nullptr;
}

const TrajectoryReference* DocumentState::findTrajectory(std::string_view name) const {
  for (const TrajectoryReference& trajectory : trajectories) {
    if (trajectory.name == name) return &trajectory;
  }
  return nullptr;
}

const PairSet* DocumentState::findPairSet(std::string_view name) const {
  for (const PairSet& set : pair_sets) {
    if (set.name == name) return &set;
  }
  return nullptr;
}

}  // namespace hapticell::workcell
