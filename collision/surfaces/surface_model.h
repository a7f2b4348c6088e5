// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "collision/trees/mesh_collider.h"
#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Where a surface ends, for a ball of radius r whose centre is on the surface's offset: its value is
/// signedDistance(surface, .) - r * per_radius.
struct ElementTrim {
  SurfaceShape surface;
  double per_radius = 0.0;
};

/// An element of a mesh that a point (or a ball) can meet: a recognised surface with its ends, a facet of a free-form
/// region, or the rounding that a ball sees at a convex edge.
struct SurfaceElement {
  SurfaceShape shape;              ///< Never free form: facets are planes. Edges: a cylinder of radius 0.
  std::vector<ElementTrim> trims;  ///< Convex: all count (min); concave: free beyond any of them (max).
  double sagitta = 0.0;            ///< m.
  double raised = 0.0;             ///< m by which facets of collider() are in front of a hollow surface.
  bool facet = false;              ///< Of a free-form region.
  bool edge = false;
};

/// A point of a body that could meet something: a sharp corner, or the middle of a sphere.
struct BodyPoint {
  dvec3 p_M{0.0};
  double radius = 0.0;   ///< m.
  dvec3 nhat_M{0.0};     ///< Balls: only directions near this one are valid,
  double cosine = -1.0;  ///< with at least this cosine.
};

/// A circle of such points: a sharp rim, or the middle line of a ring's tube.
struct BodyCircle {
  dvec3 center_M{0.0};
  dvec3 e1_M{1.0, 0.0, 0.0};  ///< Unit; angles are measured from here towards e2.
  dvec3 e2_M{0.0, 1.0, 0.0};
  double ring = 0.0;            ///< m.
  double radius = 0.0;          ///< Of the tube, m.
  double from = 0.0, to = 0.0;  ///< rad; the whole circle if to - from is 2 pi.
  bool isWhole() const { return to - from > 6.283; }
  dvec3 at(double angle) const;
};

/// A convex edge (radius 0) or a convex cylinder's axis.
struct BodyRod {
  dvec3 a_M{0.0}, b_M{0.0};
  double radius = 0.0;
  dvec3 n1_M{0.0}, n2_M{0.0};  ///< Edges: unit normals of the two faces. Cylinders: n1 is the middle of the arc.
  double cosine = -1.0;        ///< Cylinders: of half their arc.
};

/// A mesh prepared for contacts: its recognised surfaces as obstacle; its points, circles and edges as moved body.
/// Immutable after build; any thread may read it.
class SurfaceModel {
 public:
  static constexpr std::uint32_t kNone = RecognisedSurface::kNone;

  /// Recognises the mesh (about 1.5 s for 100 000 triangles; the surfaces and the tree are kept in the cache folder).
  /// Null when cancelled.
  static std::shared_ptr<const SurfaceModel> build(const geometry::TriangleMesh& mesh, const ColliderBuild& how = {});
  /// From surfaces recognised earlier.
  static std::shared_ptr<const SurfaceModel> build(RecognisedSurface surface, const ColliderBuild& how = {});

  const RecognisedSurface& surface() const { return surface_; }
  /// The collider of relievedMesh(surface()), for exact motion checks: with it a peg fits into its bore.
  const MeshCollider& collider() const { return *collider_; }
  const std::shared_ptr<const MeshCollider>& sharedCollider() const { return collider_; }
  const geometry::Bounds& bounds() const { return collider_->bounds(); }

  const std::vector<SurfaceElement>& elements() const { return elements_; }
  std::uint32_t elementOf(std::uint32_t triangle) const { return element_of_[triangle]; }
  /// The rounding of the edge from corner k to k + 1, or kNone if the edge is not straight and convex.
  std::uint32_t edgeElementOf(std::uint32_t triangle, int k) const {
    return edge_element_of_[triangle][static_cast<std::size_t>(k)];
  }

  const std::vector<BodyPoint>& points() const { return points_; }
  const std::vector<BodyCircle>& circles() const { return circles_; }
  enum class RodKind : std::uint8_t {
    kEdge,   ///< Straight convex edges,
    kRound,  ///< axes of convex cylinders,
    kRim,    ///< chords of curved borders.
  };
  std::span<const BodyRod> rods(RodKind kind) const { return rods_[static_cast<std::size_t>(kind)]; }
  /// The rods' middle lines as flat triangles; null if there are no such rods.
  const MeshCollider* rodLines(RodKind kind) const { return rod_lines_[static_cast<std::size_t>(kind)].get(); }
  double thickestRod() const { return thickest_rod_; }  ///< Radius, m.

 private:
  friend class ModelBuilder;
  SurfaceModel() = default;

  RecognisedSurface surface_;
  std::shared_ptr<const MeshCollider> collider_;
  std::vector<SurfaceElement> elements_;
  std::vector<std::uint32_t> element_of_;
  std::vector<std::array<std::uint32_t, 3>> edge_element_of_;
  std::vector<BodyPoint> points_;
  std::vector<BodyCircle> circles_;
  std::array<std::vector<BodyRod>, 3> rods_;
  std::array<std::shared_ptr<const MeshCollider>, 3> rod_lines_;
  double thickest_rod_ = 0.0;
};

/// Value (m) of an element for a ball of this radius with its centre at p_MP, trims included: free where positive.
double elementValue(const SurfaceElement& element, const dvec3& p_MP, double radius);

}  // namespace hapticell::collision
