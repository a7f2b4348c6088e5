// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/surface_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace hapticell::app {
namespace {

// Triangles of a leaf; by trial. Half: more boxes to test; twice: more triangles.
constexpr std::size_t kLeaf = 4;

std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

float squared(const fvec3& v) {
  return glm::dot(v, v);
}

/// Ericson, "Real-Time Collision Detection", 5.1.5.
float squaredToTriangle(const fvec3& p, const fvec3& a, const fvec3& b, const fvec3& c) {
  const fvec3 ab = b - a, ac = c - a, ap = p - a;
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return squared(ap);
  const fvec3 bp = p - b;
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0f && d4 <= d3) return squared(bp);
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f && d1 > d3) return squared(ap - d1 / (d1 - d3) * ab);
  const fvec3 cp = p - c;
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0f && d5 <= d6) return squared(cp);
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f && d2 > d6) return squared(ap - d2 / (d2 - d6) * ac);
  const float va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0.0f && along >= 0.0f && back >= 0.0f && along + back > 0.0f)
    return squared(bp - along / (along + back) * (c - b));
  const float sum = va + vb + vc;
  if (!(sum > 0.0f)) return std::min({squared(ap), squared(bp), squared(cp)});  // No area.
  return squared(ap - vb / sum * ab - vc / sum * ac);
}

}  // namespace

