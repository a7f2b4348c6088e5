// SPDX-License-Identifier: Apache-2.0
#include "workcell/urdf_shapes.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "geometry/shapes.h"
#include "workcell/imported_entities.h"
#include "workcell/package_path.h"

namespace hapticell::workcell {

namespace {

using kinematics::LinkShape;

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool readable(const std::string& extension) {
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off";
}

std::optional<std::array<float, 4>> colorOf(const urdf::Visual& visual, const std::set<std::string>& undefined) {
  if (!visual.material || undefined.count(visual.material->name)) return std::nullopt;
  const urdf::Color& c = visual.material->color;
  const auto channel = [](float value) { return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.7f; };
  return std::array<float, 4>{channel(c.r), channel(c.g), channel(c.b), channel(c.a)};
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == 8) return text + " and " + std::to_string(names.size() - i) + " more";
    text += (i > 0 ? ", " : "") + names[i];
  }
  return text;
}

void scaleBy(geometry::TriangleMesh& mesh, const dvec3& scale) {
  for (dvec3& vertex : mesh.vertices) vertex *= scale;
  if (scale.x * scale.y * scale.z > 0.0) return;
  for (geometry::Triangle& triangle : mesh.triangles)
    std::swap(triangle[1], triangle[2]);  // mirrored: keep outward outward
}

/// Collada is taken without its up axis, as the tools of ROS do.
ImportOptions asRosDoes() {
  ImportOptions options;
  options.up_axis = UpAxis::kZ;
  return options;
}

}  // namespace

Pose toPose(const urdf::Pose& origin) {
  const urdf::Rotation& r = origin.rotation;
  return {{origin.position.x, origin.position.y, origin.position.z}, glm::normalize(dquat(r.w, r.x, r.y, r.z))};
}

UrdfShapes::UrdfShapes(std::filesystem::path file, std::set<std::string> undefined_materials, Diagnostics& diagnostics,
                       ImportMonitor* monitor)
    : file_(std::move(file)),
      undefined_materials_(std::move(undefined_materials)),
      diagnostics_(diagnostics),
      scenes_(asRosDoes(), monitor) {}

void UrdfShapes::readAhead(const urdf::ModelInterface& model) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const urdf::GeometrySharedPtr& geometry) {
    if (!geometry || geometry->type != urdf::Geometry::MESH) return;
    const auto path = resolveMeshPath(static_cast<const urdf::Mesh&>(*geometry).filename, file_.parent_path());
    if (path) files.push_back(*path);
  };
  for (const auto& [name, link] : model.links_) {
    for (const urdf::VisualSharedPtr& visual : link->visual_array) add(visual->geometry);
    for (const urdf::CollisionSharedPtr& collision : link->collision_array) add(collision->geometry);
  }
  scenes_.readAhead(files);
}

Error UrdfShapes::refusal(const std::string& link, std::string found, std::string expected, std::string fix) const {
  return {file_.string(), "link '" + link + "'", std::move(found), std::move(expected), std::move(fix)};
}

Expected<std::shared_ptr<const geometry::TriangleMesh>> UrdfShapes::primitiveOf(const std::string& link,
                                                                                const urdf::Geometry& geometry) const {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    if (!positive(box->dim.x) || !positive(box->dim.y) || !positive(box->dim.z)) {
      return makeError(refusal(link, "a box without size", "three positive lengths", ""));
    }
    return std::make_shared<geometry::TriangleMesh>(geometry::makeBox({box->dim.x, box->dim.y, box->dim.z}));
  }
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    if (!positive(cylinder->radius) || !positive(cylinder->length)) {
      return makeError(refusal(link, "a cylinder without size", "a positive radius and length", ""));
    }
    return std::make_shared<geometry::TriangleMesh>(geometry::makeCylinder(cylinder->radius, cylinder->length));
  }
  const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry);
  if (!sphere || !positive(sphere->radius))
    return makeError(refusal(link, "a sphere without size", "a positive radius", ""));
  return std::make_shared<geometry::TriangleMesh>(geometry::makeSphere(sphere->radius));
}

Expected<std::shared_ptr<const geometry::TriangleMesh>> UrdfShapes::meshOf(const std::string& link,
                                                                           const urdf::Mesh& mesh,
                                                                           const std::filesystem::path& path) {
  const dvec3 scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
  if (!(std::abs(scale.x * scale.y * scale.z) > 0.0)) {
    return makeError(
        refusal(link, "a mesh with a scale of zero (" + mesh.filename + ")", "three numbers other than zero", ""));
  }
  const MeshKey key{path.string(), scale.x, scale.y, scale.z};
  if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
  const bool uniform = scale.x == scale.y && scale.y == scale.z && scale.x > 0.0;
  ImportOptions options = asRosDoes();
  options.warn_about_unit = scale == dvec3(1.0);
  const bool own_reader = !holdsScene(path);
  if (own_reader) options.metres_per_unit = uniform ? scale.x : 1.0;  // ROS reads no unit out of a mesh file.
  auto read = readWholeMesh(path, options, diagnostics_, &scenes_);
  if (!read) return makeError(read.error());
  if (!own_reader || !uniform) scaleBy(*read, scale);
  return meshes_[key] = std::make_shared<geometry::TriangleMesh>(std::move(*read));
}

