// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/cubic_spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

namespace {

/// Symmetric positive definite matrix of half bandwidth 3, rows of [diagonal, next three].
class BandMatrix {
 public:
  explicit BandMatrix(std::size_t size) : rows_(size, {0.0, 0.0, 0.0, 0.0}) {}
  void add(std::size_t row, std::size_t offset, double value) { rows_[row][offset] += value; }
  std::size_t size() const { return rows_.size(); }

  /// Replaces itself by its factor L^T (row i: L(i,i), L(i+1,i), ...).
  void factorise() {
    for (std::size_t i = 0; i < size(); ++i) {
      const double pivot = std::sqrt(std::max(rows_[i][0], 1e-300));
      for (double& value : rows_[i]) value /= pivot;
      for (std::size_t j = 1; j < 4 && i + j < size(); ++j) {
        for (std::size_t k = j; k < 4 && i + k < size(); ++k) rows_[i + j][k - j] -= rows_[i][j] * rows_[i][k];
      }
    }
  }

  /// Solves for all columns of `b` (size() rows of `columns` numbers) in place.
  void solve(std::span<double> b, std::size_t columns) const {
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t c = 0; c < columns; ++c) b[i * columns + c] /= rows_[i][0];
      for (std::size_t j = 1; j < 4 && i + j < size(); ++j) {
        for (std::size_t c = 0; c < columns; ++c) b[(i + j) * columns + c] -= rows_[i][j] * b[i * columns + c];
      }
    }
    for (std::size_t i = size(); i-- > 0;) {
      for (std::size_t j = 1; j < 4 && i + j < size(); ++j) {
        for (std::size_t c = 0; c < columns; ++c) b[i * columns + c] -= rows_[i][j] * b[(i + j) * columns + c];
      }
      for (std::size_t c = 0; c < columns; ++c) b[i * columns + c] /= rows_[i][0];
    }
  }

 private:
  std::vector<std::array<double, 4>> rows_;
};

}  // namespace

CubicSpline::CubicSpline(std::vector<double> breaks, std::size_t dimensions)
    : breaks_(std::move(breaks)), dimensions_(dimensions) {
  HAPTICELL_DEMAND(breaks_.size() >= 2);
  controls_.assign(controlCount() * dimensions_, 0.0);
}

double CubicSpline::knot(std::size_t i) const {
  const std::size_t last = breaks_.size() - 1;
  return i <= 3 ? breaks_.front() : breaks_[std::min(i - 3, last)];
}

double CubicSpline::averageKnot(std::size_t i) const {
  return (knot(i + 1) + knot(i + 2) + knot(i + 3)) / 3.0;
}

std::size_t CubicSpline::spanOf(double u) const {
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, u);
  return static_cast<std::size_t>(after - breaks_.begin()) - 1;
}

/// Cox and de Boor's recursion; derivatives as differences of the lower order's basis.
CubicSpline::Basis CubicSpline::basis(double u, int order) const {
  u = std::clamp(u, breaks_.front(), breaks_.back());
  const std::size_t span = spanOf(u);
  const std::size_t k = span + 3;  // knot(k) <= u <= knot(k + 1)
  const int degree = 3 - order;
  std::array<double, 5> n{};  // n[3 - d .. 3]: basis of degree d, the last one begins at knot k
  n[3] = 1.0;
  for (int d = 1; d <= 3; ++d) {
    for (int j = d; j >= 0; --j) {
      // Function i = k - j of degree d.
      const std::size_t i = k - static_cast<std::size_t>(j);
      const double left = knot(i + static_cast<std::size_t>(d)) - knot(i);
      const double right = knot(i + static_cast<std::size_t>(d) + 1) - knot(i + 1);
      const auto at = static_cast<std::size_t>(3 - j);
      const double lower = n[at];      // i of degree d - 1 (zero for j = d)
      const double upper = n[at + 1];  // i + 1 of degree d - 1 (zero for j = 0)
      const double from_lower = j == d ? 0.0 : lower;
      const double from_upper = j == 0 ? 0.0 : upper;
      if (d <= degree) {
        n[at] = (left > 0.0 ? (u - knot(i)) / left * from_lower : 0.0) +
                (right > 0.0 ? (knot(i + static_cast<std::size_t>(d) + 1) - u) / right * from_upper : 0.0);
      } else {
        n[at] = d * ((left > 0.0 ? from_lower / left : 0.0) - (right > 0.0 ? from_upper / right : 0.0));
      }
    }
  }
  Basis result;
  result.first = span;
  for (std::size_t i = 0; i < 4; ++i) result.values[i] = n[i];
  return result;
}

void CubicSpline::evaluate(double u, int order, std::span<double> result) const {
  const Basis b = basis(u, order);
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const double* point = control(b.first + i);
    for (std::size_t c = 0; c < dimensions_; ++c) result[c] += b.values[i] * point[c];
  }
}

CubicSpline fitSpline(const SplineData& data, std::vector<double> breaks, double ridge) {
  CubicSpline spline(std::move(breaks), data.dimensions);
  const std::size_t count = spline.controlCount();
  BandMatrix normal(count);
  std::vector<double> right(count * data.dimensions, 0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < data.u.size(); ++i) {
    const double weight = data.weights.empty() ? 1.0 : data.weights[i];
    total += weight;
    const auto basis = spline.basis(data.u[i]);
    for (std::size_t a = 0; a < 4; ++a) {
      const double wa = weight * basis.values[a];
      for (std::size_t b = a; b < 4; ++b) normal.add(basis.first + a, b - a, wa * basis.values[b]);
      for (std::size_t c = 0; c < data.dimensions; ++c) {
        right[(basis.first + a) * data.dimensions + c] += wa * data.values[i * data.dimensions + c];
      }
    }
  }
  // Penalised bends between neighbouring controls (P-splines: Eilers & Marx, 1996), at the knots' averages, where equal
  // steps of a control are a straight line.
  const double damping = ridge * std::max(total / static_cast<double>(count), 1e-300);
  for (std::size_t i = 0; i + 2 < count; ++i) {
    const double before = spline.averageKnot(i + 1) - spline.averageKnot(i);
    const double after = spline.averageKnot(i + 2) - spline.averageKnot(i + 1);
    const double mean = 0.5 * (before + after);
    const std::array<double, 3> bend{mean / before, -mean / before - mean / after, mean / after};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = a; b < 3; ++b) normal.add(i + a, b - a, damping * bend[a] * bend[b]);
    }
  }
  for (std::size_t i = 0; i < count; ++i) normal.add(i, 0, 1e-8 * damping);
  normal.factorise();
  normal.solve(right, data.dimensions);
  std::copy(right.begin(), right.end(), spline.control(0));
  return spline;
}

}  // namespace hapticell::trajectory
