// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

/// A half-space boundary: nhat . p = offset; the inside is nhat . p <= offset.
struct HullPlane {
  dvec3 nhat{0.0, 0.0, 1.0};  ///< Unit, outward.
  double offset = 0.0;        ///< Metres.
};

/// An edge of a hull between two faces that are not coplanar.
struct HullEdge {
  std::array<std::uint32_t, 2> vertices{};
  std::array<std::uint32_t, 2> planes{};
};

/// A convex polyhedron: its corners, the planes of its faces (coplanar triangles counted once) and its sharp edges.
struct ConvexHull {
  std::vector<dvec3> vertices;
  std::vector<HullPlane> planes;
  std::vector<HullEdge> edges;
};

/// The convex hull of points, by quickhull (Barber, Dobkin, Huhdanpaa 1996).
///
/// Points within `tolerance` (m) of the hull may be left out. Empty if the points span no volume thicker than the
/// tolerance, or if rounding makes the result wrong (every point is checked against every plane).
std::optional<ConvexHull> convexHull(std::span<const dvec3> points, double tolerance);

/// The prism over the planar convex hull (Andrew's monotone chain, 1979) of points that lie in about one plane with
/// unit normal nhat: its front face goes through the foremost of them, its back is `thickness` (m) behind that. Empty
/// if they span no area.
std::optional<ConvexHull> convexPrism(std::span<const dvec3> points, const dvec3& nhat, double thickness);

}  // namespace hapticell::collision
