// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::workcell {

/// A mesh in the frame of the file, with what some formats can say about it besides.
struct NamedMesh {
  std::string name;
  geometry::TriangleMesh mesh;
  std::array<float, 3> color{0.72f, 0.74f, 0.76f};  ///< sRGB.
};

// The text or bytes of mesh files. Coordinates are divided by `metres_per_unit`, which a comment states ("units: m";
// see statedUnit()). Numbers as text are the shortest that give the same double again, '.' as point whatever the
// locale; binary ones are 32 bits wide (STL, PLY).

/// Binary STL: one soup, no names, no colours.
std::string stlBytes(std::span<const NamedMesh> meshes, double metres_per_unit);
/// Binary little-endian PLY: one soup with a colour at each vertex.
std::string plyBytes(std::span<const NamedMesh> meshes, double metres_per_unit);
/// OFF: one soup with a colour at each face.
std::string offText(std::span<const NamedMesh> meshes, double metres_per_unit);
/// OBJ with an object a mesh; `material_file` is the name of the file for objMaterials(), or empty.
std::string objText(std::span<const NamedMesh> meshes, double metres_per_unit, const std::string& material_file);
std::string objMaterials(std::span<const NamedMesh> meshes);

}  // namespace hapticell::workcell
