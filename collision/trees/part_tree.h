// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/trees/proximity_kernels.h"
#include "geometry/shapes/bounds.h"

namespace hapticell::collision {

/// A tree of the parts' axis-aligned boxes that is updated while parts are added, removed and moved. The cost of a
/// query depends on the number of parts near the box, not on the number of all parts.
///
/// A tree of 16 children a node, after Guttman, "R-trees: a dynamic index structure for spatial searching" (1984), with
/// the splits of Beckmann et al., "The R*-tree" (1990). Parts are the caller's numbers, from 0 on. Boxes are kept a
/// little larger than given, so that small moves change nothing. One thread. Queries do not allocate.
class PartTree {
 public:
  /// Adds the part with its box (world, metres, not empty, finite), or updates its box.
  void place(std::uint32_t part, const geometry::Bounds& box_W);
  /// Removes the part; does nothing if it is not in the tree.
  void remove(std::uint32_t part);
  bool contains(std::uint32_t part) const { return part < where_.size() && where_[part].node != kNone; }
  std::size_t size() const { return size_; }
  /// Around everything in the tree; empty without parts.
  geometry::Bounds bounds() const;

  /// Calls visit(part) for each part whose box comes within `margin` (m) of the box on every axis; each once, in no
  /// order. All others are farther away than `margin`.
  template <typename Visit>
  void visitNear(const geometry::Bounds& box_W, double margin, const Visit& visit) const {
    if (size_ == 0) return;
    const QueryBounds query = queryBounds(box_W, margin);
    std::uint32_t open[kMostOpen];
    int count = 0;
    open[count++] = root_;
    while (count > 0) {
      const Node& node = nodes_[open[--count]];
      for (std::uint32_t lanes = kernels_->nearBoxes(node.boxes, query); lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t child = node.child[std::countr_zero(lanes)];
        if (node.level == 0)
          visit(child);
        else
          open[count++] = child;
      }
    }
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;
  static constexpr int kWidth = kPartLanes;
  /// Children of a node after a split: at least. Half: longer boxes; twice is impossible.
  static constexpr int kLeastSplit = 6;
  /// A leaf with fewer parts is dissolved and its parts are inserted again. Half: leaves with a part or two; twice: at
  /// every other removal.
  static constexpr int kLeastLeaf = 3;
  /// Nodes that wait in a query: 15 a level, and 17 levels of 6 hold more than there are numbers.
  static constexpr int kMostOpen = 256;

  struct Node {
    PartBoxes boxes;
    std::uint32_t child[kPartLanes];  ///< Parts of a leaf (level 0), else nodes.
    std::uint32_t parent = kNone;
    std::uint32_t lane = 0;  ///< Of the parent.
    int count = 0;
    int level = 0;
  };
  struct Place {
    std::uint32_t node = kNone;
    std::uint32_t lane = 0;
  };
  /// A child that is being inserted: its box and number.
  struct Entry {
    float min[3], max[3];
    std::uint32_t child;
  };

  static QueryBounds queryBounds(const geometry::Bounds& box_W, double margin);
  static Entry entryOf(const Node& node, int lane);
  static Entry around(const Node& node, std::uint32_t index);
  std::uint32_t newNode(int level);
  void setLane(std::uint32_t node, int lane, const Entry& entry);
  void clearLane(std::uint32_t node, int lane);
  void insert(const Entry& entry, int level);
  void add(std::uint32_t node, const Entry& entry);
  std::uint32_t chooseNode(const Entry& entry, int level) const;
  void split(std::uint32_t node, const Entry& extra);
  void growAbove(std::uint32_t node, const Entry& entry);
  void shrinkAbove(std::uint32_t node);
  void take(Place place);
  void drop(std::uint32_t node);

  const ProximityKernels* kernels_ = &proximityKernels();
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> unused_;
  std::vector<Place> where_;  ///< Of each part.
  std::uint32_t root_ = kNone;
  std::size_t size_ = 0;
};

}  // namespace hapticell::collision
