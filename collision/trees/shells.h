// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/trees/box_tree.h"
#include "geometry/shapes/bounds.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// The connected pieces of a mesh and which of them enclose a volume. Immutable after construction.
///
/// Corners within weldTolerance() of each other count as joined. A piece is closed when an even number of its triangles
/// meets at every edge. Closed pieces whose triangles all face the same way count by signed crossings: a cavity (a
/// shell turned inwards) is outside, and overlapping solids are inside. Other closed pieces count by parity.
class Shells {
 public:
  enum class Kind : std::uint8_t { kOpen, kOriented, kUnoriented };

  Shells() = default;
  explicit Shells(const geometry::TriangleMesh& mesh);

  std::size_t count() const { return point_of_piece_.size(); }
  std::size_t triangleCount() const { return piece_of_triangle_.size(); }
  /// True if there is at least one piece and every piece is closed.
  bool allClosed() const { return count() > 0 && open_pieces_ == 0; }
  bool anyClosed() const { return count() > open_pieces_; }
  /// One point p_MV of each piece's surface.
  const std::vector<dvec3>& points() const { return point_of_piece_; }
  /// The index of a triangle's piece, below count().
  std::uint32_t piece(std::uint32_t triangle) const { return piece_of_triangle_[triangle]; }
  Kind kind(std::uint32_t triangle) const { return kind_of_piece_[piece_of_triangle_[triangle]]; }
  /// The box of the closed pieces, in M; empty if no piece is closed.
  const geometry::Bounds& closedBounds() const { return closed_bounds_; }
  /// Bytes held.
  std::size_t memory() const {
    return piece_of_triangle_.capacity() * sizeof(std::uint32_t) + kind_of_piece_.capacity() +
           point_of_piece_.capacity() * sizeof(dvec3);
  }

 private:
  template <typename Edges>
  void classify(const Edges& edges);

  std::vector<std::uint32_t> piece_of_triangle_;
  std::vector<Kind> kind_of_piece_;
  std::vector<dvec3> point_of_piece_;
  geometry::Bounds closed_bounds_;
  std::size_t open_pieces_ = 0;
};

/// The signed solid angle of a triangle from a point, positive from its back (van Oosterom & Strackee 1983).
double solidAngle(const Corners& corners, const dvec3& p);

/// Whether a point p_MQ that is not on the surface lies inside a closed piece. It counts ray crossings; a ray that
/// grazes an edge is replaced by another, and after eight such rays the winding number (van Oosterom & Strackee 1983)
/// decides.
bool isInside(const Shells& shells, const BoxTree& tree, const geometry::TriangleMesh& mesh, const dvec3& p_MQ);

}  // namespace hapticell::collision
