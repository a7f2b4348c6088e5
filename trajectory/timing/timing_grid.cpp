// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/timing_grid.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

// Slopes below it are zero: rounding of numbers near 1. Half, twice: no effect.
constexpr double kNoSlope = 1e-12;

}  // namespace

void TimingStage::clear() {
  lower.clear();
  upper.clear();
}

void TimingStage::add(const BoundRow& row) {
  if (std::abs(row.a) < kNoSlope) {
    if (std::abs(row.b) > kNoSlope) x_most = std::min(x_most, row.m / std::abs(row.b));
    return;
  }
  const BoundLine one{row.m / row.a, -row.b / row.a};
  const BoundLine other{-row.m / row.a, -row.b / row.a};
  upper.push_back(row.a > 0.0 ? one : other);
  lower.push_back(row.a > 0.0 ? other : one);
}

TimingGrid::TimingGrid(const LimitedPath& path, const MotionLimits& limits, std::size_t points) : limits_(limits) {
  const std::size_t d = path.dimensions();
  layGrid(path, points);
  const std::size_t halves = 2 * s_.size() - 1;
  first_.resize(halves * d);
  second_.resize(halves * d);
  dimensions_ = d;
  for (std::size_t i = 0; i < halves; ++i) {
    const double s = i % 2 == 0 ? s_[i / 2] : 0.5 * (s_[i / 2] + s_[i / 2 + 1]);
    path.derivatives(s, std::span(first_).subspan(i * d, d), std::span(second_).subspan(i * d, d));
  }
}

void TimingGrid::derivatives(double s, std::span<double> first, std::span<double> second) const {
  const auto after = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - s_.begin()) - 1;
  const double f = std::clamp((s - s_[i]) / step(i), 0.0, 1.0);
  const double w0 = (1.0 - f) * (1.0 - 2.0 * f), w1 = 4.0 * f * (1.0 - f), w2 = f * (2.0 * f - 1.0);
  const double *a = first_.data() + 2 * i * dimensions_, *b = second_.data() + 2 * i * dimensions_;
  for (std::size_t j = 0; j < dimensions_; ++j) {
    first[j] = w0 * a[j] + w1 * a[dimensions_ + j] + w2 * a[2 * dimensions_ + j];
    second[j] = (1.0 - f) * b[j] + f * b[2 * dimensions_ + j];
  }
}

void TimingGrid::fill(std::size_t i, TimingStage& stage) const {
  stage.clear();
  stage.x_most = speedBound(2 * i);
  const std::size_t last = i + 1 == size() ? 2 * i : 2 * i + 2;
  for (std::size_t k = 2 * i; k <= last; ++k) {
    const double way = k == 2 * i ? 0.0 : static_cast<double>(k - 2 * i) * step(i);  // 2 w step
    for (std::size_t j = 0; j < dimensions_; ++j) {
      const double a = first_[k * dimensions_ + j];
      const double b = second_[k * dimensions_ + j];
      stage.add({a + way * b, b, limits_.acceleration[j]});
    }
  }
  if (last > 2 * i) stage.upper.push_back({speedBound(2 * i + 1) / step(i), -1.0 / step(i)});
}

double TimingGrid::speedBound(std::size_t k) const {
  double most = 1e12;
  for (std::size_t j = 0; j < dimensions_; ++j) {
    const double slope = std::abs(first_[k * dimensions_ + j]);
    if (slope > kNoSlope) most = std::min(most, (limits_.velocity[j] / slope) * (limits_.velocity[j] / slope));
  }
  return most;
}

LimitUse TimingGrid::useBetween(const std::vector<double>& speeds) const {
  LimitUse use;
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    const double x0 = speeds[i] * speeds[i], dx = speeds[i + 1] * speeds[i + 1] - x0;
    const double u = dx / (2.0 * step(i));
    for (const double f : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
      const double x = std::max(0.0, x0 + f * dx), speed = std::sqrt(x);
      const double w0 = (1.0 - f) * (1.0 - 2.0 * f), w1 = 4.0 * f * (1.0 - f), w2 = f * (2.0 * f - 1.0);
      const double *a = first_.data() + 2 * i * dimensions_, *b = second_.data() + 2 * i * dimensions_;
      for (std::size_t j = 0; j < dimensions_; ++j) {
        const double slope = w0 * a[j] + w1 * a[dimensions_ + j] + w2 * a[2 * dimensions_ + j];
        const double bend = (1.0 - f) * b[j] + f * b[2 * dimensions_ + j];
        use.velocity = std::max(use.velocity, std::abs(slope) * speed / limits_.velocity[j]);
        use.acceleration = std::max(use.acceleration, std::abs(slope * u + bend * x) / limits_.acceleration[j]);
      }
    }
  }
  return use;
}

/// Even steps, and the path's own breaks, where its bend kinks; a break takes the place of a step's end nearby.
void TimingGrid::layGrid(const LimitedPath& path, std::size_t points) {
  const std::vector<double>& breaks = path.breaks();
  const double step = (breaks.back() - breaks.front()) / static_cast<double>(points - 1);
  s_ = breaks;
  std::size_t next = 1;
  for (std::size_t i = 1; i + 1 < points; ++i) {
    const double s = breaks.front() + step * static_cast<double>(i);
    while (breaks[next] < s) ++next;
    if (s - breaks[next - 1] > 0.1 * step && breaks[next] - s > 0.1 * step) s_.push_back(s);
  }
  std::sort(s_.begin(), s_.end());
}

}  // namespace hapticell::trajectory
