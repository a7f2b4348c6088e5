// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/imported_entities.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "geometry/system/utf8.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::workcell {

namespace {

using MeshPointer = std::shared_ptr<const geometry::TriangleMesh>;

/// What Document accepts as a name, from whatever a file holds.
std::string usableName(const std::string& name, const std::string& otherwise) {
  constexpr std::size_t kLongest = 180;  // Room for a number behind it.
  std::string usable;
  for (char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    usable += byte < 0x20 || byte == 0x7F ? ' ' : c;
  }
  std::size_t end = std::min(usable.size(), kLongest);
  while (end > 0 && end < usable.size() && continuesCharacter(usable[end])) --end;
  usable.resize(end);
  const std::size_t first = usable.find_first_not_of(' ');
  if (first == std::string::npos) return otherwise;
  return usable.substr(first, usable.find_last_not_of(' ') - first + 1);
}

/// "wanted", or "wanted 2" ...; remembers where it counted to, so that a thousand bolts are named in a moment.
class Names {
 public:
  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    int& number = next_[wanted];
    for (number = std::max(number, 1); !taken_.insert(name).second; ++number) {
      name = wanted;
      name.append(" ").append(std::to_string(number + 1));
    }
    return name;
  }
  void take(const std::string& name) { taken_.insert(name); }

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;
};

class SceneConverter {
 public:
  SceneConverter(ImportedScene scene, const SourceFile& source, const ImportOptions& options, Diagnostics& diagnostics)
      : scene_(std::move(scene)), source_(source), options_(options), diagnostics_(diagnostics) {
    source_.scale = scene_.metres_per_unit;
    source_.up_axis = options.up_axis;
    source_.tessellation = options.tessellation;
    if (options.relative_chord > 0.0 && scene_.chord > 0.0) source_.tessellation.chord = scene_.chord;
    result_.report.format = scene_.format;
    result_.report.metres_per_unit = scene_.metres_per_unit;
    result_.report.unit_is_stated = scene_.unit_is_stated;
    result_.report.up_axis = scene_.up_axis;
    result_.report.chord = scene_.chord;
  }

  Expected<ImportResult> convert() {
    for (const Text& warning : scene_.warnings) diagnostics_.warn(warning);
    if (options_.merge) {
      addMerged();
    } else {
      shareMeshes();
      addTree();
    }
    facing_.tell(diagnostics_);
    if (result_.report.parts == 0) {
      return makeError({.file = source_.path,
                        .found = "no shape with an area above 0",
                        .expected = "at least one solid or surface"});
    }
    return std::move(result_);
  }

 private:
  void clean(geometry::TriangleMesh& mesh) {
    if (!options_.weld) return;
    const geometry::WeldReport weld = geometry::weld(mesh, geometry::weldTolerance(mesh));
    result_.report.merged_vertices += weld.merged_vertices;
    result_.report.degenerate_triangles += weld.degenerate_triangles;
    result_.report.duplicate_triangles += weld.duplicate_triangles;
    facing_.look(mesh);
  }

