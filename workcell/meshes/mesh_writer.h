// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::workcell {

/// A mesh in the frame of the file, with the data that some formats can store with it.
struct NamedMesh {
  std::string name;
  geometry::TriangleMesh mesh;
  std::array<float, 3> color{0.72f, 0.74f, 0.76f};  ///< sRGB.
};

// The text or bytes of mesh files. Coordinates are divided by `metres_per_unit`, which a comment states ("units: m";
// see statedUnit()). Numbers in text are the shortest that give the same double again, with '.' as decimal point
// whatever the locale; binary ones have 32 bits (STL, PLY).

/// Binary STL: all triangles in one list, no names, no colours.
std::string stlBytes(std::span<const NamedMesh> meshes, double metres_per_unit);
/// Binary little-endian PLY: all triangles in one list, with a colour at each vertex.
std::string plyBytes(std::span<const NamedMesh> meshes, double metres_per_unit);
/// OFF: all triangles in one list, with a colour at each face.
std::string offText(std::span<const NamedMesh> meshes, double metres_per_unit);
/// OBJ with one object per mesh; `material_file` is the name of the file for objMaterials(), or empty.
std::string objText(std::span<const NamedMesh> meshes, double metres_per_unit, const std::string& material_file);
std::string objMaterials(std::span<const NamedMesh> meshes);

}  // namespace hapticell::workcell
