// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/pieces_on_demand.h"

#include <algorithm>
#include <unordered_map>

#include "collision/queries/mesh_search.h"
#include "collision/pieces/patch_merger.h"

namespace hapticell::collision {
namespace {

constexpr std::uint32_t kLeavesInBlock = PiecesOnDemand::kMostInBlock / kLeafSize;
/// Triangles about a block of 64; where there are more its triangles stay single. A block then takes some ms. Half:
/// fine scans get more pieces; twice: some blocks take twice as long.
constexpr std::size_t kMostAround = 4000;

/// Some triangles of a mesh as a mesh of its own, sharing vertices as before.
geometry::TriangleMesh partOf(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  geometry::TriangleMesh part;
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  for (const auto t : triangles) {
    geometry::Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] =
          place.try_emplace(mesh.triangles[t][k], static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) part.vertices.push_back(mesh.vertices[mesh.triangles[t][k]]);
      corners[k] = found->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

}  // namespace

PiecesOnDemand::PiecesOnDemand(std::shared_ptr<const MeshCollider> collider, double tolerance)
    : collider_(std::move(collider)), tolerance_(tolerance), block_of_(collider_->mesh().triangles.size(), 0) {
  const auto& leaves = collider_->tree().leaves();
  for (std::uint32_t leaf = 0; leaf < leaves.size(); ++leaf) {
    if (leaf % kLeavesInBlock == 0) {
      blocks_.push_back(std::make_unique<Block>());
      blocks_.back()->first_leaf = leaf;
    }
    blocks_.back()->end_leaf = leaf + 1;
    for (std::uint32_t i = 0; i < leaves[leaf].count; ++i) block_of_[leaves[leaf].triangle[i]] = blockCount() - 1;
  }
}

const std::vector<ConvexPiece>& PiecesOnDemand::block(std::uint32_t index) const {
  Block& block = *blocks_[index];
  std::call_once(block.once, [&] { cut(block); });
  return block.pieces;
}

void PiecesOnDemand::cut(Block& block) const {
  std::vector<std::uint32_t> triangles;
  geometry::Bounds box;
  for (std::uint32_t leaf = block.first_leaf; leaf < block.end_leaf; ++leaf) {
    const LeafBlock& held = collider_->tree().leaves()[leaf];
    for (std::uint32_t i = 0; i < held.count; ++i) {
      triangles.push_back(held.triangle[i]);
      for (int k = 0; k < 3; ++k) box.add(collider_->mesh().corner(held.triangle[i], k));
    }
  }
  const std::size_t own = triangles.size();
  std::vector<std::uint32_t> around;
  trianglesWithin(*collider_, box, tolerance_, around);
  std::sort(around.begin(), around.end());
  const std::uint32_t index = block_of_[triangles.front()];
  const bool merges = around.size() <= kMostAround;
  for (const auto t : around) {
    if (merges && block_of_[t] != index) triangles.push_back(t);
  }
  const SurfaceGraph graph(partOf(collider_->mesh(), triangles), tolerance_);
  std::vector<std::uint32_t> mine;
  for (std::uint32_t t = 0; t < graph.mesh().triangles.size() && graph.originalTriangle(t) < own; ++t)
    mine.push_back(t);
  if (mine.empty()) return;
  const auto add = [&](const Patch& patch) {
    auto piece = pieceOfPatch(graph, patch);
    if (!piece) return false;
    for (auto& triangle : piece->triangles) triangle = triangles[triangle];
    block.pieces.push_back(std::move(*piece));
    return true;
  };
  std::vector<Patch> patches;
  if (merges) {
    const Patch whole = graph.patchOf(mine);
    patches = mergedPatches(graph, {&whole, 1}, *MeshCollider::build(graph.mesh()));
  }
  for (const Patch& patch : patches) {
    if (add(patch)) continue;
    for (const auto triangle : patch.triangles) add(graph.patchOf({triangle}));
  }
  if (merges) return;
  for (const auto triangle : mine) add(graph.patchOf({triangle}));
}

std::size_t PiecesOnDemand::memory() const {
  return block_of_.capacity() * sizeof(std::uint32_t) + blocks_.size() * (sizeof(Block) + sizeof(void*));
}

}  // namespace hapticell::collision
