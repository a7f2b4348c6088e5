// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "collision/queries/mesh_search.h"
#include "collision/pieces/pieces_on_demand.h"
#include "collision/pieces/separating_directions.h"
#include "collision/contacts/zone_contacts.h"

namespace hapticell::collision {

inline geometry::Bounds grown(geometry::Bounds bounds, double by) {
  bounds.min -= dvec3(by);
  bounds.max += dvec3(by);
  return bounds;
}

inline bool overlap(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// Pieces of one part placed in the world; each is placed at its first use.
class PlacedPart {
 public:
  explicit PlacedPart(const ZonePart& part)
      : part_(part), bounds_W_(geometry::transformed(part.X_W, part.pieces->bounds())) {}

  const ZonePart& part() const { return part_; }
  const geometry::Bounds& bounds() const { return bounds_W_; }

  const PlacedPiece& piece(std::uint32_t index) {
    const auto found = placed_.find(index);
    if (found != placed_.end()) return found->second;
    return placed_.emplace(index, placed(*shape(index), part_.X_W)).first->second;
  }

  /// Pieces whose box is near a box in the world.
  std::vector<std::uint32_t> near(const geometry::Bounds& box_W) {
    std::vector<std::uint32_t> found;
    const geometry::Bounds box_M = geometry::transformed(part_.X_W.inverse(), box_W);
    const auto& pieces = part_.pieces->pieces();
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (overlap(pieces[i].bounds, box_M) && overlap(piece(i).bounds_W, box_W)) found.push_back(i);
    }
    return found;
  }

  /// The part's pieces are cut on demand.
  bool isOnDemand() const { return part_.pieces->blocks() != nullptr; }
  /// Appends the pieces of a label of labelled().
  void appendPieces(std::uint32_t label, std::vector<std::uint32_t>& pieces) const {
    if (!isOnDemand()) return pieces.push_back(label);
    const auto count = static_cast<std::uint32_t>(part_.pieces->blocks()->block(label).size());
    for (std::uint32_t i = 0; i < count; ++i) pieces.push_back(label * PiecesOnDemand::kMostInBlock + i);
  }

  bool isLarge() const { return isOnDemand() || part_.pieces->pieces().size() > kFewPieces; }
  /// The triangles, labelled by piece or, if cut on demand, by block.
  LabelledMesh labelled() const {
    if (const PiecesOnDemand* blocks = part_.pieces->blocks()) {
      return {blocks->surface(), blocks->blockOfEachTriangle(), blocks->blockCount()};
    }
    return {*part_.pieces->surface(), part_.pieces->pieceOfEachTriangle(),
            static_cast<std::uint32_t>(part_.pieces->pieces().size())};
  }

 private:
  // Pieces; if there are more, the triangles are searched instead, through a tree. Half and twice change only time:
  // testing so many boxes takes some us.
  static constexpr std::size_t kFewPieces = 256;

  const ConvexPiece* shape(std::uint32_t index) const {
    if (!isOnDemand()) return &part_.pieces->pieces()[index];
    constexpr std::uint32_t kIn = PiecesOnDemand::kMostInBlock;
    return &part_.pieces->blocks()->block(index / kIn)[index % kIn];
  }

  ZonePart part_;
  geometry::Bounds bounds_W_;
  std::unordered_map<std::uint32_t, PlacedPiece> placed_;
};

}  // namespace hapticell::collision
