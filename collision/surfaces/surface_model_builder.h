// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/surfaces/surface_model.h"

namespace hapticell::collision {

/// A convex mesh edge between two triangles, seen from `triangle`'s corner k to k + 1.
struct SharpEdge {
  std::uint32_t triangle, other;
  int k;
  std::uint32_t a, b;       // vertices
  std::uint32_t low, high;  // regions
};

/// Whether a surface of this type is curved and not free form.
inline bool isRound(SurfaceType type) {
  return type != SurfaceType::kPlane && type != SurfaceType::kFreeForm;
}

/// Builds from a recognised surface what contacts need: elements with their ends, corners, rims, rods and balls.
class ModelBuilder {
 public:
  explicit ModelBuilder(SurfaceModel& model) : model_(model), surface_(model.surface_) {}

  void run() {
    makeElements();
    findSharpEdges();
    makeStraightRods();
    makeCornerPoints();
    makeRims();
    makeRoundBodies();
  }

 private:
  const SurfaceRegion& regionOf(std::uint32_t triangle) const { return surface_.regions[surface_.region_of[triangle]]; }
  dvec3 normalAt(std::uint32_t triangle, const dvec3& p) const {
    const SurfaceRegion& region = regionOf(triangle);
    return region.shape.type == SurfaceType::kFreeForm ? surface_.normals[triangle] : viewFrom(region.shape, p).nhat_M;
  }
  void makeElements();
  void findSharpEdges();
  bool isSharp(std::uint32_t t, std::uint32_t other, int k) const;
  bool isConeFacet(const SharpEdge& edge) const {
    return edge.low == edge.high && surface_.regions[edge.low].shape.type == SurfaceType::kCone;
  }
  void addRod(SurfaceModel::RodKind kind, const BodyRod& rod) {
    model_.rods_[static_cast<std::size_t>(kind)].push_back(rod);
  }
  void makeStraightRods();
  void addEdgeElement(const SharpEdge& edge, std::uint32_t& name);
  void makeCornerPoints();
  void makeRims();
  bool addRim(std::uint32_t round_region, const std::vector<const SharpEdge*>& edges);
  void makeRoundBodies();
  void addCylinder(const SurfaceRegion& region);
  void addRing(const SurfaceRegion& region);

  SurfaceModel& model_;
  const RecognisedSurface& surface_;
  std::vector<SharpEdge> sharp_;
  std::vector<std::uint8_t> on_rim_;  // per vertex
};

}  // namespace hapticell::collision
