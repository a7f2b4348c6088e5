// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_shapes.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "geometry/shapes/shapes.h"
#include "geometry/system/listed.h"
#include "geometry/system/text_case.h"
#include "workcell/robots/urdf_lines.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::workcell {

namespace {

using kinematics::LinkShape;
using Kind = UrdfShape::Kind;

bool readable(const std::string& extension) {
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off";
}

Text quotedNames(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == 8) return Text("%1 and %2 more", text, names.size() - i);
    text += std::string(i > 0 ? ", '" : "'") + names[i] + "'";
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

geometry::TriangleMesh primitiveOf(const UrdfShape& shape) {
  if (shape.kind == Kind::kBox) return geometry::makeBox(shape.size);
  if (shape.kind == Kind::kCylinder) return geometry::makeCylinder(shape.radius, shape.length);
  if (shape.kind == Kind::kCapsule) return geometry::makeCapsule(shape.radius, shape.length);
  return geometry::makeSphere(shape.radius);
}

const char* nameOf(Kind kind) {
  if (kind == Kind::kBox) return "box";
  if (kind == Kind::kCylinder) return "cylinder";
  return kind == Kind::kCapsule ? "capsule" : "sphere";
}

}  // namespace

UrdfShapes::UrdfShapes(const UrdfLines& lines, Diagnostics& diagnostics, ImportMonitor* monitor)
    : lines_(lines),
      folder_(std::filesystem::path(lines.file()).parent_path()),
      diagnostics_(diagnostics),
      scenes_(asRosDoes(), monitor) {}

const std::optional<FoundFile>& UrdfShapes::find(const std::string& name) {
  const auto known = found_.find(name);
  return known != found_.end() ? known->second : found_[name] = findReference(name, folder_);
}

void UrdfShapes::readAhead(const std::vector<UrdfLink>& links) {
  std::vector<std::filesystem::path> files;
  for (const UrdfLink& link : links) {
    for (const auto* shapes : {&link.visuals, &link.collisions}) {
      for (const UrdfShape& shape : *shapes) {
        if (shape.kind == Kind::kMesh && find(shape.mesh)) files.push_back(find(shape.mesh)->path);
      }
    }
  }
  scenes_.readAhead(files);
}

void UrdfShapes::reportOnce(int line, const std::string& what, const Text& sentence) {
  if (reported_.insert(what).second) diagnostics_.warn(Text("%1: %2 (link '%3')", lines_.words(line), sentence, link_));
}

Expected<std::shared_ptr<const geometry::TriangleMesh>> UrdfShapes::scaledMesh(const UrdfShape& source,
                                                                               const std::filesystem::path& path) {
  const dvec3 scale = source.size;
  const MeshKey key{path.string(), scale.x, scale.y, scale.z};
  if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
  const bool uniform = scale.x == scale.y && scale.y == scale.z && scale.x > 0.0;
  ImportOptions options = asRosDoes();
  options.warn_about_unit = scale == dvec3(1.0);
  const bool own_reader = !holdsScene(path);
  if (own_reader) options.metres_per_unit = uniform ? scale.x : 1.0;  // ROS reads no unit out of a mesh file.
  auto read = readWholeMesh(path, options, diagnostics_, &scenes_);
  HAPTICELL_TRY(read);
  if (!own_reader || !uniform) scaleBy(*read, scale);
  return meshes_[key] = std::make_shared<geometry::TriangleMesh>(std::move(*read));
}

std::shared_ptr<const geometry::TriangleMesh> UrdfShapes::fileMesh(const UrdfShape& source, std::string& file) {
  const std::string& name = source.mesh;
  if (leavesPackage(name)) {
    reportOnce(source.line, name, Text("the mesh %1 is outside the package; the shape is left out", name));
    return nullptr;
  }
  const std::optional<FoundFile>& found = find(name);
  if (!found) {
    package_missing_ = package_missing_ || name.find("package://") != std::string::npos;
    reportOnce(source.line, name, Text("the mesh %1 does not exist; the shape is left out", name));
    return nullptr;
  }
  if (!found->taken_for_package.empty())
    reportOnce(source.line, found->taken_for_package.string(), takenForPackage(name, *found));
  const std::string extension = lowerExtension(found->path);
  const std::string format = extension.empty() ? "no extension" : extension.substr(1);
  if (!readable(extension) && !holdsScene(found->path)) {
    unreadable_formats_.insert(format);
    return nullptr;
  }
  auto read = scaledMesh(source, found->path);
  if (!read) {  // The file is at fault, not its format: no advice to convert it.
    reportOnce(source.line, name, Text("the shape is left out: %1", read.error().text()));
    return nullptr;
  }
  file = found->path.string();
  return *read;
}

