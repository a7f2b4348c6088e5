// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/surfaces/recognised_surface.h"
#include "collision/surfaces/surface_clusters.h"

namespace hapticell::collision {

/// A surface and the triangles that lie on it.
struct GrownRegion {
  SurfaceShape shape;
  std::vector<std::uint32_t> triangles;
};

/// Finds curved surfaces in a connected mesh, one after the other. Triangles that belong to a region are no longer
/// free. One thread.
class RegionGrower {
 public:
  RegionGrower(const RecognisedSurface& surface, const PlanarClusters& clusters);

  bool isFree(std::uint32_t triangle) const { return free_[triangle] != 0; }
  void take(const std::vector<std::uint32_t>& triangles);

  /// Fits a surface to the neighbourhood of a free triangle (four shapes of neighbourhood in turn) and grows the
  /// region; empty if no surface fits at least three clusters within `tolerance` (m).
  std::optional<GrownRegion> regionFrom(std::uint32_t seed, double tolerance);

  /// Whether all three vertices, the edges' middles and the normal agree with the surface.
  bool belongs(std::uint32_t triangle, const SurfaceShape& shape, double tolerance) const;

  /// Whether it has free neighbours across edges of 0.1 to 40 degrees, so is part of something curved.
  bool isCurvedAt(std::uint32_t triangle) const;

 private:
  enum class Neighbourhood { kWide, kNarrow, kLike, kStrip };
  void gather(std::uint32_t seed, Neighbourhood kind, std::vector<std::uint32_t>& found);
  bool enters(std::uint32_t from, int k, std::uint32_t seed, Neighbourhood kind) const;
  bool spansThreeClusters(const std::vector<std::uint32_t>& triangles) const;
  std::optional<SurfaceShape> bestFit(const std::vector<std::uint32_t>& triangles, Neighbourhood kind,
                                      double tolerance);
  bool isRing(const SurfaceShape& shape, const std::vector<dvec3>& points, double deviation) const;
  void grow(GrownRegion& region, double tolerance);
  std::vector<dvec3> verticesOf(const std::vector<std::uint32_t>& triangles, std::size_t most);
  double middleDeviation(const SurfaceShape& shape, const std::vector<std::uint32_t>& triangles) const;

  const RecognisedSurface& surface_;
  const PlanarClusters& clusters_;
  std::vector<double> area_;
  std::vector<std::uint8_t> free_;
  std::vector<std::uint32_t> mark_;         ///< Per triangle: the number of the last search that saw it.
  std::vector<std::uint32_t> vertex_mark_;  ///< Likewise per vertex.
  std::vector<std::uint64_t> failed_;       ///< Per triangle: its neighbourhood when no surface fitted.
  std::vector<std::uint8_t> hopeless_;      ///< Per triangle: the number of such neighbourhoods that contained it.
  std::uint32_t search_ = 0;
};

}  // namespace hapticell::collision
