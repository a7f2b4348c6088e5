// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/frame_use.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hapticell::trajectory {

namespace {

/// Numbers of each frame that are limited, and what the differences of them are.
class LimitedFrames {
 public:
  LimitedFrames(const Trajectory& frames, LimitedBy by) : frames_(frames), by_(by) {}
  std::size_t dimensions() const { return by_ == LimitedBy::kJoints ? frames_.joint_names.size() : 6; }

  /// From frame `i - stride` to frame `i`, in those of the ends where there are none.
  void step(std::ptrdiff_t i, std::ptrdiff_t stride, std::span<double> change) const {
    const std::size_t b = clamped(i), a = clamped(i - stride);
    if (by_ == LimitedBy::kJoints) {
      const auto from = frames_.joints(a), to = frames_.joints(b);
      for (std::size_t j = 0; j < change.size(); ++j) change[j] = to[j] - from[j];
      return;
    }
    const dvec3 way = frames_[b].X_WT.p - frames_[a].X_WT.p;
    const dvec3 turn = rotationVector(frames_[b].X_WT.q * glm::conjugate(frames_[a].X_WT.q));
    for (int k = 0; k < 3; ++k) {
      change[static_cast<std::size_t>(k)] = way[k];
      change[static_cast<std::size_t>(k) + 3] = turn[k];
    }
  }

  double largest() const {
    double most = 1.0;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (by_ == LimitedBy::kPose) most = std::max(most, glm::length(frames_[i].X_WT.p));
      for (const double q : frames_.joints(i)) most = std::max(most, std::abs(q));
    }
    return most;
  }

 private:
  std::size_t clamped(std::ptrdiff_t i) const {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(frames_.size()) - 1));
  }

  const Trajectory& frames_;
  LimitedBy by_;
};

/// The largest share of `limits` that the differences of one order (1: speed, 2, 3) over `stride` steps use.
double useOfOrder(const LimitedFrames& frames, std::size_t count, double step, const std::vector<double>& limits,
                  int order, std::ptrdiff_t stride) {
  const double dt = step * static_cast<double>(stride);
  const double scale = 1.0 / std::pow(dt, order);
  std::vector<double> a(frames.dimensions()), b(a), c(a);
  double most = 0.0;
  const auto end = static_cast<std::ptrdiff_t>(count) + (order - 1) * stride;
  for (std::ptrdiff_t i = 1; i < end; ++i) {
    frames.step(i, stride, a);
    if (order > 1) frames.step(i - stride, stride, b);
    if (order > 2) frames.step(i - 2 * stride, stride, c);
    for (std::size_t j = 0; j < a.size(); ++j) {
      double change = a[j];
      if (order == 2) change = a[j] - b[j];
      if (order == 3) change = a[j] - 2.0 * b[j] + c[j];
      most = std::max(most, std::abs(change) * scale / limits[j]);
    }
  }
  return most;
}

}  // namespace

LimitUse useOfFrames(const Trajectory& frames, double step, const MotionLimits& limits, LimitedBy by) {
  const LimitedFrames limited(frames, by);
  const std::size_t count = frames.size();
  LimitUse use;
  use.velocity = useOfOrder(limited, count, step, limits.velocity, 1, 1);
  use.acceleration = useOfOrder(limited, count, step, limits.acceleration, 2, 1);
  if (limits.jerk.empty()) return use;
  // Eight roundings of a number of that size must not show beside the limit.
  const double least = *std::min_element(limits.jerk.begin(), limits.jerk.end());
  const double wide = std::cbrt(8.0 * 2.3e-16 * limited.largest() / (1e-5 * least)) / step;
  const auto stride = static_cast<std::ptrdiff_t>(std::clamp(std::ceil(wide), 1.0, static_cast<double>(count)));
  use.jerk = useOfOrder(limited, count, step, limits.jerk, 3, stride);
  return use;
}

}  // namespace hapticell::trajectory