SurfaceTree::SurfaceTree(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> indices)
    : vertices_(vertices) {
  Box all;
  for (const std::uint32_t v : indices) {
    all.low = glm::min(all.low, vertices[v].position);
    all.high = glm::max(all.high, vertices[v].position);
  }
  const fvec3 to_cells = 1023.0f / glm::max(all.high - all.low, fvec3(1e-20f));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(indices.size() / 3);
  for (std::uint32_t t = 0; t < order.size(); ++t) {
    fvec3 middle(0.0f);
    for (std::size_t c = 0; c < 3; ++c) middle += vertices[indices[3 * t + c]].position / 3.0f;
    const fvec3 cell = glm::clamp((middle - all.low) * to_cells, fvec3(0.0f), fvec3(1023.0f));
    order[t] = {spread(static_cast<std::uint32_t>(cell.x)) | spread(static_cast<std::uint32_t>(cell.y)) << 1 |
                    spread(static_cast<std::uint32_t>(cell.z)) << 2,
                t};
  }
  std::sort(order.begin(), order.end());
  indices_.reserve(indices.size());
  for (const auto& [key, t] : order)
    indices_.insert(indices_.end(), {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
  const std::size_t leaves = (order.size() + kLeaf - 1) / kLeaf;
  first_leaf_ = std::bit_ceil(std::max<std::size_t>(leaves, 1));
  boxes_.resize(2 * first_leaf_);
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    Box& box = boxes_[first_leaf_ + i / 3 / kLeaf];
    box.low = glm::min(box.low, vertices[indices_[i]].position);
    box.high = glm::max(box.high, vertices[indices_[i]].position);
  }
  for (std::size_t i = first_leaf_ - 1; i > 0; --i) {
    boxes_[i].low = glm::min(boxes_[2 * i].low, boxes_[2 * i + 1].low);
    boxes_[i].high = glm::max(boxes_[2 * i].high, boxes_[2 * i + 1].high);
  }
}

float SurfaceTree::squaredToLeaf(const fvec3& p, std::size_t leaf) const {
  float best = std::numeric_limits<float>::infinity();
  const std::size_t end = std::min(3 * kLeaf * (leaf + 1), indices_.size());
  for (std::size_t i = 3 * kLeaf * leaf; i < end; i += 3)
    best = std::min(best, squaredToTriangle(p, vertices_[indices_[i]].position, vertices_[indices_[i + 1]].position,
                                            vertices_[indices_[i + 2]].position));
  return best;
}

double SurfaceTree::distance(const fvec3& p, double enough, std::size_t& near) const {
  if (indices_.empty()) return std::numeric_limits<double>::infinity();
  const auto squaredToBox = [&](std::size_t node) {
    return squared(glm::max(glm::max(boxes_[node].low - p, p - boxes_[node].high), fvec3(0.0f)));
  };
  const auto enough2 = static_cast<float>(enough * enough);
  float best = squaredToLeaf(p, near);
  if (best <= enough2) return std::sqrt(static_cast<double>(best));
  std::array<std::pair<float, std::size_t>, 64> open;
  std::size_t count = 0;
  open[count++] = {squaredToBox(1), 1};
  while (count > 0) {
    const auto [nearest, node] = open[--count];
    if (nearest >= best) continue;
    if (node >= first_leaf_) {
      const float here = squaredToLeaf(p, node - first_leaf_);
      if (here < best) best = here, near = node - first_leaf_;
      if (best <= enough2) break;
      continue;
    }
    const float left = squaredToBox(2 * node), right = squaredToBox(2 * node + 1);
    const bool left_first = left <= right;
    open[count++] = left_first ? std::pair{right, 2 * node + 1} : std::pair{left, 2 * node};
    open[count++] = left_first ? std::pair{left, 2 * node} : std::pair{right, 2 * node + 1};
  }
  return std::sqrt(static_cast<double>(best));
}

namespace {

/// Calls `look` with points of the triangle no further than `spacing` from each other, corners and middles of sides at
/// least.
template <typename Look>
void sample(fvec3 a, fvec3 b, fvec3 c, float spacing, const Look& look) {
  // Points along a large triangle, at most: time. Half: bulges over large faces are missed; twice: four times the time.
  constexpr float kMost = 150.0f;
  while (squared(b - a) < std::max(squared(c - b), squared(a - c))) std::swap(a, b), std::swap(b, c);
  const float length = glm::length(b - a);
  const float height = length > 0.0f ? glm::length(glm::cross(b - a, c - a)) / length : 0.0f;
  const auto rows = static_cast<int>(std::clamp(height / spacing, 2.0f, kMost));
  for (int row = 0; row <= rows; ++row) {
    const float up = static_cast<float>(row) / static_cast<float>(rows);
    const fvec3 left = a + up * (c - a), right = b + up * (c - b);
    const auto columns = static_cast<int>(std::clamp((1.0f - up) * length / spacing, row < rows ? 2.0f : 1.0f, kMost));
    for (int column = 0; column <= columns; ++column)
      look(left + static_cast<float>(column) / static_cast<float>(columns) * (right - left));
  }
}

}  // namespace

double deviation(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> from,
                 const SurfaceTree& surface, double least) {
  // Of small triangles, at least. Half: a bump may be missed; twice: twice the time.
  constexpr std::size_t kSampled = 3000;
  // Points along the whole. Half, twice: a bump of a 32nd or 128th may be missed; four times or a quarter of the time.
  constexpr float kGrid = 64.0f;
  fvec3 low(1e30f), high(-1e30f);
  for (const std::uint32_t v : from) {
    low = glm::min(low, vertices[v].position);
    high = glm::max(high, vertices[v].position);
  }
  const fvec3 size = high - low;
  const float spacing = std::max(std::max({size.x, size.y, size.z}) / kGrid, 1e-12f);
  const std::size_t triangles = from.size() / 3;
  const std::size_t stride = std::max<std::size_t>(triangles / kSampled, 1);
  double most = least;
  std::size_t near = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const fvec3 a = vertices[from[3 * t]].position, b = vertices[from[3 * t + 1]].position,
                c = vertices[from[3 * t + 2]].position;
    const float longest2 = std::max({squared(b - a), squared(c - b), squared(a - c)});
    const auto look = [&](const fvec3& p) { most = std::max(most, surface.distance(p, most, near)); };
    if (longest2 > 4.0f * spacing * spacing) {
      sample(a, b, c, spacing, look);
    } else if (t % stride == 0) {
      for (const fvec3& p : {a, b, c, (a + b + c) / 3.0f, 0.5f * (a + b)}) look(p);
    }
  }
  return most;
}

}  // namespace hapticell::app
