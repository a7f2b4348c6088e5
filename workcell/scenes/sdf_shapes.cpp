// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_shapes.h"

#include <algorithm>
#include <cstdio>

#include "geometry/shapes/shapes.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

void scaleOutward(geometry::TriangleMesh& mesh, const dvec3& scale) {
  for (dvec3& vertex : mesh.vertices) vertex *= scale;
  if (scale.x * scale.y * scale.z > 0.0) return;
  for (geometry::Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);  // Outward stays outward.
}

/// The shapes that need no file; empty for all others.
geometry::TriangleMesh plainShape(const SdfShape& shape) {
  const dvec3& size = shape.size;
  switch (shape.kind) {
    case SdfShape::Kind::kBox:
      return geometry::makeBox(size);
    case SdfShape::Kind::kCylinder:
      return geometry::makeCylinder(size.x, size.y);
    case SdfShape::Kind::kSphere:
      return geometry::makeSphere(size.x);
    case SdfShape::Kind::kCapsule:
      return geometry::makeCapsule(size.x, size.y);
    case SdfShape::Kind::kEllipsoid: {
      geometry::TriangleMesh mesh = geometry::makeSphere(1.0);
      scaleOutward(mesh, size);
      return mesh;
    }
    case SdfShape::Kind::kNone:
    case SdfShape::Kind::kMesh:
      break;
  }
  return {};
}

/// All that stands at or below nodes of that name; empty if there is no such node.
geometry::TriangleMesh partOf(const ImportedScene& scene, const std::string& name) {
  const std::vector<Pose> X_F = nodePoses(scene);
  std::vector<bool> chosen(scene.nodes.size(), false);
  geometry::TriangleMesh mesh;
  for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
    const SceneNode& node = scene.nodes[k];
    chosen[k] = node.name == name || node.instance == name ||
                (node.parent >= 0 && chosen[static_cast<std::size_t>(node.parent)]);
    if (chosen[k] && node.mesh >= 0) {
      geometry::append(mesh, scene.meshes[static_cast<std::size_t>(node.mesh)], X_F[k]);
    }
  }
  return mesh;
}

}  // namespace

ImportOptions asGazeboDoes() {
  ImportOptions options;
  options.up_axis = UpAxis::kZ;
  options.warn_about_unit = false;
  return options;
}

SdfShapes::SdfShapes(const SdfSource& source, const ImportOptions& options, ImportMonitor* monitor)
    : source_(source), scenes_(options, monitor), monitor_(monitor) {
  std::vector<fs::path> files;
  for (const SdfMeshFile& mesh : source.meshFiles()) files.push_back(mesh.file);
  scenes_.readAhead(files);
}

Expected<geometry::TriangleMesh> SdfShapes::wholeOrPart(const fs::path& file, const SdfShape& mesh) {
  ImportOptions options = scenes_.options();
  const bool scene = holdsScene(file);
  if (!scene) options.metres_per_unit = 1.0;  // Gazebo reads no unit out of a mesh file.
  if (mesh.submesh.empty()) return readWholeMesh(file, options, notes_, &scenes_);
  geometry::TriangleMesh part;
  if (scene) {
    const auto read = scenes_.scene(file);
    HAPTICELL_TRY(read);
    part = partOf(*read, mesh.submesh);
  } else {
    auto parts = readMeshParts(file, {options.metres_per_unit, options.weld, false}, true, notes_);
    HAPTICELL_TRY(parts);
    part = partOf(sceneOfParts(std::move(*parts), file.stem().string()), mesh.submesh);
  }
  if (part.triangles.empty()) {
    return makeError({.file = file.string(),
                      .found = Text("it has no part '%1'", mesh.submesh),
                      .expected = "the part that <submesh> names"});
  }
  if (mesh.center_submesh) {
    const dvec3 middle = part.bounds().center();
    for (dvec3& vertex : part.vertices) vertex -= middle;
  }
  return part;
}

SdfShapes::MeshPointer SdfShapes::meshOfFile(const SdfShape& mesh, const std::string& owner) {
  const SdfMeshFile& file = source_.meshFile(mesh);
  const dvec3 scale = mesh.size;
  char size[100];
  std::snprintf(size, sizeof size, "|%.17g %.17g %.17g|%d|", scale.x, scale.y, scale.z, mesh.center_submesh);
  const auto [known, is_new] = known_.try_emplace(file.file.string() + size + mesh.submesh);
  if (!is_new) return known->second;
  auto read = wholeOrPart(file.file, mesh);
  if (monitor_) monitor_->report(Text("reading meshes"), 1.0 - 1.0 / (1.0 + 0.1 * static_cast<double>(known_.size())));
  if (!read) {
    notes_.warn(Text("'%1': its mesh %2 is left out: %3", owner, file.uri, read.error().text()));
    return nullptr;
  }
  scaleOutward(*read, scale);
  return known->second = std::make_shared<const geometry::TriangleMesh>(std::move(*read));
}

SdfShapes::MeshPointer SdfShapes::meshOf(const SdfShape& shape, const std::string& owner) {
  if (shape.kind == SdfShape::Kind::kMesh) return meshOfFile(shape, owner);
  geometry::TriangleMesh mesh = plainShape(shape);
  return mesh.triangles.empty() ? nullptr : std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

}  // namespace hapticell::workcell
