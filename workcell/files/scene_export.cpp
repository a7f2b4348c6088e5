// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/scene_export.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <unordered_map>

#include "geometry/system/listed.h"
#include "geometry/system/text_case.h"
#include "kinematics/model/robot_model.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_writer.h"
#include "workcell/robots/urdf_writer.h"
#include "workcell/scenes/gltf_writer.h"
#include "workcell/scenes/import_process.h"
#include "workcell/scenes/scene_exchange.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

/// Turns entities into nodes, parents first whatever the order of the document.
class SceneCollector {
 public:
  explicit SceneCollector(const DocumentState& state) : state_(state) {
    for (const auto& entity : state.entities) by_name_.emplace(entity->name, entity.get());
  }

  ImportedScene collect() {
    scene_.unit_is_stated = true;
    for (const auto& entity : state_.entities)
      if (entity->kind() != EntityKind::kFrame) nodeOf(*entity, 0);  // But for those that others stand below.
    return std::move(scene_);
  }

 private:
  int nodeOf(const Entity& entity, std::size_t depth) {
    if (const auto known = nodes_.find(entity.id); known != nodes_.end()) return known->second;
    // Deeper than there are entities: the document's parents go in a circle.
    const int parent = depth > state_.entities.size() ? -1 : parentOf(entity, depth);
    SceneNode node;
    node.name = entity.name;
    node.parent = parent;
    node.X_PN = parent < 0 ? entity.X_WE : X_W_[static_cast<std::size_t>(parent)].inverse() * entity.X_WE;
    if (entity.mesh()) {
      node.mesh = meshOf(entity.mesh());
      node.color = entity.color;
      node.origin = originOf(entity);
    }
    const int index = add(std::move(node), entity.X_WE);
    nodes_[entity.id] = index;
    if (entity.robot()) addLinks(entity, index);
    return index;
  }

  int parentOf(const Entity& entity, std::size_t depth) {
    if (entity.parent.empty() || entity.parent == entity.name) return -1;
    if (const auto parent = by_name_.find(entity.parent); parent != by_name_.end())
      return nodeOf(*parent->second, depth + 1);
    const auto [folder, is_new] = folders_.try_emplace(entity.parent, -1);
    if (is_new) {
      SceneNode node;
      node.name = entity.parent;
      folder->second = add(std::move(node), {});
    }
    return folder->second;
  }

  int add(SceneNode node, const Pose& X_WN) {
    scene_.nodes.push_back(std::move(node));
    X_W_.push_back(X_WN);
    return static_cast<int>(scene_.nodes.size()) - 1;
  }

  int meshOf(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
    const auto [known, is_new] = meshes_.try_emplace(mesh.get(), static_cast<int>(scene_.meshes.size()));
    if (is_new) scene_.meshes.push_back(*mesh);
    return known->second;
  }

  void addLinks(const Entity& entity, int parent) {
    std::vector<double> q = entity.joints();
    const kinematics::RobotModel& robot = *entity.robot();
    for (std::size_t k = q.size(); k < robot.dof(); ++k) {
      const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[k])];
      q.push_back(std::min(std::max(0.0, joint.lower), joint.upper));
    }
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(robot, q, X_BL);
    for (std::size_t k = 0; k < robot.links.size(); ++k) addLink(robot.links[k], X_BL[k], entity.X_WE, parent);
  }

  void addLink(const kinematics::Link& link, const Pose& X_BL, const Pose& X_WB, int parent) {
    for (std::size_t k = 0; k < link.visuals.size(); ++k) {
      const kinematics::LinkShape& shape = link.visuals[k];
      SceneNode node;
      node.name = link.visuals.size() == 1 ? link.name : link.name + " " + std::to_string(k + 1);
      node.parent = parent;
      node.X_PN = X_BL * shape.X_LS;
      node.mesh = meshOf(shape.mesh);
      node.color = {shape.color[0], shape.color[1], shape.color[2]};
      add(node, X_WB * node.X_PN);
    }
  }

  static std::optional<SceneOrigin> originOf(const Entity& entity) {
    const std::string extension = lowerExtension(entity.source.path);
    const bool exact = extension == ".step" || extension == ".stp" || extension == ".p21";
    const bool turned = entity.source.part.empty() && entity.source.up_axis.value_or(UpAxis::kZ) != UpAxis::kZ;
    if (!exact || turned) return std::nullopt;
    return SceneOrigin{entity.source.path, entity.source.part, entity.source.scale};
  }

  const DocumentState& state_;
  std::unordered_map<std::string_view, const Entity*> by_name_;
  ImportedScene scene_;
  std::vector<Pose> X_W_;
  std::map<EntityId, int> nodes_;
  std::map<std::string, int> folders_;
  std::map<const geometry::TriangleMesh*, int> meshes_;
};

/// All meshes placed in the scene's frame.
std::vector<NamedMesh> placedMeshes(const ImportedScene& scene) {
  const std::vector<Pose> X_F = nodePoses(scene);
  std::vector<NamedMesh> meshes;
  for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
    const SceneNode& node = scene.nodes[k];
    if (node.mesh < 0) continue;
    NamedMesh part;
    part.name = node.name;
    if (node.color) part.color = *node.color;
    geometry::append(part.mesh, scene.meshes[static_cast<std::size_t>(node.mesh)], X_F[k]);
    meshes.push_back(std::move(part));
  }
  return meshes;
}

