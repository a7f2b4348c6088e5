// SPDX-License-Identifier: Apache-2.0
#include "collision/box_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hapticell::collision {

namespace {

constexpr std::uint32_t kLeafSize = 2;
constexpr int kBins = 12;
/// Beyond this depth nodes are halved by count, whatever the heuristic says: recursion stays shallow.
constexpr int kDepthOfHalving = 48;
constexpr std::uint32_t kFitByTriangleBelow = 512;

dvec3 centroid(const Corners& c) {
  return (c[0] + c[1] + c[2]) / 3.0;
}
double area(const Corners& c) {
  return 0.5 * glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
}

double halfSurface(const dvec3& half) {
  return half.x * half.y + half.y * half.z + half.z * half.x;
}

/// The box along given axes that holds all corners, a little padded against rounding.
OrientedBox boxAlong(const dmat3& R, const Corners* corners, std::uint32_t count) {
  const dmat3 into = glm::transpose(R);
  dvec3 low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const dvec3& corner : corners[i]) {
      const dvec3 p = into * corner;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  OrientedBox box{R, R * (0.5 * (low + high)), 0.5 * (high - low)};
  const dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
  box.half += dvec3(1e-14 * (reach.x + reach.y + reach.z));
  return box;
}

/// Axes of the area-weighted covariance of the surface (exact for triangles, not only their corners).
dmat3 covarianceAxes(const Corners* corners, std::uint32_t count) {
  double whole = 0.0;
  dvec3 mean(0.0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double weight = area(corners[i]);
    whole += weight;
    mean += weight * centroid(corners[i]);
  }
  if (!(whole > 0.0)) return dmat3(1.0);
  mean /= whole;
  dmat3 covariance(0.0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const dvec3 m = centroid(corners[i]) - mean;
    dmat3 sum = 9.0 * glm::outerProduct(m, m);
    for (const dvec3& corner : corners[i]) sum += glm::outerProduct(corner - mean, corner - mean);
    covariance += (area(corners[i]) / (12.0 * whole)) * sum;
  }
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) matrix(i, j) = covariance[j][i];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const Eigen::Matrix3d axes = solver.eigenvectors();
  const dvec3 x = glm::normalize(dvec3(axes(0, 0), axes(1, 0), axes(2, 0)));
  dvec3 y(axes(0, 1), axes(1, 1), axes(2, 1));
  y = glm::normalize(y - x * glm::dot(x, y));
  return {x, y, glm::cross(x, y)};
}

/// Axes of the largest triangle: its longest edge and its normal.
dmat3 largestTriangleAxes(const Corners* corners, std::uint32_t count) {
  const Corners* largest =
      std::max_element(corners, corners + count, [](const Corners& a, const Corners& b) { return area(a) < area(b); });
  dvec3 longest(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 side = (*largest)[(i + 1) % 3] - (*largest)[i];
    if (glm::dot(side, side) > glm::dot(longest, longest)) longest = side;
  }
  const dvec3 normal = glm::cross((*largest)[1] - (*largest)[0], (*largest)[2] - (*largest)[0]);
  if (!(glm::length(normal) > 0.0) || !(glm::length(longest) > 0.0)) return dmat3(1.0);
  const dvec3 x = glm::normalize(longest), across = glm::cross(glm::normalize(normal), x);
  // The normal of a needle is rounding: axes that are not square would leave its corners outside the box.
  if (!(glm::length(across) > 0.9)) return dmat3(1.0);
  const dvec3 y = glm::normalize(across - x * glm::dot(x, across));
  return {x, y, glm::cross(x, y)};
}

bool isFinite(const dmat3& R) {
  const dvec3 sum = R[0] + R[1] + R[2];
  return std::isfinite(sum.x + sum.y + sum.z);
}

OrientedBox fit(const Corners* corners, std::uint32_t count) {
  OrientedBox best = boxAlong(dmat3(1.0), corners, count);
  // Turned axes must earn their keep: an aligned box is as good when it is within 2 % of them.
  double least = 0.98 * halfSurface(best.half);
  const auto tryAxes = [&](const dmat3& R) {
    if (!isFinite(R)) return;
    const OrientedBox box = boxAlong(R, corners, count);
    if (halfSurface(box.half) < least) {
      least = halfSurface(box.half);
      best = box;
    }
  };
  tryAxes(covarianceAxes(corners, count));
  if (count <= kFitByTriangleBelow) tryAxes(largestTriangleAxes(corners, count));
  return best;
}

