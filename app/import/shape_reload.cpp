// SPDX-License-Identifier: Apache-2.0
#include "app/import/shape_reload.h"

#include <algorithm>
#include <filesystem>

#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::app {

using workcell::Entity;

ShapeReload reloadShapes(const workcell::DocumentState& state, const std::vector<std::string>& paths,
                         workcell::ImportMonitor& monitor) {
  ShapeReload result;
  workcell::EntityLoader loader(std::filesystem::current_path(), true, &monitor);
  Diagnostics notes;
  for (const auto& entity : state.entities) {
    const bool wanted = std::find(paths.begin(), paths.end(), entity->source.path) != paths.end();
    if (!wanted || entity->mechanism() || !workcell::hasShape(entity->kind()) || entity->unloaded) continue;
    workcell::SourceFile source = entity->source;
    if (entity->robot()) source.scale = 0.0;
    auto fresh = loader.loadSource(source, notes);
    if (!fresh) {
      result.problems.push_back(fresh.error().text());
      continue;
    }
    const auto kind = entity->proxy().kind;
    const double tolerance = entity->proxy().tolerance;
    const auto mesh = fresh->mesh();
    fresh->source = entity->source;
    result.commands.emplace_back(workcell::ReplaceShape{entity->id, std::move(*fresh)});
    if (kind == workcell::CollisionProxy::Kind::kNone || !mesh) continue;
    auto proxy = workcell::makeProxy(*mesh, kind, tolerance);
    if (proxy)
      result.commands.emplace_back(workcell::SetCollisionProxy{entity->id, std::move(*proxy)});
    else
      result.problems.push_back(proxy.error().text());
  }
  result.problems.insert(result.problems.end(), notes.warnings.begin(), notes.warnings.end());
  return result;
}

}  // namespace hapticell::app
