// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_cell_reader.h"

#include <algorithm>
#include <map>

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
    for (const SdfModel& model : source_.models()) {
      if (shapes_.isCancelled()) return makeError({.file = file_.string(), .found = "the import was cancelled"});
      addModel(model, -1);
    }
    const std::vector<Text>& notes = shapes_.notes().warnings;
    scene_.warnings.insert(scene_.warnings.end(), notes.begin(), notes.end());
    return std::move(scene_);
  }

 private:
  void addModel(const SdfModel& model, int parent) {
    SceneNode node;
    node.name = model.name;
    node.parent = parent;
    node.X_PN = resolved(model.X_P, model.name);
    if (hasMovingJoints(model) && addRobot(model, node)) return;
    const int index = add(std::move(node));
    for (const SdfLink& link : model.links) {
      if (link.name != kNoLink) addLink(link, model.links.size() > 1, index);
    }
    for (const SdfModel& inside : model.models) addModel(inside, index);
  }

  /// False, told, where it is to be a solid body. `node` stands where the model does.
  bool addRobot(const SdfModel& model, const SceneNode& node) {
    Diagnostics notes;
    auto robot = with_robots_ ? readSdfRobot(source_, model, file_, notes, monitor_) : Expected<SdfRobot>();
    if (!with_robots_ || !robot) {
      scene_.warnings.push_back(
          with_robots_
              ? Text("'%1' has moving joints; it is read as a rigid body: %2", model.name, robot.error().text())
              : Text("'%1' has moving joints; it is read as a rigid body", model.name));
      return false;
    }
    scene_.warnings.insert(scene_.warnings.end(), notes.warnings.begin(), notes.warnings.end());
    SceneNode standing = node;
    standing.X_PN = node.X_PN * robot->X_FB;
    standing.robot = std::make_shared<const kinematics::RobotModel>(std::move(robot->model));
    add(std::move(standing));
    return true;
  }

  void addLink(const SdfLink& link, bool own_node, int model) {
    const Pose X_ML = resolved(link.X_ML, link.name);
    int parent = model;
    if (own_node) {
      SceneNode node;
      node.name = link.name;
      node.parent = model;
      node.X_PN = X_ML;
      parent = add(std::move(node));
    }
    const Pose X_PL = own_node ? Pose() : X_ML;
    for (const SdfShape& visual : link.visuals) addShape(visual, X_PL, parent, colorOf(visual));
    if (!link.visuals.empty()) return;
    for (const SdfShape& collision : link.collisions) addShape(collision, X_PL, parent, std::nullopt);
  }

  void addShape(const SdfShape& shape, const Pose& X_PL, int parent, const std::optional<std::array<float, 3>>& color) {
    const auto mesh = shapes_.meshOf(shape, shape.name);
    if (!mesh) return;
    SceneNode node;
    node.name = shape.name;
    node.parent = parent;
    node.X_PN = X_PL * resolved(shape.X_LS, shape.name);
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
  Pose resolved(const SdfPose& pose, const std::string& name) {
    if (!pose.fault.empty()) {
      scene_.warnings.push_back(
          Text("'%1': the frame of its pose does not exist; the pose is read in the frame of its parent", name));
    }
    if (pose.X.isValid()) return pose.X;
    scene_.warnings.push_back(Text("'%1': invalid pose; it is placed at its parent", name));
    return {};
  }

  static std::optional<std::array<float, 3>> colorOf(const SdfShape& visual) {
    auto color = visual.diffuse ? visual.diffuse : visual.ambient;
    if (!color) return color;
    for (float& part : *color) part = std::clamp(part, 0.0f, 1.0f);
    return color;
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
  const auto source = SdfSource::load(file, monitor);
  HAPTICELL_TRY(source);
  ImportOptions options = asGazeboDoes();
  options.weld = false;
  return CellReader(*source, file, options, monitor, with_robots).read();
}

}  // namespace hapticell::workcell
