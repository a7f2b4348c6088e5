// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/assembly_solid.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace hapticell::workcell {

DocumentState withAssemblyAsSolid(const DocumentState& state, const std::string& name) {
  const Entity* assembly = state.findByName(name);
  if (!assembly || assembly->kind() != EntityKind::kAssembly) return state;
  const std::vector<EntityId> family = familyOf(state, assembly->id);
  const auto isBelow = [&](EntityId id) { return std::find(family.begin(), family.end(), id) != family.end(); };
  geometry::TriangleMesh mesh = mergedMesh(state, assembly->id);
  const bool all_solid =
      std::none_of(family.begin(), family.end(), [&](EntityId id) { return state.find(id)->robot(); });
  if (mesh.triangles.empty() || !all_solid) return state;
  DocumentState folded = state;
  auto solid = std::make_shared<Entity>(*assembly);
  solid->body = Solid{std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
  std::erase_if(folded.entities, [&](const auto& entity) { return entity->id != solid->id && isBelow(entity->id); });
  for (auto& entity : folded.entities) {
    if (entity->id == solid->id) entity = solid;
  }
  for (PairSet& set : folded.pair_sets) {  // Sets that name a part mean the whole now.
    for (auto* side : {&set.first, &set.second}) {
      for (EntityId id : family) std::replace(side->begin(), side->end(), state.find(id)->name, name);
    }
  }
  return folded;
}

geometry::TriangleMesh mergedMesh(const DocumentState& state, EntityId id) {
  geometry::TriangleMesh whole;
  const Entity* root = state.find(id);
  if (!root) return whole;
  const Pose X_EW = root->X_WE.inverse();
  for (EntityId below : familyOf(state, id)) {
    const Entity& entity = *state.find(below);
    if (entity.mesh()) geometry::append(whole, *entity.mesh(), X_EW * entity.X_WE);
  }
  return whole;
}

}  // namespace hapticell::workcell
