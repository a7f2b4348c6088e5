// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/whole_mesh.h"

#include <unordered_map>
#include <utility>
#include <vector>

#include "workcell/meshes/mesh_care.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/scenes/scene_batch.h"

namespace hapticell::workcell {

Expected<geometry::TriangleMesh> readWholeMesh(const std::filesystem::path& file, const ImportOptions& options,
                                               Diagnostics& diagnostics, const SceneBatch* batch) {
  if (!holdsScene(file)) {
    const MeshReadOptions reading{options.metres_per_unit, options.weld, options.warn_about_unit};
    Diagnostics notes;
    auto mesh = readMesh(file, reading, notes);
    for (const Text& note : notes.warnings) diagnostics.warn(Text("%1: %2", file.filename().string(), note));
    return mesh;
  }
  ImportOptions as_solids = options;
  as_solids.merge = true;
  Expected<ImportedScene> scene = batch ? batch->scene(file) : readScene(file, as_solids, nullptr);
  HAPTICELL_TRY(scene);
  Diagnostics notes{scene->warnings};
  const std::vector<Pose> X_F = nodePoses(*scene);
  geometry::TriangleMesh whole;
  for (std::size_t k = 0; k < X_F.size(); ++k) {
    const int mesh = scene->nodes[k].mesh;
    if (mesh >= 0) geometry::append(whole, scene->meshes[static_cast<std::size_t>(mesh)], X_F[k]);
  }
  if (options.weld) {
    geometry::weld(whole, geometry::weldTolerance(whole));
    FacingNote facing;
    facing.look(whole);
    facing.tell(notes);
  }
  for (const Text& note : notes.warnings) diagnostics.warn(Text("%1: %2", file.filename().string(), note));
  return whole;
}

ImportedScene sceneOfParts(MeshFileParts file, const std::string& stem) {
  ImportedScene scene;
  scene.format = formatName(file.format);
  scene.metres_per_unit = file.metres_per_unit;
  scene.unit_is_stated = file.unit_is_stated;
  std::unordered_map<std::size_t, int> assemblies;
  const auto add = [&scene](SceneNode node) {
    scene.nodes.push_back(std::move(node));
    return static_cast<int>(scene.nodes.size()) - 1;
  };
  for (MeshPart& part : file.parts) {
    SceneNode node;
    node.name = part.name.empty() ? stem : part.name;
    node.color = part.color;
    if (part.assembly_number > 0) {
      const auto [known, is_new] = assemblies.try_emplace(part.assembly_number, -1);
      SceneNode above;
      above.name = part.assembly.empty() ? stem : part.assembly;
      if (is_new) known->second = add(std::move(above));
      node.parent = known->second;
    }
    node.mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back(std::move(part.mesh));
    add(std::move(node));
  }
  return scene;
}

}  // namespace hapticell::workcell
