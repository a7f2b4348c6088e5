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
  dvec3 p_M{0.0};               ///< Plane: a point of it; cylinder: of the axis; cone: apex; sphere, torus: centre.
  dvec3 axis_M{0.0, 0.0, 1.0};  ///< Unit. Plane: outward normal; cone: from the apex to where it opens.
  double radius = 0.0;          ///< Cylinder, sphere; torus: of the tube.
  double major_radius = 0.0;    ///< Torus: of the ring.
  double half_angle = 0.0;      ///< Cone: between axis and surface, in (0, pi/2).
  double side = 1.0;            ///< +1: material inside (convex), -1: around it (bore). Planes: always +1.
};

/// What a surface looks like from a point nearby.
struct SurfaceView {
  double value = 0.0;           ///< Signed distance, m, positive outside the material.
  dvec3 nhat_M{0.0, 0.0, 1.0};  ///< Outward unit normal at the foot: the gradient of `value`.
  dvec3 t1_M{1.0, 0.0, 0.0};    ///< Unit, direction of the curvature k1; k2 goes with nhat x t1.
  double k1 = 0.0;              ///< 1/m at the foot, positive where the material is convex.
  double k2 = 0.0;
};

/// Signed distance (m) of p_MQ from the surface, positive outside the material. Exact but for points beyond a cone's
/// apex, where it is less than the distance. Free form: contract.
double signedDistance(const SurfaceShape& shape, const dvec3& p_MQ);

/// The same with the foot's normal and curvatures.
SurfaceView viewFrom(const SurfaceShape& shape, const dvec3& p_MQ);

/// Largest curvature of the surface that is convex, as a radius (m): infinite for planes.
double smallestRadius(const SurfaceShape& shape);

enum class BorderKind : std::uint8_t { kSmooth, kConvex, kConcave, kOpen };

/// Where a region meets another (or nothing), found from the surfaces' normals and not from the facets'.
struct RegionBorder {
  std::uint32_t neighbour = 0xFFFFFFFFu;  ///< Index of the region; none at an open border.
  BorderKind kind = BorderKind::kOpen;
  std::uint32_t edges = 0;  ///< Of the mesh.
};

/// A connected part of a mesh's surface that lies on one SurfaceShape. Free-form regions are single facets' neighbours
/// that fit none; they have no shape.
struct SurfaceRegion {
  SurfaceShape shape;
  double residual = 0.0;   ///< m: greatest distance of a vertex from the surface.
  double sagitta = 0.0;    ///< m: greatest distance of an edge's middle from the surface.
  double area = 0.0;       ///< m2, of the facets.
  dvec3 mean_nhat_M{0.0};  ///< Unit, of the facets by area; zero where they cancel.
  /// Where a surface that is not whole ends: planes, for rings cones or cylinders. A convex one counts where every
  /// trim's signedDistance is positive; a concave one is left where that of one of them is.
  std::vector<SurfaceShape> trims;
  std::vector<std::uint32_t> triangles;  ///< Of RecognisedSurface::mesh.
  std::vector<RegionBorder> borders;
};

/// No region, no triangle.
inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

/// A mesh with its surfaces recognised: plain data, so it can be kept on disk by the mesh's content.
struct RecognisedSurface {
  static constexpr std::uint32_t kNone = kNoIndex;

  geometry::TriangleMesh mesh;  ///< Welded, degenerate and duplicate triangles dropped.
  std::vector<SurfaceRegion> regions;
  std::vector<std::uint32_t> region_of;                 ///< Per triangle of `mesh`.
  std::vector<std::array<std::uint32_t, 3>> neighbour;  ///< Triangle across the edge from corner k, or kNoIndex.
  std::vector<dvec3> normals;                           ///< Unit, per triangle.
  std::vector<std::uint32_t> component;                 ///< Per triangle: connected over corners.
  std::uint32_t components = 0;
  bool closed = false;  ///< Every edge has two triangles that go along it in opposite directions.

  /// The part of the area (0 to 1) that is not free form.
  double recognisedShare() const;
  /// Greatest sagitta of all regions, m.
  double greatestSagitta() const;
};

}  // namespace hapticell::collision
