// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hapticell::trajectory {

/// Cubic B-spline in any number of dimensions over [first knot, last knot], its ends clamped.
class CubicSpline {
 public:
  CubicSpline() = default;
  /// `breaks`: strictly increasing, at least two.
  CubicSpline(std::vector<double> breaks, std::size_t dimensions);

  std::size_t dimensions() const { return dimensions_; }
  const std::vector<double>& breaks() const { return breaks_; }
  std::size_t controlCount() const { return breaks_.size() + 2; }
  double* control(std::size_t i) { return controls_.data() + i * dimensions_; }
  const double* control(std::size_t i) const { return controls_.data() + i * dimensions_; }

  /// Values or derivatives (order 0 to 3) at u, clamped to the ends, into `result` (dimensions() numbers).
  void evaluate(double u, int order, std::span<double> result) const;

  /// The four basis functions (or their derivatives) that are not zero at u, and the index of the first.
  struct Basis {
    std::size_t first = 0;
    double values[4] = {};
  };
  Basis basis(double u, int order = 0) const;

  /// The parameter where control point i has most influence (Greville's abscissa).
  double averageKnot(std::size_t i) const;

 private:
  std::size_t spanOf(double u) const;
  double knot(std::size_t i) const;  ///< Of the clamped knot vector.

  std::vector<double> breaks_;
  std::size_t dimensions_ = 0;
  std::vector<double> controls_;
};

/// Weighted points to approximate: at parameter u[i] the `dimensions` numbers from values[i * dimensions] on.
struct SplineData {
  std::span<const double> u;  ///< Increasing.
  std::span<const double> values;
  std::span<const double> weights;  ///< One per point; empty: all 1.
  std::size_t dimensions = 0;
};

/// The spline on `breaks` with the least weighted squared distance to the points (banded normal equations, Cholesky).
/// Bends of the control polygon are damped by `ridge` times the mean weight, so that spans without points are straight.
CubicSpline fitSpline(const SplineData& data, std::vector<double> breaks, double ridge = 1e-9);

}  // namespace hapticell::trajectory
