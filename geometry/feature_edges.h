// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace hapticell::geometry {

/// The angle between two faces, rad, from which on their common edge is drawn and shaded as an edge: 28 degrees.
inline constexpr double kCreaseAngle = 28.0 * std::numbers::pi / 180.0;

/// An edge that is worth drawing, as two vertex indices.
struct FeatureEdge {
  enum class Kind {
    kCrease,       ///< Two faces that meet at an angle.
    kBorder,       ///< One face only: the surface is open here.
    kNonManifold,  ///< Three or more faces, or two that face opposite ways.
  };
  std::array<std::uint32_t, 2> vertices{};
  Kind kind = Kind::kCrease;
};

/// The edges of a welded mesh that show its shape, each once, in the order of their vertices. Edges between coplanar or
/// gently bent faces are left out. Works on the soup itself, so that no triangle is lost to a half-edge structure.
std::vector<FeatureEdge> featureEdges(const TriangleMesh& mesh, double crease_angle = kCreaseAngle);

}  // namespace hapticell::geometry
