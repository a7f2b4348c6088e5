// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/trees/box_tree.h"

namespace hapticell::collision {

/// The data of a BoxTree.
struct TreeParts {
  AlignedVector<BoxNode> nodes;
  AlignedVector<LeafBlock> leaves;
};

/// Builds the tree of these triangles (at least one; finite corners). The result does not depend on the number of
/// threads; empty when cancelled.
TreeParts buildTree(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
                    const BuildControl& control);

}  // namespace hapticell::collision