std::optional<LinkShape> UrdfShapes::shapeOf(const UrdfShape& source, int& lost) {
  LinkShape shape;
  shape.X_LS = source.X_LS;
  if (source.kind == Kind::kNone || source.kind == Kind::kEmpty) {
    diagnostics_.warn(Text("%1: %2; the shape is left out", lines_.words(source.line), source.reason));
    if (source.kind == Kind::kNone) ++lost;
    return std::nullopt;
  }
  if (source.kind == Kind::kMesh) {
    shape.mesh = fileMesh(source, shape.source);
  } else {
    shape.mesh = std::make_shared<geometry::TriangleMesh>(primitiveOf(source));
    shape.source = nameOf(source.kind);
  }
  if (!shape.mesh) {
    ++lost;
    return std::nullopt;
  }
  return shape;
}

Expected<void> UrdfShapes::fill(const UrdfLink& source, kinematics::Link& link) {
  link_ = source.name;
  int lost_visuals = 0, lost_collisions = 0;
  std::optional<std::array<float, 4>> color;
  for (const UrdfShape& visual : source.visuals) {
    auto shape = shapeOf(visual, lost_visuals);
    if (!color) color = visual.color;
    if (!shape) continue;
    if (visual.color) shape->color = *visual.color;
    link.visuals.push_back(std::move(*shape));
  }
  for (const UrdfShape& collision : source.collisions) {
    auto shape = shapeOf(collision, lost_collisions);
    if (!shape) continue;
    if (color) shape->color = *color;
    link.collisions.push_back(std::move(*shape));
  }
  if (scenes_.isCancelled()) return makeError({.file = lines_.file(), .found = "the reading was cancelled"});
  link.lost_shapes = lost_visuals + lost_collisions;
  // A set of which a part cannot be read is replaced as a whole: half a link would mislead.
  const bool visuals_whole = !link.visuals.empty() && lost_visuals == 0;
  const bool collisions_whole = !link.collisions.empty() && lost_collisions == 0;
  if (lost_visuals > 0 && collisions_whole) {
    link.visuals = link.collisions;
    shown_by_collision_.push_back(link.name);
  }
  if (!collisions_whole && visuals_whole) {
    link.collisions = link.visuals;
    if (lost_collisions > 0) checked_by_visual_.push_back(link.name);
  }
  if (link.lost_shapes == 0 || visuals_whole || collisions_whole) return {};
  if (link.collisions.empty()) link.collisions = link.visuals;
  if (link.visuals.empty()) link.visuals = link.collisions;
  (link.collisions.empty() ? without_shape_ : partly_).push_back(link.name);
  return {};
}

void UrdfShapes::reportReplacements() {
  const std::string formats = listed(unreadable_formats_);
  const Text reason =
      formats.empty() ? Text("shapes that cannot be read") : Text("shapes that cannot be read (%1)", formats);
  if (!shown_by_collision_.empty())
    diagnostics_.warn(Text("%1: the collision shape is shown for %2", reason, quotedNames(shown_by_collision_)));
  if (!checked_by_visual_.empty())
    diagnostics_.warn(
        Text("%1: the visual shape is used for collision checks of %2", reason, quotedNames(checked_by_visual_)));
  if (!partly_.empty()) diagnostics_.warn(Text("%1: only partly shown and checked: %2", reason, quotedNames(partly_)));
  if (!without_shape_.empty())
    diagnostics_.warn(Text("%1: not shown and not checked: %2", reason, quotedNames(without_shape_)));
  if (!unreadable_formats_.empty() && (!without_shape_.empty() || !partly_.empty()))
    diagnostics_.warn("meshes that cannot be read: convert them to STL, OBJ or PLY");
  if (package_missing_)
    diagnostics_.warn(
        "packages that are not found: put the package folder next to the robot file or above it, or add its path to "
        "ROS_PACKAGE_PATH");
}

}  // namespace hapticell::workcell
