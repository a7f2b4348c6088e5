// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "collision/pieces/convex_pieces.h"

namespace hapticell::collision {

/// A large mesh's surface, cut into convex pieces on demand: in blocks of at most kMostInBlock neighbouring triangles
/// (16 consecutive leaves of the collider's tree). No piece crosses the border of its block, but each is checked
/// against all surface around it, so the pieces are as accurate as those of a mesh cut as a whole. A block costs a few
/// milliseconds, once. The pieces of a block do not depend on the order of the calls. Any thread.
class PiecesOnDemand {
 public:
  /// Triangles of a block, 16 leaves: some ms to cut (Performance). Half: more borders, which no piece crosses; twice:
  /// 10 ms for the first touch of a block.
  static constexpr std::uint32_t kMostInBlock = 64;

  /// `tolerance` (m) as for ConvexPieces::build.
  PiecesOnDemand(std::shared_ptr<const MeshCollider> collider, double tolerance);

  const MeshCollider& surface() const { return *collider_; }
  std::uint32_t blockCount() const { return static_cast<std::uint32_t>(blocks_.size()); }
  const std::vector<std::uint32_t>& blockOfEachTriangle() const { return block_of_; }

  /// The pieces of a block (index below blockCount()), cut at the first call; at most kMostInBlock. Their `triangles`
  /// are those of the collider's mesh.
  const std::vector<ConvexPiece>& block(std::uint32_t index) const;

  /// Bytes held, the collider not counted.
  std::size_t memory() const;

 private:
  struct Block {
    std::uint32_t first_leaf = 0, end_leaf = 0;
    std::once_flag once;
    std::vector<ConvexPiece> pieces;
  };
  void cut(Block& block) const;

  std::shared_ptr<const MeshCollider> collider_;
  double tolerance_;
  std::vector<std::uint32_t> block_of_;
  std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace hapticell::collision
