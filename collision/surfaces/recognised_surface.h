// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/bounds.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

enum class SurfaceType : std::uint8_t { kPlane, kCylinder, kCone, kSphere, kTorus, kFreeForm };

/// A surface of one of the five types of CAD, unbounded, in the mesh's frame M; metres, radians.
struct SurfaceShape {
  SurfaceType type = SurfaceType::kPlane;
  dvec3 p_M{0.0};               ///< Plane: a point of it; cylinder: a point of the axis; cone: apex; sphere, torus:
                                ///< centre.
  dvec3 axis_M{0.0, 0.0, 1.0};  ///< Unit. Plane: outward normal; cone: from the apex to where it opens.
  double radius = 0.0;          ///< Cylinder, sphere; torus: of the tube.
  double major_radius = 0.0;    ///< Torus: of the ring.
  double half_angle = 0.0;      ///< Cone: between axis and surface, in (0, pi/2).
  double side = 1.0;            ///< +1: material inside (convex), -1: around it (bore). Planes: always +1.
};

/// A surface as seen from a nearby point.
struct SurfaceView {
  double value = 0.0;           ///< Signed distance, m, positive outside the material.
  dvec3 nhat_M{0.0, 0.0, 1.0};  ///< Outward unit normal at the foot: the gradient of `value`.
  dvec3 t1_M{1.0, 0.0, 0.0};    ///< Unit, direction of the curvature k1; k2 belongs to nhat x t1.
  double k1 = 0.0;              ///< 1/m at the foot, positive where the material is convex.
  double k2 = 0.0;
};

/// Signed distance (m) of p_MQ from the surface, positive outside the material. Exact except for points beyond a cone's
/// apex, where it is less than the distance. Contract: not free form.
double signedDistance(const SurfaceShape& shape, const dvec3& p_MQ);

/// The same with the normal and curvatures at the foot.
SurfaceView viewFrom(const SurfaceShape& shape, const dvec3& p_MQ);

/// Largest curvature of the surface that is convex, as a radius (m): infinite for planes.
double smallestRadius(const SurfaceShape& shape);

enum class BorderKind : std::uint8_t { kSmooth, kConvex, kConcave, kOpen };

/// Where a region meets another (or an open border), found from the surfaces' normals, not the facets'.
struct RegionBorder {
  std::uint32_t neighbour = 0xFFFFFFFFu;  ///< Index of the region; kNoIndex at an open border.
  BorderKind kind = BorderKind::kOpen;
  std::uint32_t edges = 0;  ///< Number of edges of the mesh.
};

/// A connected part of a mesh's surface that lies on one SurfaceShape. Free-form regions are connected facets that fit
/// no surface; they have no shape.
struct SurfaceRegion {
  SurfaceShape shape;
  double residual = 0.0;   ///< m: greatest distance of a vertex from the surface.
  double sagitta = 0.0;    ///< m: greatest distance of an edge's middle from the surface.
  double area = 0.0;       ///< m2, of the facets.
  dvec3 mean_nhat_M{0.0};  ///< Unit, of the facets by area; zero where they cancel.
  /// Where a partial surface ends: planes or, for rings, cones or cylinders. A convex surface counts where the
  /// signedDistance of every trim is positive; a concave one ends where that of one trim is positive.
  std::vector<SurfaceShape> trims;
  std::vector<std::uint32_t> triangles;  ///< Indices in RecognisedSurface::mesh.
  std::vector<RegionBorder> borders;
};

/// Marks "no region" or "no triangle".
inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

/// A mesh with its surfaces recognised: plain data that can be cached on disk under the hash of the mesh's content.
struct RecognisedSurface {
  static constexpr std::uint32_t kNone = kNoIndex;

  geometry::TriangleMesh mesh;  ///< Welded, degenerate and duplicate triangles dropped.
  std::vector<SurfaceRegion> regions;
  std::vector<std::uint32_t> region_of;                 ///< Per triangle of `mesh`.
  std::vector<std::array<std::uint32_t, 3>> neighbour;  ///< Triangle across the edge from corner k, or kNoIndex.
  std::vector<dvec3> normals;                           ///< Unit, per triangle.
  std::vector<std::uint32_t> component;                 ///< Per triangle: triangles that share corners have the same
                                                        ///< number.
  std::uint32_t components = 0;
  bool closed = false;  ///< Every edge has two triangles that go along it in opposite directions.

  /// The part of the area (0 to 1) that is not free form.
  double recognisedShare() const;
  /// Greatest sagitta of all regions, m.
  double greatestSagitta() const;
};

}  // namespace hapticell::collision
