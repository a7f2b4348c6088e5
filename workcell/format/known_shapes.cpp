// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/known_shapes.h"

#include <utility>

#include "workcell/format/entity_format.h"

namespace hapticell::workcell {

namespace {

/// What the shape of an entity comes of; empty: nothing that could be known.
std::string sourceKey(const Json& json) {
  std::string key;
  for (const char* part : {"kind", "source", "mechanism"}) {
    if (const auto found = json.find(part); found != json.end()) key += found->dump() + "\n";
  }
  return key;
}

/// Only what comes of its source: the rest is in the text.
Entity asRead(const Entity& known) {
  Entity fresh;
  fresh.source = known.source;
  fresh.body = known.body;
  if (known.mesh()) fresh.editSolid().proxy = {};
  if (known.robot()) {
    Jointed& jointed = fresh.editJointed();
    jointed.tools.clear();
    jointed.tool.clear();
    jointed.named_poses.clear();
  }
  return fresh;
}

}  // namespace

KnownShapes::KnownShapes(const DocumentState* state, const std::filesystem::path& folder) {
  if (state == nullptr) return;
  for (const auto& entity : state->entities) {
    if (entity->unloaded) continue;
    Json json = jsonFromEntity(*entity, folder);
    by_source_.try_emplace(sourceKey(json), entity.get());
    by_text_.try_emplace(std::move(json), entity.get());
  }
}

const Entity* KnownShapes::same(const Json& entity) const {
  const auto found = by_text_.find(entity);
  return found == by_text_.end() ? nullptr : found->second;
}

std::optional<Entity> KnownShapes::withSameShape(const Json& entity) const {
  if (by_source_.empty()) return std::nullopt;
  const auto found = by_source_.find(sourceKey(entity));
  if (found == by_source_.end()) return std::nullopt;
  return asRead(*found->second);
}

}  // namespace hapticell::workcell