  void shareMeshes() {
    for (geometry::TriangleMesh& mesh : scene_.meshes) {
      clean(mesh);
      meshes_.push_back(std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
    }
  }

  bool hasShape(const SceneNode& node) const {
    return node.robot || (node.mesh >= 0 && !meshes_[static_cast<std::size_t>(node.mesh)]->triangles.empty());
  }

  /// Which nodes hold a shape or stand above one.
  std::vector<bool> nodesWithShape() const {
    std::vector<bool> with(scene_.nodes.size(), false);
    for (std::size_t k = with.size(); k-- > 0;) {
      if (hasShape(scene_.nodes[k])) with[k] = true;
      if (with[k] && scene_.nodes[k].parent >= 0) with[static_cast<std::size_t>(scene_.nodes[k].parent)] = true;
    }
    return with;
  }

  void addTree() {
    const std::vector<Pose> X_F = nodePoses(scene_);
    const std::vector<std::string> paths = partPaths(scene_);
    const std::vector<bool> wanted = nodesWithShape();
    std::vector<std::string> named(scene_.nodes.size());
    Names names;
    std::vector<std::string> empty;
    for (std::size_t k = 0; k < scene_.nodes.size(); ++k) {
      const SceneNode& node = scene_.nodes[k];
      if (!wanted[k]) {
        empty.push_back(usableName(node.name, "nameless"));
        continue;
      }
      named[k] = names.unique(usableName(node.name, node.robot ? "robot" : "part"));
      Entity entity = node.robot ? robotEntity(node.robot, named[k]) : Entity();
      entity.name = named[k];
      entity.X_WE = X_F[k];
      if (node.parent >= 0) entity.parent = named[static_cast<std::size_t>(node.parent)];
      if (node.color) entity.color = *node.color;
      entity.source = source_;
      entity.source.part = paths[k];
      if (!hasShape(node))
        entity.body = Assembly{};
      else if (!node.robot)
        entity.body = Solid{meshes_[static_cast<std::size_t>(node.mesh)]};
      add(std::move(entity));
    }
    warnOfEmpty(empty);
  }

  void warnOfEmpty(const std::vector<std::string>& empty) {
    if (empty.empty()) return;
    // Names in a message; the rest is counted. Half, twice: shorter or longer messages.
    constexpr std::size_t kNamed = 5;
    std::string names;
    for (std::size_t k = 0; k < std::min(empty.size(), kNamed); ++k) names += (k == 0 ? "" : ", ") + empty[k];
    if (empty.size() > kNamed) names += " ...";
    diagnostics_.warn(Text("left out, because they have no shape: %1 nodes (%2)", empty.size(), names));
  }

  void addMerged() {
    const std::vector<Pose> X_F = nodePoses(scene_);
    geometry::TriangleMesh whole;
    Entity entity;
    std::size_t most = 0;
    for (std::size_t k = 0; k < scene_.nodes.size(); ++k) {
      const SceneNode& node = scene_.nodes[k];
      if (node.mesh < 0) continue;
      const geometry::TriangleMesh& mesh = scene_.meshes[static_cast<std::size_t>(node.mesh)];
      geometry::append(whole, mesh, X_F[k]);
      if (node.color && mesh.triangles.size() > most) {
        most = mesh.triangles.size();
        entity.color = *node.color;
      }
    }
    clean(whole);
    if (whole.triangles.empty()) return;
    entity.name = usableName(std::filesystem::path(source_.path).stem().string(), "part");
    entity.source = source_;
    entity.body = Solid{std::make_shared<const geometry::TriangleMesh>(std::move(whole))};
    add(std::move(entity));
  }

  void add(Entity entity) {
    if (entity.robot()) ++result_.report.parts;
    if (entity.mesh()) {
      ++result_.report.parts;
      result_.report.triangles += entity.mesh()->triangles.size();
    }
    result_.entities.push_back(std::move(entity));
  }

  ImportedScene scene_;
  SourceFile source_;
  const ImportOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<MeshPointer> meshes_;
  ImportResult result_;
  FacingNote facing_;
};

}  // namespace

Entity robotEntity(std::shared_ptr<const kinematics::RobotModel> robot, const std::string& name) {
  Entity entity;
  entity.name = name;
  const int tip = robot->defaultTip();
  std::string tip_link = tip >= 0 ? robot->links[static_cast<std::size_t>(tip)].name : std::string();
  entity.body = Robot{{.model = std::move(robot), .joints = {}, .tip_link = std::move(tip_link)}};
  return entity;
}

Expected<ImportResult> entitiesFromScene(ImportedScene scene, const SourceFile& source, const ImportOptions& options,
                                         Diagnostics& diagnostics) {
  return SceneConverter(std::move(scene), source, options, diagnostics).convert();
}

namespace {

/// A compound of the document that is taken back when it is left without end(): by an error, or where memory ends.
class Compound {
 public:
  Compound(Document& document, std::string text) : document_(document) { document_.beginCompound(std::move(text)); }
  Compound(const Compound&) = delete;
  Compound& operator=(const Compound&) = delete;
  ~Compound() {
    if (open_ && document_.inCompound()) document_.cancelCompound();
  }
  void end() {
    document_.endCompound();
    open_ = false;
  }

 private:
  Document& document_;
  bool open_ = true;
};

}  // namespace

Expected<std::vector<EntityId>> addImported(Document& document, std::vector<Entity> entities, const Pose& X_WF) {
  Names names;
  for (const auto& entity : document.state().entities) names.take(entity->name);
  std::unordered_map<std::string, std::string> renamed;
  std::vector<EntityId> ids;
  Compound import(document, entities.size() == 1 ? "Add " + entities[0].name : "Import");
  for (Entity& entity : entities) {
    const std::string old = entity.name;
    entity.name = renamed[old] = names.unique(old);
    if (const auto parent = renamed.find(entity.parent); parent != renamed.end()) entity.parent = parent->second;
    entity.X_WE = X_WF * entity.X_WE;
    const auto added = document.execute(AddEntity{std::move(entity)});
    HAPTICELL_TRY(added);
    ids.push_back(*added);
  }
  import.end();
  return ids;
}

}  // namespace hapticell::workcell