/// STEP is written by the importer's process into a file beside, which is then moved into place.
Expected<void> exportStep(ImportedScene scene, const fs::path& file, const ExportOptions& options) {
  std::vector<bool> as_facets(scene.meshes.size(), false);
  for (const SceneNode& node : scene.nodes) {
    if (node.mesh >= 0 && !node.origin) as_facets[static_cast<std::size_t>(node.mesh)] = true;
  }
  for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
    geometry::TriangleMesh& mesh = scene.meshes[k];
    if (as_facets[k]) {
      geometry::weld(mesh, geometry::weldTolerance(mesh));
    } else {
      mesh = {};  // Read again from its file.
    }
  }
  auto aside = AtomicFile::begin(file);
  HAPTICELL_TRY(aside);
  ImporterCall call;
  call.file = file.string();
  call.arguments = {"write", aside->aside().string()};
  call.scene = sceneBytes(scene);
  call.limits = options.limits;
  call.monitor = options.monitor;
  const Expected<std::string> done = callImporter(call);
  return done ? aside->commit() : makeError(done.error());
}

Expected<void> exportMeshes(const ImportedScene& scene, const fs::path& file, const ExportOptions& options) {
  const std::vector<NamedMesh> meshes = placedMeshes(scene);
  const std::string extension = lowerExtension(file);
  const double unit = options.metres_per_unit;
  if (extension == ".stl") return writeFileAtomically(file, stlBytes(meshes, unit));
  if (extension == ".ply") return writeFileAtomically(file, plyBytes(meshes, unit));
  if (extension == ".off") return writeFileAtomically(file, offText(meshes, unit));
  fs::path materials = file;
  materials.replace_extension(".mtl");
  return writeFilesAtomically(
      {{materials, objMaterials(meshes)}, {file, objText(meshes, unit, materials.filename().string())}});
}

}  // namespace

ImportedScene sceneOf(const DocumentState& state) {
  return SceneCollector(state).collect();
}

Expected<ImportedScene> sceneOfFile(const fs::path& file, const ImportOptions& options, Diagnostics& diagnostics,
                                    ImportMonitor* monitor) {
  if (lowerExtension(file) == ".hcell") {
    LoadOptions loading;
    loading.monitor = monitor;
    const auto document = loadDocument(file, diagnostics, loading);
    HAPTICELL_TRY(document);
    return sceneOf(document->state());
  }
  if (holdsScene(file)) {
    Expected<ImportedScene> scene = readScene(file, options, monitor);
    if (!scene) return scene;
    for (const Text& warning : scene->warnings) diagnostics.warn(warning);
    if (scene->format != "step") return scene;
    const std::vector<std::string> paths = partPaths(*scene);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      if (scene->nodes[k].mesh < 0) continue;
      scene->nodes[k].origin = SceneOrigin{fs::absolute(file).string(), paths[k], scene->metres_per_unit};
    }
    return scene;
  }
  Expected<ImportResult> tree = EntityLoader(fs::current_path()).loadTree(file.string(), options, diagnostics);
  HAPTICELL_TRY(tree);
  DocumentState state;
  for (Entity& entity : tree->entities) {
    entity.id = state.entities.size() + 1;
    state.entities.push_back(std::make_shared<const Entity>(std::move(entity)));
  }
  ImportedScene scene = sceneOf(state);
  scene.format = tree->report.format;
  scene.unit_is_stated = tree->report.unit_is_stated;
  scene.metres_per_unit = tree->report.metres_per_unit;
  return scene;
}

Expected<void> exportState(const DocumentState& state, const fs::path& file, const ExportOptions& options,
                           Diagnostics& diagnostics) {
  if (lowerExtension(file) != ".urdf") return exportScene(sceneOf(state), file, options, diagnostics);
  const Entity* robot = nullptr;
  for (const auto& entity : state.entities) {
    if (!entity->robot()) continue;
    if (robot) {
      return makeError({.file = file.string(),
                        .found = Text("more than one robot ('%1', '%2')", robot->name, entity->name),
                        .expected = "exactly one robot in a URDF",
                        .fix = "Select one of them."});
    }
    robot = entity.get();
  }
  if (!robot)
    return makeError({.file = file.string(), .found = "the cell has no robot", .expected = "one robot for a URDF"});
  return writeUrdf(*robot, file, diagnostics);
}

const std::vector<std::string>& writableExtensions() {
  static const std::vector<std::string> kExtensions = {".step", ".stp", ".glb", ".gltf",
                                                       ".stl",  ".obj", ".ply", ".off"};
  return kExtensions;
}

Expected<void> exportScene(const ImportedScene& scene, const fs::path& file, const ExportOptions& options,
                           Diagnostics& diagnostics) {
  const std::string extension = lowerExtension(file);
  const auto& known = writableExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    return makeError({.file = file.string(),
                      .found = Text("the extension '%1'", extension),
                      .expected = Text("one of %1", listed(known))});
  }
  const bool any = std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const SceneNode& n) { return n.mesh >= 0; });
  if (!any)
    return makeError({.file = file.string(), .found = "no entity with a shape", .expected = "at least one solid"});
  if (extension == ".step" || extension == ".stp") return exportStep(scene, file, options);
  if (extension == ".glb" || extension == ".gltf")
    return writeFileAtomically(file, gltfBytes(scene, extension == ".glb"));
  if (scene.nodes.size() > 1) diagnostics.warn("the tree and the placements of the parts are not kept in this format");
  return exportMeshes(scene, file, options);
}

}  // namespace hapticell::workcell
