// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/dual_traversal.h"

namespace hapticell::collision {

TraversalSide::TraversalSide(const BoxTree& of, const dmat3& rotation, const dvec3& position)
    : tree(of), R(rotation), p(position) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) R_rows[3 * i + k] = static_cast<float>(R[k][i]);
  }
}

TraversalBox TraversalSide::box(BoxTree::Slot slot) const {
  const BoxNode& node = tree.node(slot / kTreeWidth);
  const std::uint32_t lane = slot % kTreeWidth;
  TraversalBox box;
  box.slot = slot;
  box.child = node.child[lane];
  for (int i = 0; i < 3; ++i) {
    box.half[i] = node.half[i][lane];
    box.size += box.half[i] * box.half[i];
    box.center[i] = double{node.origin[i]} + double{node.center[i][lane]};
  }
  return box;
}

void TraversalSide::see(TraversalBox& box) const {
  if (box.is_seen) return;
  box.is_seen = true;
  const BoxNode& node = tree.node(box.slot / kTreeWidth);
  const std::uint32_t lane = box.slot % kTreeWidth;
  float axes[3][3];
  for (int i = 0; i < 3; ++i) {
    axes[0][i] = node.u[i][lane];
    axes[1][i] = node.v[i][lane];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    axes[2][i] = axes[0][j] * axes[1][k] - axes[0][k] * axes[1][j];
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float* a = axes[axis];
    for (int i = 0; i < 3; ++i) {
      const float* row = R_rows + 3 * i;
      box.seen.axis[axis][i] = row[0] * a[0] + row[1] * a[1] + row[2] * a[2];
    }
    box.seen.half[axis] = box.half[axis];
  }
  box.seen_center = R * box.center + p;
}

bool isBeyondTriangles(const LeafBlock& leaf, TraversalBox& box, float limit_squared) {
  placeAt(box, leaf.origin);
  return proximityKernels().isLeafBeyond(leaf, box.seen, limit_squared);
}

}  // namespace hapticell::collision