struct Span {
  dvec3 low{std::numeric_limits<double>::infinity()};
  dvec3 high{-std::numeric_limits<double>::infinity()};
  std::uint32_t count = 0;
  void add(const Span& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
    count += other.count;
  }
  double cost() const { return count == 0 ? 0.0 : halfSurface(high - low) * count; }
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;
  int bin = 0;  ///< The first bin of the right side.
};

}  // namespace

/// Sorts triangles into leaves while it makes the nodes.
class BoxTreeBuilder {
 public:
  BoxTreeBuilder(const geometry::TriangleMesh& mesh, std::vector<BoxTree::Node>& nodes) : nodes_(nodes) {
    corners.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      corners.push_back({mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2)});
    }
    order.resize(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    scratch_corners_.resize(corners.size());
    scratch_order_.resize(corners.size());
    nodes_.reserve(corners.size() + 1);
    nodes_.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(corners.size()), 0);
  }

  std::vector<Corners> corners;
  std::vector<std::uint32_t> order;

 private:
  void build(std::uint32_t index, std::uint32_t first, std::uint32_t count, int depth) {
    const OrientedBox box = fit(&corners[first], count);
    nodes_[index].box = box;
    nodes_[index].size = glm::length(box.half);
    if (count <= kLeafSize) {
      nodes_[index].first = first;
      nodes_[index].count = count;
      return;
    }
    const std::uint32_t left = divide(box, first, count, depth);
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index].first = child;
    nodes_.emplace_back();
    nodes_.emplace_back();
    build(child, first, left, depth + 1);
    build(child + 1, first + left, count - left, depth + 1);
  }

  static int binOf(double where, double half) {
    return std::clamp(static_cast<int>(kBins * (0.5 + 0.5 * where / half)), 0, kBins - 1);
  }

  /// Reorders the triangles so that those of the left child come first; returns how many they are, never none or all.
  std::uint32_t divide(const OrientedBox& box, std::uint32_t first, std::uint32_t count, int depth) {
    const dmat3 into = glm::transpose(box.R);
    const Split split = depth < kDepthOfHalving ? bestSplit(box, into, first, count) : Split{};
    if (split.axis < 0) return halve(box, first, count);
    const double half = box.half[split.axis];
    std::uint32_t left = first, right = 0;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const dvec3 p = into * (centroid(corners[i]) - box.center);
      if (binOf(p[split.axis], half) < split.bin) {
        corners[left] = corners[i];
        order[left++] = order[i];
      } else {
        scratch_corners_[right] = corners[i];
        scratch_order_[right++] = order[i];
      }
    }
    std::copy_n(scratch_corners_.begin(), right, corners.begin() + left);
    std::copy_n(scratch_order_.begin(), right, order.begin() + left);
    return left - first;
  }

  Split bestSplit(const OrientedBox& box, const dmat3& into, std::uint32_t first, std::uint32_t count) const {
    std::array<std::array<Span, kBins>, 3> bins;
    for (std::uint32_t i = first; i < first + count; ++i) {
      Span span;
      span.count = 1;
      for (const dvec3& corner : corners[i]) {
        const dvec3 p = into * (corner - box.center);
        span.low = glm::min(span.low, p);
        span.high = glm::max(span.high, p);
      }
      const dvec3 middle = into * (centroid(corners[i]) - box.center);
      for (int axis = 0; axis < 3; ++axis) {
        if (box.half[axis] > 0.0)
          bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(binOf(middle[axis], box.half[axis]))].add(span);
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) sweep(bins[static_cast<std::size_t>(axis)], axis, best);
    return best;
  }

  static void sweep(const std::array<Span, kBins>& bins, int axis, Split& best) {
    std::array<Span, kBins + 1> above{};
    for (int bin = kBins - 1; bin > 0; --bin) {
      const auto i = static_cast<std::size_t>(bin);
      above[i] = above[i + 1];
      above[i].add(bins[i]);
    }
    Span below;
    for (int bin = 1; bin < kBins; ++bin) {
      const auto i = static_cast<std::size_t>(bin);
      below.add(bins[i - 1]);
      if (below.count == 0 || above[i].count == 0) continue;
      const double cost = below.cost() + above[i].cost();
      if (cost < best.cost) best = {cost, axis, bin};
    }
  }

  /// Half of the triangles on each side, by their place along the box's longest axis.
  std::uint32_t halve(const OrientedBox& box, std::uint32_t first, std::uint32_t count) {
    int axis = box.half.x >= box.half.y ? 0 : 1;
    if (box.half.z > box.half[axis]) axis = 2;
    std::vector<std::pair<double, std::uint32_t>> keyed(count);
    for (std::uint32_t i = 0; i < count; ++i)
      keyed[i] = {glm::dot(box.R[axis], centroid(corners[first + i])), first + i};
    std::nth_element(keyed.begin(), keyed.begin() + count / 2, keyed.end());
    for (std::uint32_t i = 0; i < count; ++i) {
      scratch_corners_[i] = corners[keyed[i].second];
      scratch_order_[i] = order[keyed[i].second];
    }
    std::copy_n(scratch_corners_.begin(), count, corners.begin() + first);
    std::copy_n(scratch_order_.begin(), count, order.begin() + first);
    return count / 2;
  }

  std::vector<BoxTree::Node>& nodes_;
  std::vector<Corners> scratch_corners_;
  std::vector<std::uint32_t> scratch_order_;
};

