// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_cell_reader.h"

#include <algorithm>
#include <map>
#include <sdf/sdf.hh>

#include "geometry/system/text_case.h"
#include "workcell/scenes/sdf_robot.h"
#include "workcell/scenes/sdf_shapes.h"
#include "workcell/scenes/sdf_tidier.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

class CellReader {
 public:
  CellReader(const SdfSource& source, const fs::path& file, const ImportOptions& options, ImportMonitor* monitor,
             bool with_robots)
      : source_(source), file_(file), monitor_(monitor), with_robots_(with_robots), shapes_(source, options, monitor) {
    scene_.format = "sdf";
    scene_.unit_is_stated = true;
    scene_.warnings = source.warnings();
  }

  Expected<ImportedScene> read() {
    for (const sdf::Model* model : source_.models()) {
      if (shapes_.isCancelled()) return makeError({.file = file_.string(), .found = "the import was cancelled"});
      addModel(*model, -1);
    }
    const std::vector<Text>& notes = shapes_.notes().warnings;
    scene_.warnings.insert(scene_.warnings.end(), notes.begin(), notes.end());
    return std::move(scene_);
  }

 private:
  void addModel(const sdf::Model& model, int parent) {
    SceneNode node;
    node.name = model.Name();
    node.parent = parent;
    node.X_PN = resolved(model.SemanticPose(), "", model.RawPose(), model.Name());
    if (hasMovingJoints(model) && addRobot(model, node)) return;
    const int index = add(std::move(node));
    for (std::uint64_t k = 0; k < model.LinkCount(); ++k) {
      if (model.LinkByIndex(k)->Name() != kNoLink) addLink(*model.LinkByIndex(k), model.LinkCount() > 1, index);
    }
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k) addModel(*model.ModelByIndex(k), index);
  }

  /// False, told, where it is to be a solid body. `node` stands where the model does.
  bool addRobot(const sdf::Model& model, const SceneNode& node) {
    Diagnostics notes;
    auto robot = with_robots_ ? readSdfRobot(source_, model, file_, notes, monitor_) : Expected<SdfRobot>();
    if (!with_robots_ || !robot) {
      scene_.warnings.push_back(
          with_robots_
              ? Text("'%1' has moving joints; it is read as a rigid body: %2", model.Name(), robot.error().text())
              : Text("'%1' has moving joints; it is read as a rigid body", model.Name()));
      return false;
    }
    scene_.warnings.insert(scene_.warnings.end(), notes.warnings.begin(), notes.warnings.end());
    SceneNode standing = node;
    standing.X_PN = node.X_PN * robot->X_FB;
    standing.robot = std::make_shared<const kinematics::RobotModel>(std::move(robot->model));
    add(std::move(standing));
    return true;
  }

  void addLink(const sdf::Link& link, bool own_node, int model) {
    const Pose X_ML = resolved(link.SemanticPose(), "__model__", link.RawPose(), link.Name());
    int parent = model;
    if (own_node) {
      SceneNode node;
      node.name = link.Name();
      node.parent = model;
      node.X_PN = X_ML;
      parent = add(std::move(node));
    }
    const Pose X_PL = own_node ? Pose() : X_ML;
    for (std::uint64_t k = 0; k < link.VisualCount(); ++k) {
      const sdf::Visual& visual = *link.VisualByIndex(k);
      addShape(visual, link, X_PL, parent, colorOf(visual.Material()));
    }
    if (link.VisualCount() > 0) return;
    for (std::uint64_t k = 0; k < link.CollisionCount(); ++k) {
      addShape(*link.CollisionByIndex(k), link, X_PL, parent, std::nullopt);
    }
  }

  template <typename Shape>
  void addShape(const Shape& shape, const sdf::Link& link, const Pose& X_PL, int parent,
                const std::optional<std::array<float, 3>>& color) {
    const auto mesh = shape.Geom() ? shapes_.meshOf(*shape.Geom(), shape.Name()) : nullptr;
    if (!mesh) return;
    SceneNode node;
    node.name = shape.Name();
    node.parent = parent;
    node.X_PN = X_PL * resolved(shape.SemanticPose(), link.Name(), shape.RawPose(), shape.Name());
    node.color = color;
    const auto [known, is_new] = meshes_.try_emplace(mesh.get(), static_cast<int>(scene_.meshes.size()));
    if (is_new) {
      scene_.meshes.push_back(*mesh);
      kept_.push_back(mesh);
    }
    node.mesh = known->second;
    add(std::move(node));
  }

  /// A frame that is not there leaves a pose without meaning; it is then taken in the body above, and told.
  Pose resolved(const sdf::SemanticPose& pose, const std::string& to, const ignition::math::Pose3d& raw,
                const std::string& name) {
    ignition::math::Pose3d X;
    const sdf::Errors errors = pose.Resolve(X, to);
    if (!errors.empty()) {
      scene_.warnings.push_back(
          Text("'%1': the frame of its pose does not exist; the pose is read in the frame of its parent", name));
      X = raw;
    }
    const Pose result = toPose(X);
    if (result.isValid()) return result;
    scene_.warnings.push_back(Text("'%1': invalid pose; it is placed at its parent", name));
    return {};
  }

  static std::optional<std::array<float, 3>> colorOf(const sdf::Material* material) {
    const sdf::ElementPtr element = material ? material->Element() : nullptr;
    if (!element) return std::nullopt;
    const auto part = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    if (element->HasElement("diffuse")) {
      const auto c = material->Diffuse();
      return std::array<float, 3>{part(c.R()), part(c.G()), part(c.B())};
    }
    if (!element->HasElement("ambient")) return std::nullopt;
    const auto c = material->Ambient();
    return std::array<float, 3>{part(c.R()), part(c.G()), part(c.B())};
  }

  int add(SceneNode node) {
    scene_.nodes.push_back(std::move(node));
    return static_cast<int>(scene_.nodes.size()) - 1;
  }

  const SdfSource& source_;
  const fs::path& file_;
  ImportMonitor* monitor_;
  bool with_robots_;
  SdfShapes shapes_;
  ImportedScene scene_;
  std::map<const geometry::TriangleMesh*, int> meshes_;
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> kept_;  // While their addresses are known.
};

}  // namespace

bool isSdfCell(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  if (extension != ".sdf" && extension != ".world") return false;
  const std::optional<SdfOutline> outline = outlineOf(file);
  if (!outline || (!outline->world && outline->models == 0)) return false;
  return outline->jointed != 1 || outline->models > 1 || outline->grouped;
}

Expected<ImportedScene> readSdfCell(const fs::path& file, ImportMonitor* monitor, bool with_robots) {
  const auto source = SdfSource::load(file);
  HAPTICELL_TRY(source);
  ImportOptions options = asGazeboDoes();
  options.weld = false;
  return CellReader(*source, file, options, monitor, with_robots).read();
}

}  // namespace hapticell::workcell
