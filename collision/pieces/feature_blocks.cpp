// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/feature_blocks.h"

#include <algorithm>
#include <numeric>

namespace hapticell::collision {
namespace {

// Features of a block with one box, neighbours on the curve. Half: twice the boxes to test; twice: twice the features
// of a box that is touched.
constexpr std::uint32_t kBlock = 16;

std::uint32_t spread(double fraction) {
  // A plane without an edge has no place: no number.
  auto bits = fraction > 0.0 ? static_cast<std::uint32_t>(std::min(fraction, 1.0) * 1023.0) : 0u;
  bits = (bits | (bits << 16)) & 0x030000FFu;
  bits = (bits | (bits << 8)) & 0x0300F00Fu;
  bits = (bits | (bits << 4)) & 0x030C30C3u;
  return (bits | (bits << 2)) & 0x09249249u;
}

std::vector<std::uint32_t> curveOrder(const std::vector<geometry::Bounds>& boxes, const geometry::Bounds& whole) {
  std::vector<std::uint32_t> code;
  const dvec3 size = glm::max(whole.size(), dvec3(1e-12));
  for (const geometry::Bounds& box : boxes) {
    const dvec3 at = (box.center() - whole.min) / size;
    code.push_back(spread(at.x) | (spread(at.y) << 1) | (spread(at.z) << 2));
  }
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return code[a] < code[b]; });
  return order;
}

std::vector<FeatureBlock> blocksOf(const std::vector<geometry::Bounds>& boxes,
                                   const std::vector<std::uint32_t>& order) {
  std::vector<FeatureBlock> blocks;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    if (i % kBlock == 0) blocks.push_back({{}, i, i});
    blocks.back().bounds.add(boxes[order[i]]);
    blocks.back().end = i + 1;
  }
  return blocks;
}

}  // namespace

void sortIntoBlocks(ConvexPiece& piece) {
  ConvexHull& hull = piece.hull;
  std::vector<geometry::Bounds> plane_boxes(hull.planes.size());
  std::vector<geometry::Bounds> edge_boxes(hull.edges.size());
  for (std::size_t i = 0; i < hull.edges.size(); ++i) {
    for (const auto vertex : hull.edges[i].vertices) edge_boxes[i].add(hull.vertices[vertex]);
    for (const auto plane : hull.edges[i].planes) plane_boxes[plane].add(edge_boxes[i]);
  }
  const auto plane_order = curveOrder(plane_boxes, piece.bounds);
  const auto edge_order = curveOrder(edge_boxes, piece.bounds);
  piece.plane_blocks = blocksOf(plane_boxes, plane_order);
  piece.edge_blocks = blocksOf(edge_boxes, edge_order);
  const ConvexPiece old = piece;
  std::vector<std::uint32_t> new_plane(plane_order.size());
  for (std::uint32_t i = 0; i < plane_order.size(); ++i) {
    hull.planes[i] = old.hull.planes[plane_order[i]];
    piece.real_plane[i] = old.real_plane[plane_order[i]];
    new_plane[plane_order[i]] = i;
  }
  for (std::uint32_t i = 0; i < edge_order.size(); ++i) {
    hull.edges[i] = old.hull.edges[edge_order[i]];
    for (auto& plane : hull.edges[i].planes) plane = new_plane[plane];
  }
}

}  // namespace hapticell::collision
