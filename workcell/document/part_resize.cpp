// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/part_resize.h"

#include "workcell/entity/built_in_parts.h"

namespace hapticell::workcell {

Expected<std::vector<Command>> resizePart(const DocumentState& state, EntityId id, const std::vector<double>& sizes) {
  const Entity* entity = state.find(id);
  const BuiltInPart* part =
      entity ? findBuiltInPart(entity->source.path.substr(0, entity->source.path.find(':'))) : nullptr;
  if (part == nullptr || !entity->mesh() || partSizes(entity->source).empty())
    return makeError({.place = entity ? Text("'%1'", entity->name) : Text("size"),
                      .found = "not a built-in part",
                      .expected = "a built-in part, such as a box, a table or a bench"});
  auto fresh = makeBuiltInPart(partSource(*part, sizes), 1.0);
  HAPTICELL_TRY(fresh);
  const double rise = fresh->mesh()->bounds().max.z - entity->mesh()->bounds().max.z;
  std::vector<Command> commands{ReplaceShape{id, std::move(*fresh)}};
  if (part->origin != BuiltInPart::Origin::kFloor || rise == 0.0) return commands;
  const dvec3 up = entity->X_WE.rotate({0.0, 0.0, rise});
  for (const auto& other : state.entities) {
    if (other->attachment.to != entity->name) continue;
    Pose there = other->X_WE;
    there.p += up;
    commands.emplace_back(SetPlacement{other->id, there});
  }
  return commands;
}

}  // namespace hapticell::workcell
