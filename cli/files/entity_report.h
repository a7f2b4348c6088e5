// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "workcell/entity/entity.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::cli {

/// An entity as `inspect` shows it: name, kind, color, triangles, bounds, volume, children; for robots also joints.
/// Bounds are those of the vertices in the world, metres, exact; null without a mesh. The volume is that of the closed
/// surface (by the divergence theorem; `closed` says whether it is closed).
nlohmann::ordered_json entityReport(const workcell::Entity& entity);

/// What takes time to find out of a mesh.
struct SolidFacts {
  double volume = 0.0;  ///< m3, as it is.
  bool closed = false;  ///< Once it is welded.
};
SolidFacts factsOf(const geometry::TriangleMesh& mesh);

/// The report of one mesh, placed in the world.
nlohmann::ordered_json meshReport(const std::string& name, const geometry::TriangleMesh& mesh, const Pose& X_WM,
                                  const std::array<float, 3>& color, const SolidFacts& facts);

/// Entities as a tree: those with a parent are below the entity of that name, or below an assembly made for it.
nlohmann::ordered_json treeReport(const std::vector<workcell::Entity>& entities);

/// The nodes of a CAD file as a tree, with the names of the parts; `instance` where the use of a part has its own.
/// `known`: the facts of the scene's first meshes, by their numbers; others are found out.
nlohmann::ordered_json sceneReport(const workcell::ImportedScene& scene, std::span<const SolidFacts> known = {});

}  // namespace hapticell::cli