OrientedBox moved(const dmat3& R_AF, const dvec3& p_AF, const OrientedBox& box_F) {
  return {R_AF * box_F.R, p_AF + R_AF * box_F.center, box_F.half};
}

double lowerBoundSquared(const OrientedBox& a, const OrientedBox& b) {
  const dvec3 apart = b.center - a.center;
  double squared_a = 0.0;
  dvec3 reach(0.0);
  for (int i = 0; i < 3; ++i) {
    const dvec3 row(std::abs(glm::dot(a.R[i], b.R[0])), std::abs(glm::dot(a.R[i], b.R[1])),
                    std::abs(glm::dot(a.R[i], b.R[2])));
    reach += a.half[i] * row;
    const double gap = std::abs(glm::dot(a.R[i], apart)) - a.half[i] - glm::dot(row, b.half);
    if (gap > 0.0) squared_a += gap * gap;
  }
  double squared_b = 0.0;
  for (int j = 0; j < 3; ++j) {
    const double gap = std::abs(glm::dot(b.R[j], apart)) - b.half[j] - reach[j];
    if (gap > 0.0) squared_b += gap * gap;
  }
  return std::max(squared_a, squared_b);
}

double lowerBoundSquared(const OrientedBox& box, const dvec3& point) {
  const dvec3 apart = point - box.center;
  double squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double gap = std::abs(glm::dot(box.R[i], apart)) - box.half[i];
    if (gap > 0.0) squared += gap * gap;
  }
  return squared;
}

double lowerBoundSquared(const OrientedBox& box, const Corners& triangle) {
  const dvec3 apart = box.center - closestPointOnTriangle(triangle, box.center);
  double gap = std::numeric_limits<double>::infinity();
  for (const dvec3& corner : triangle) gap = std::min(gap, glm::dot(apart, box.center - corner));
  for (int i = 0; i < 3; ++i) gap -= box.half[i] * std::abs(glm::dot(box.R[i], apart));
  return gap > 0.0 ? gap * gap / glm::dot(apart, apart) : 0.0;
}

BoxTree::BoxTree(const geometry::TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return;
  BoxTreeBuilder builder(mesh, nodes_);
  corners_ = std::move(builder.corners);
  triangle_of_slot_ = std::move(builder.order);
  slot_of_triangle_.resize(triangle_of_slot_.size());
  for (std::uint32_t slot = 0; slot < triangle_of_slot_.size(); ++slot)
    slot_of_triangle_[triangle_of_slot_[slot]] = slot;
}

}  // namespace hapticell::collision
