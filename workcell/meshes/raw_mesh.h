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

/// What a file calls a run of faces.
struct MeshLabel {
  std::size_t object_number = 0;  ///< Counts the file's objects, so that two of one name stay two; 0: none was named.
  std::string object, group, material;

  bool operator==(const MeshLabel&) const = default;
};

/// What a reader makes of a file: triangles in the file's own unit and what it says about them. Nothing is welded.
struct RawMesh {
  geometry::TriangleMesh mesh;
  bool shared_corners = false;       ///< A soup in the file, of which corners at one place were made one vertex.
  std::vector<std::uint32_t> label;  ///< Of each triangle, an index into `labels`; empty: the file names nothing.
  std::vector<MeshLabel> labels;
  std::vector<Color> color;                 ///< Of each triangle, kNoColor where it has none; empty: no face has one.
  std::optional<double> metres_per_unit;    ///< As a comment of the file states it.
  std::vector<std::string> material_files;  ///< Named by the file; searched next to it.
};

}  // namespace hapticell::workcell
