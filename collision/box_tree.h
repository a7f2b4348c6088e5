// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/triangle_distance.h"
#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::collision {

/// An oriented box in some frame F.
struct OrientedBox {
  dmat3 R{1.0};       ///< Columns: the box's axes in F.
  dvec3 center{0.0};  ///< In F, metres.
  dvec3 half{0.0};    ///< Half sizes along the axes, metres.
};

/// The same box seen from A, by the rotation and position of F in A.
OrientedBox moved(const dmat3& R_AF, const dvec3& p_AF, const OrientedBox& box_F);

/// The square of a length that no two points of the boxes (both in one frame) are nearer than: the larger of the gap
/// vectors' norms in the two boxes' own axes.
double lowerBoundSquared(const OrientedBox& a, const OrientedBox& b);

/// The square of the distance from a point to a box.
double lowerBoundSquared(const OrientedBox& box, const dvec3& point);

/// The same for a triangle and a box: their gap along the line from the triangle to the box's middle. Tight where the
/// box is smaller than the triangle.
double lowerBoundSquared(const OrientedBox& box, const Corners& triangle);

/// A binary tree of oriented boxes over a mesh's triangles, in the mesh's frame. Immutable after build.
///
/// Boxes are fitted to the area-weighted covariance of their triangles, to the largest triangle with its longest edge,
/// or to the mesh's axes, whichever has the least surface (Gottschalk et al., "OBBTree", 1996); nodes are split by a
/// binned surface-area heuristic (Wald 2007), and in the middle where that finds nothing, so the depth stays bounded.
class BoxTree {
 public:
  struct Node {
    OrientedBox box;
    double size = 0.0;        ///< Half diagonal: decides which of two nodes is opened first.
    std::uint32_t first = 0;  ///< First slot of a leaf, or the index of the first child (the second follows).
    std::uint32_t count = 0;  ///< Triangles of a leaf; 0 marks an inner node.
    bool isLeaf() const { return count != 0; }
  };

  BoxTree() = default;
  explicit BoxTree(const geometry::TriangleMesh& mesh);

  bool isEmpty() const { return nodes_.empty(); }
  const Node& root() const { return nodes_.front(); }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  /// Triangles are kept in the order of the leaves; a slot is a place in that order.
  const Corners& corners(std::uint32_t slot) const { return corners_[slot]; }
  std::uint32_t triangle(std::uint32_t slot) const { return triangle_of_slot_[slot]; }
  std::uint32_t slot(std::uint32_t triangle) const { return slot_of_triangle_[triangle]; }
  std::size_t nodeCount() const { return nodes_.size(); }

 private:
  std::vector<Node> nodes_;
  std::vector<Corners> corners_;
  std::vector<std::uint32_t> triangle_of_slot_;
  std::vector<std::uint32_t> slot_of_triangle_;
};

}  // namespace hapticell::collision
