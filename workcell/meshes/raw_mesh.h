// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::workcell {

using Color = std::array<float, 3>;  ///< sRGB, 0 to 1.

/// Marks a face without its own colour.
inline constexpr Color kNoColor{-1.0f, -1.0f, -1.0f};

inline bool isColor(const Color& color) {
  return color[0] >= 0.0f;
}

/// The name of a range of faces in a file.
struct MeshLabel {
  std::size_t object_number = 0;  ///< Number of the object, which separates objects of one name; 0: no name.
  std::string object, group, material;

  bool operator==(const MeshLabel&) const = default;
};

/// The result of a reader: triangles in the file's own unit, and the file's data about them. Not welded.
struct RawMesh {
  geometry::TriangleMesh mesh;
  bool shared_corners = false;       ///< A soup in the file, of which corners at one place were made one vertex.
  std::vector<std::uint32_t> label;  ///< Of each triangle, an index into `labels`; empty: the file names nothing.
  std::vector<MeshLabel> labels;
  std::vector<Color> color;                 ///< For each triangle, kNoColor if it has none; empty: no face has one.
  std::optional<double> metres_per_unit;    ///< As stated by a comment of the file.
  std::vector<std::string> material_files;  ///< Named by the file; searched next to it.
};

}  // namespace hapticell::workcell