Expected<std::optional<LinkShape>> UrdfShapes::shapeOf(const std::string& link, const urdf::GeometrySharedPtr& geometry,
                                                       const urdf::Pose& origin) {
  if (!geometry)
    return makeError(refusal(link, "a shape without geometry", "<box>, <cylinder>, <sphere> or <mesh>", ""));
  LinkShape shape;
  shape.X_LS = toPose(origin);
  if (!shape.X_LS.isValid()) return makeError(refusal(link, "an origin that is not a pose", "finite numbers", ""));
  if (geometry->type != urdf::Geometry::MESH) {
    auto mesh = primitiveOf(link, *geometry);
    if (!mesh) return makeError(mesh.error());
    shape.mesh = std::move(*mesh);
    shape.source = geometry->type == urdf::Geometry::BOX        ? "box"
                   : geometry->type == urdf::Geometry::CYLINDER ? "cylinder"
                                                                : "sphere";
    return shape;
  }
  const auto& mesh = static_cast<const urdf::Mesh&>(*geometry);
  const auto path = resolveMeshPath(mesh.filename, file_.parent_path());
  if (leavesPackage(mesh.filename)) {
    return makeError(refusal(link, "its mesh " + mesh.filename + " leads out of the package", "a file of the package",
                             "Write its place without the '..' that leave the package."));
  }
  if (!path) {
    return makeError(refusal(
        link, "its mesh " + mesh.filename + " is not there", "a file",
        mesh.filename.starts_with("package://")
            ? "Put the package's folder beside the robot file or above it, or name its place in ROS_PACKAGE_PATH."
            : "Correct the path or put the file there."));
  }
  const std::string extension = lowerExtension(*path);
  const bool scene = holdsScene(*path);
  if (!readable(extension) && !scene) {
    unreadable_formats_.insert(extension.empty() ? "no extension" : extension.substr(1));
    return std::nullopt;
  }
  auto read = meshOf(link, mesh, *path);
  if (!read && scene && !scenes_.isCancelled()) {  // A drawing that cannot be had is no reason to refuse the robot.
    diagnostics_.warn(read.error().message());
    unreadable_formats_.insert(extension.empty() ? "no extension" : extension.substr(1));
    return std::nullopt;
  }
  if (!read) return makeError(read.error());
  shape.mesh = std::move(*read);
  shape.source = path->string();
  return shape;
}

Expected<void> UrdfShapes::fill(const urdf::Link& source, kinematics::Link& link) {
  bool lost_visual = false, lost_collision = false;
  std::optional<std::array<float, 4>> color;
  for (const urdf::VisualSharedPtr& visual : source.visual_array) {
    auto shape = shapeOf(link.name, visual->geometry, visual->origin);
    if (!shape) return makeError(shape.error());
    const auto own_color = colorOf(*visual, undefined_materials_);
    if (!color) color = own_color;
    lost_visual = lost_visual || !shape->has_value();
    if (!shape->has_value()) continue;
    if (own_color) (*shape)->color = *own_color;
    link.visuals.push_back(std::move(**shape));
  }
  for (const urdf::CollisionSharedPtr& collision : source.collision_array) {
    auto shape = shapeOf(link.name, collision->geometry, collision->origin);
    if (!shape) return makeError(shape.error());
    lost_collision = lost_collision || !shape->has_value();
    if (!shape->has_value()) continue;
    if (color) (*shape)->color = *color;
    link.collisions.push_back(std::move(**shape));
  }
  // A set of which a part cannot be read is replaced as a whole: half a link would mislead.
  const bool visuals_usable = !link.visuals.empty() && !lost_visual;
  const bool collisions_usable = !link.collisions.empty() && !lost_collision;
  if (lost_visual && collisions_usable) {
    link.visuals = link.collisions;
    shown_by_collision_.push_back(link.name);
  }
  if (!collisions_usable && visuals_usable) {
    link.collisions = link.visuals;
    if (lost_collision) checked_by_visual_.push_back(link.name);
  }
  if ((lost_visual || lost_collision) && !visuals_usable && !collisions_usable) without_shape_.push_back(link.name);
  return {};
}

void UrdfShapes::reportReplacements() {
  std::string formats;
  for (const std::string& format : unreadable_formats_) formats += (formats.empty() ? "" : ", ") + format;
  const std::string reason = file_.string() + ": meshes that cannot be read (" + formats + "): ";
  if (!shown_by_collision_.empty())
    diagnostics_.warn(reason + "the collision shape is shown instead for " + listed(shown_by_collision_));
  if (!checked_by_visual_.empty())
    diagnostics_.warn(reason + "the visual shape is checked instead for " + listed(checked_by_visual_));
  if (!without_shape_.empty()) {
    diagnostics_.warn(reason + "not (or not wholly) drawn and not checked are " + listed(without_shape_) +
                      ". Convert the meshes to STL, OBJ or PLY");
  }
}

}  // namespace hapticell::workcell
