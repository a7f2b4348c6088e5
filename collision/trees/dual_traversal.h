// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <limits>

#include "collision/trees/box_tree.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// A box of one of two trees while both are traversed.
struct TraversalBox {
  BoxTree::Slot slot = BoxTree::kRoot;
  std::uint32_t child = 0;
  float size = 0.0f;  ///< Square of the half diagonal: the larger of two boxes is opened.
  float half[3];
  dvec3 center{0.0};       ///< In its mesh's frame.
  bool is_seen = false;    ///< The following members are set:
  QueryBox seen;           ///< in the other mesh's frame, relative to the node it was last compared with,
  dvec3 seen_center{0.0};  ///< and in that frame.

  bool isLeaf() const { return BoxTree::isLeaf(child); }
};

/// One of two trees, and the pose of its frame in the other's.
struct TraversalSide {
  const BoxTree& tree;
  dmat3 R;  ///< From its mesh's frame to the other's.
  dvec3 p;
  float R_rows[9];

  TraversalSide(const BoxTree& of, const dmat3& rotation, const dvec3& position);

  TraversalBox box(BoxTree::Slot slot) const;
  /// Sets the members that are in the other mesh's frame.
  void see(TraversalBox& box) const;
};

/// Moves what is seen of a box to the node's origin.
inline void placeAt(TraversalBox& box, const float* origin) {
  for (int i = 0; i < 3; ++i) box.seen.center[i] = static_cast<float>(box.seen_center[i] - double{origin[i]});
}

/// Whether a leaf much larger than the box is farther from it than the limit. It checks the leaf's triangles, because
/// the leaf's box, if long and slanted, can be nearer than its triangles by more than the other box's size.
bool isBeyondTriangles(const LeafBlock& leaf, TraversalBox& box, float limit_squared);

/// Visits the pairs of boxes that are near each other, depth first and nearest first.
///
/// Visitor: float limitSquared(); bool isDone(); void leafPair(const TraversalBox& a, const TraversalBox& b, const
/// LeafBlock&, const LeafBlock&, const LeafTransform&). Optionally bool passesOver(const TraversalBox& a, const
/// TraversalBox& b), and const float* line(bool in_a), a unit vector along which the nearest are probably apart (in A's
/// or B's frame). Optionally void culled(a, b, opened_a, lanes, least_squared), which gets the children of an opened box
/// that were left out and the least of their bounds. Where the meshes move against each other: BoxSweep sweepOf(bool
/// opened_a, const BoxNode& opened, const TraversalBox& other), by which ProximityKernels::sweptBoxBounds decides which
/// children are near. With it float reachSquared(): what may meet is no farther than its square root in the middle.
template <typename Visitor>
class DualTraversal {
 public:
  DualTraversal(const BoxTree& a, const BoxTree& b, const Pose& X_AB, Visitor& visitor)
      : a_(a, glm::transpose(X_AB.R()), -(glm::transpose(X_AB.R()) * X_AB.p)),
        b_(b, X_AB.R(), X_AB.p),
        visitor_(visitor) {}

  /// Traverses both trees completely.
  void run() {
    TraversalBox a = a_.box(BoxTree::kRoot), b = b_.box(BoxTree::kRoot);
    visit(a, b);
  }

  /// Visits some children of one of two boxes against the other box.
  void open(BoxTree::Slot slot_a, BoxTree::Slot slot_b, bool opened_a, unsigned lanes) {
    TraversalBox a = a_.box(slot_a), b = b_.box(slot_b);
    if (opened_a) {
      openOne(a_, a, b_, b, lanes, true);
    } else {
      openOne(b_, b, a_, a, lanes, false);
    }
  }

  void visit(TraversalBox& a, TraversalBox& b) {
    if constexpr (requires { visitor_.passesOver(a, b); }) {
      if (visitor_.passesOver(a, b)) return;
    }
    if (a.isLeaf() && b.isLeaf()) {
      leaves(a, b);
    } else if (b.isLeaf() || (!a.isLeaf() && a.size >= b.size)) {
      if (!isCoveredByLeaf(b, b_, a, a_)) openOne(a_, a, b_, b, kAllLanes, true);
    } else {
      if (!isCoveredByLeaf(a, a_, b, b_)) openOne(b_, b, a_, a, kAllLanes, false);
    }
  }

  void leaves(const TraversalBox& a, const TraversalBox& b) {
    const LeafBlock &leaf_a = a_.tree.leaf(a.child), &leaf_b = b_.tree.leaf(b.child);
    LeafTransform transform;
    const dvec3 origin_b(leaf_b.origin[0], leaf_b.origin[1], leaf_b.origin[2]);
    const dvec3 t = b_.R * origin_b + b_.p - dvec3(leaf_a.origin[0], leaf_a.origin[1], leaf_a.origin[2]);
    for (int i = 0; i < 9; ++i) transform.R[i] = b_.R_rows[i];
    for (int i = 0; i < 3; ++i) transform.t[i] = static_cast<float>(t[i]);
    if constexpr (requires { visitor_.line(true); }) {
      for (int i = 0; i < 3; ++i) transform.line[i] = visitor_.line(true)[i];
    }
    visitor_.leafPair(a, b, leaf_a, leaf_b, transform);
  }

  const TraversalSide& sideA() const { return a_; }
  const TraversalSide& sideB() const { return b_; }

