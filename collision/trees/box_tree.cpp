// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/box_tree.h"

#include <utility>

#include "collision/trees/box_tree_builder.h"

namespace hapticell::collision {

BoxTree::BoxTree(const geometry::TriangleMesh& mesh, std::vector<std::uint32_t> triangles,
                 const BuildControl& control) {
  if (triangles.empty()) return;
  TreeParts parts = buildTree(mesh, triangles, control);
  nodes_ = std::move(parts.nodes);
  leaves_ = std::move(parts.leaves);
  nodes_.shrink_to_fit();
  leaves_.shrink_to_fit();
}

BoxTree::BoxTree(AlignedVector<BoxNode> nodes, AlignedVector<LeafBlock> leaves)
    : nodes_(std::move(nodes)), leaves_(std::move(leaves)) {}

OrientedBox BoxTree::box(Slot slot) const {
  const BoxNode& node = nodes_[slot / kTreeWidth];
  const std::uint32_t lane = slot % kTreeWidth;
  OrientedBox box;
  for (int i = 0; i < 3; ++i) {
    box.R[0][i] = node.u[i][lane];
    box.R[1][i] = node.v[i][lane];
    box.center[i] = double{node.origin[i]} + double{node.center[i][lane]};
    box.half[i] = node.half[i][lane];
  }
  box.R[2] = glm::cross(box.R[0], box.R[1]);
  return box;
}

}  // namespace hapticell::collision
