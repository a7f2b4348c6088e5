// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/box_fit.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

namespace {

/// Triangles of a node: below it the largest one's axes are tried too, as few triangles have no good covariance. Half:
/// looser small boxes; twice: a slower build.
constexpr std::size_t kFitByTriangleBelow = 512;
/// The covariance is of every n-th triangle where there are more than this many. Half: no worse on even meshes; twice:
/// twice the time of the upper nodes.
constexpr std::size_t kMostForCovariance = 2048;
/// Turned axes must earn their keep: the axes of the box above are as good when they are within 2 % of them. Half of
/// it: more turned boxes, each dearer to test; twice: looser ones.
constexpr float kWorthTurning = 0.98f;

fvec3 cornerOf(const BuildItem& item, int i) {
  return {item.corner[3 * i], item.corner[3 * i + 1], item.corner[3 * i + 2]};
}

fvec3 areaVector(const BuildItem& item) {
  const fvec3 a = cornerOf(item, 0);
  return glm::cross(cornerOf(item, 1) - a, cornerOf(item, 2) - a);
}

/// Square axes from a direction and another one across; false where these are no two directions.
bool squareAxes(const dvec3& along, const dvec3& across, BuildAxes& axes) {
  const double length = glm::length(along);
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  const dvec3 x = along / length;
  const dvec3 rest = across - x * glm::dot(x, across);
  const double breadth = glm::length(rest);
  // The normal of a needle is rounding: axes that are not square would be no box's.
  if (!(breadth > 0.1 * glm::length(across)) || !std::isfinite(breadth)) return false;
  const dvec3 y = rest / breadth, z = glm::cross(x, y);
  const auto row = [&](int i) {
    return Float4{static_cast<float>(x[i]), static_cast<float>(y[i]), static_cast<float>(z[i]), 0.0f};
  };
  axes = {row(0), row(1), row(2)};
  return true;
}

/// Of the surface, triangles not only by their middles.
bool covarianceAxes(const BuildItem* items, std::size_t count, BuildAxes& axes) {
  const std::size_t stride = count / kMostForCovariance + 1;
  double whole = 0.0;
  dvec3 mean(0.0), squares(0.0), products(0.0);
  for (std::size_t i = 0; i < count; i += stride) {
    const dvec3 a = cornerOf(items[i], 0), b = cornerOf(items[i], 1), c = cornerOf(items[i], 2);
    const dvec3 sum = a + b + c;
    const double weight = glm::length(dvec3(areaVector(items[i])));
    whole += weight;
    mean += weight * sum;
    squares += weight * (sum * sum + a * a + b * b + c * c);
    products += weight * (dvec3(sum.y * sum.z, sum.z * sum.x, sum.x * sum.y) + dvec3(a.y * a.z, a.z * a.x, a.x * a.y) +
                          dvec3(b.y * b.z, b.z * b.x, b.x * b.y) + dvec3(c.y * c.z, c.z * c.x, c.x * c.y));
  }
  if (!(whole > 0.0)) return false;
  mean /= 3.0 * whole;
  squares = squares / (12.0 * whole) - mean * mean;
  products = products / (12.0 * whole) - dvec3(mean.y * mean.z, mean.z * mean.x, mean.x * mean.y);
  Eigen::Matrix3d covariance;
  covariance << squares.x, products.z, products.y, products.z, squares.y, products.x, products.y, products.x, squares.z;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Matrix3d& v = solver.eigenvectors();
  return squareAxes({v(0, 2), v(1, 2), v(2, 2)}, {v(0, 1), v(1, 1), v(2, 1)}, axes);
}

/// Its longest edge and its normal.
bool largestTriangleAxes(const BuildItem* items, std::size_t count, BuildAxes& axes) {
  const BuildItem* largest = items;
  float most = -1.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const fvec3 n = areaVector(items[i]);
    if (glm::dot(n, n) > most) {
      most = glm::dot(n, n);
      largest = items + i;
    }
  }
  dvec3 longest(0.0);
  for (int i = 0; i < 3; ++i) {
    const dvec3 side = dvec3(cornerOf(*largest, (i + 1) % 3)) - dvec3(cornerOf(*largest, i));
    if (glm::dot(side, side) > glm::dot(longest, longest)) longest = side;
  }
  return squareAxes(longest, areaVector(*largest), axes);
}

Extent extentOf(const BuildItem* items, std::size_t count, const BuildAxes& axes) {
  Extent extent;
  for (std::size_t i = 0; i < count; ++i) extent.add(collision::extentOf(items[i], axes));
  return extent;
}

}  // namespace

Extent extentOf(const BuildItem& item, const BuildAxes& axes) {
  Extent extent;
  for (int c = 0; c < 3; ++c) extent.add(axes.along(item.corner + 3 * c));
  return extent;
}

FittedBox fitBox(const BuildItem* items, std::size_t count, const BuildAxes& given, const Extent& along_given) {
  FittedBox best{given, along_given};
  float least = kWorthTurning * along_given.surface();
  const auto consider = [&](const BuildAxes& axes) {
    const Extent extent = extentOf(items, count, axes);
    if (extent.surface() >= least) return;
    least = extent.surface();
    best = {axes, extent};
  };
  BuildAxes axes;
  if (count > static_cast<std::size_t>(2) && covarianceAxes(items, count, axes)) consider(axes);
  if (count <= kFitByTriangleBelow && largestTriangleAxes(items, count, axes)) consider(axes);
  return best;
}

}  // namespace hapticell::collision