 private:
  static constexpr unsigned kAllLanes = 0xFFu;
  /// For leaves this many times larger than the other box (in squares, twice in length) the triangles are checked.
  /// Half: checks that seldom help; twice: large triangles keep far boxes alive.
  static constexpr float kMuchLarger = 4.0f;

  bool isCoveredByLeaf(const TraversalBox& leaf, const TraversalSide& side, TraversalBox& box,
                       const TraversalSide& box_side) {
    if (!leaf.isLeaf() || leaf.size <= kMuchLarger * box.size) return false;
    box_side.see(box);
    float limit = visitor_.limitSquared();
    if constexpr (requires { visitor_.reachSquared(); }) limit = visitor_.reachSquared();
    return isBeyondTriangles(side.tree.leaf(leaf.child), box, limit);
  }

  void openOne(const TraversalSide& side, TraversalBox& opened, const TraversalSide& other_side, TraversalBox& other,
               unsigned lanes, bool opened_a) {
    const BoxNode& node = side.tree.node(opened.child);
    alignas(32) float bounds[kTreeWidth];
    lanes &= (1u << node.count) - 1u;
    int order[kTreeWidth];
    int near = 0, met = 0;
    for (unsigned left = lanes & nearLanes(node, other_side, other, opened_a, bounds); left != 0; left &= left - 1) {
      const int lane = std::countr_zero(left);
      met += bounds[lane] == 0.0f ? 1 : 0;
      int at = near++;
      for (; at > 0 && bounds[order[at - 1]] > bounds[lane]; --at) order[at] = order[at - 1];
      order[at] = lane;
    }
    if (met > 1) deepestFirst(node, other, order, met);
    prefetch(side.tree, node, order, near);
    unsigned left_out = lanes;
    for (int i = 0; i < near && !visitor_.isDone() && bounds[order[i]] < visitor_.limitSquared(); ++i) {
      left_out &= ~(1u << order[i]);
      TraversalBox child = side.box(opened.child * kTreeWidth + static_cast<std::uint32_t>(order[i]));
      if (opened_a) {
        visit(child, other);
      } else {
        visit(other, child);
      }
    }
    if constexpr (requires { visitor_.culled(opened, other, opened_a, lanes, 0.0f); }) {
      if (left_out == 0) return;
      float least = std::numeric_limits<float>::infinity();
      for (int lane = 0; lane < kTreeWidth; ++lane) {
        if ((left_out >> lane & 1u) != 0 && bounds[lane] < least) least = bounds[lane];
      }
      visitor_.culled(opened_a ? opened : other, opened_a ? other : opened, opened_a, left_out, least);
    }
  }

  /// The children nearer to the box than the limit.
  unsigned nearLanes(const BoxNode& node, const TraversalSide& other_side, TraversalBox& other, bool opened_a,
                     float* bounds) {
    other_side.see(other);
    placeAt(other, node.origin);
    const ProximityKernels& kernels = proximityKernels();
    if constexpr (requires { visitor_.sweepOf(opened_a, node, other); }) {
      return kernels.sweptBoxBounds(node, other.seen, visitor_.sweepOf(opened_a, node, other), bounds);
    } else {
      const float limit = visitor_.limitSquared();
      if constexpr (requires { visitor_.line(opened_a); }) {
        for (int i = 0; i < 3; ++i) other.seen.line[i] = visitor_.line(opened_a)[i];
      }
      return kernels.boxBounds(node, other.seen, limit, bounds);
    }
  }

  /// What is visited first is on its way from memory while the boxes are placed.
  static void prefetch(const BoxTree& tree, const BoxNode& node, const int* order, int near) {
    // Half: the second waits for memory; twice: most of it is never visited.
    constexpr int kVisitedSoon = 2;
    for (int i = 0; i < near && i < kVisitedSoon; ++i) {
      const std::uint32_t child = node.child[order[i]];
      const bool is_leaf = BoxTree::isLeaf(child);
      const char* begin =
          is_leaf ? reinterpret_cast<const char*>(&tree.leaf(child)) : reinterpret_cast<const char*>(&tree.node(child));
      const std::size_t size = is_leaf ? sizeof(LeafBlock) : sizeof(BoxNode);
      constexpr std::size_t kCacheLine = 64;
      for (std::size_t at = 0; at < size; at += kCacheLine) __builtin_prefetch(begin + at);
    }
  }

  /// Sorts children that the box overlaps: where the middles are near against the child's size, contact is found
  /// soonest.
  static void deepestFirst(const BoxNode& node, const TraversalBox& box, int* order, int count) {
    float center[3], rank[kTreeWidth];
    for (int i = 0; i < 3; ++i) center[i] = static_cast<float>(box.seen_center[i] - double{node.origin[i]});
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      float apart = 0.0f, size = 1e-30f;
      for (int i = 0; i < 3; ++i) {
        const float along = node.center[i][lane] - center[i];
        apart += along * along;
        size += node.half[i][lane] * node.half[i][lane];
      }
      rank[lane] = apart / size;
    }
    for (int i = 1; i < count; ++i) {
      const int lane = order[i];
      int at = i;
      for (; at > 0 && rank[order[at - 1]] > rank[lane]; --at) order[at] = order[at - 1];
      order[at] = lane;
    }
  }

  TraversalSide a_;
  TraversalSide b_;
  Visitor& visitor_;
};

}  // namespace hapticell::collision
