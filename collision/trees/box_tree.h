// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "collision/trees/oriented_box.h"
#include "collision/trees/proximity_kernels.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Storage that starts at a cache line, for data that vector instructions load.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <typename U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, std::align_val_t(64)); }
  template <typename U>
  bool operator==(const CacheLineAllocator<U>&) const {
    return true;
  }
};
template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// Threads, progress and cancelling of a build.
struct BuildControl {
  unsigned threads = 1;                          ///< The tree does not depend on the number.
  std::atomic<std::size_t>* done = nullptr;      ///< Counts triangles that are in their leaf.
  const std::atomic<bool>* cancelled = nullptr;  ///< Any thread may set it to end the build early.
};

/// An eight-wide tree of oriented boxes over a mesh's triangles, in the mesh's frame M. Immutable after build.
///
/// Boxes are fitted to the area-weighted covariance of their triangles, to the largest triangle with its longest edge,
/// or to the axes of the parent box, whichever has the least surface (Gottschalk et al., "OBBTree", 1996); nodes are
/// split by a binned surface-area heuristic that counts leaves (Wald 2007; Shellshear & Ytterlid 2014). About 85 bytes
/// per triangle.
class BoxTree {
 public:
  static constexpr std::uint32_t kLeafBit = 0x80000000u;
  /// A place in the tree: eight times the index of a node, plus the lane. The whole tree is kRoot.
  using Slot = std::uint32_t;
  static constexpr Slot kRoot = 0;

  BoxTree() = default;
  /// Builds the tree of the listed triangles of `mesh` (all with finite corners). If the build is cancelled, the tree
  /// is empty.
  BoxTree(const geometry::TriangleMesh& mesh, std::vector<std::uint32_t> triangles, const BuildControl& control = {});
  /// Restores a stored tree from its nodes() and leaves().
  BoxTree(AlignedVector<BoxNode> nodes, AlignedVector<LeafBlock> leaves);

  bool isEmpty() const { return leaves_.empty(); }
  const AlignedVector<BoxNode>& nodes() const { return nodes_; }
  const AlignedVector<LeafBlock>& leaves() const { return leaves_; }

  static bool isLeaf(std::uint32_t child) { return (child & kLeafBit) != 0; }
  std::uint32_t child(Slot slot) const { return nodes_[slot / kTreeWidth].child[slot % kTreeWidth]; }
  const BoxNode& node(std::uint32_t child) const { return nodes_[child]; }
  const LeafBlock& leaf(std::uint32_t child) const { return leaves_[child & ~kLeafBit]; }
  /// Everything below the slot lies in this box, up to rounding in float (1e-6 of its size).
  OrientedBox box(Slot slot) const;

  /// Bytes held.
  std::size_t memory() const { return nodes_.capacity() * sizeof(BoxNode) + leaves_.capacity() * sizeof(LeafBlock); }

 private:
  AlignedVector<BoxNode> nodes_;
  AlignedVector<LeafBlock> leaves_;
};

}  // namespace hapticell::collision
