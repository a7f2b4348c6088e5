// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/motion_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hapticell::trajectory {

namespace {

// Samples to either side that a derivative looks at: nine samples for a cubic. Half: jerk shows mostly noise; twice:
// short peaks of jerk are flattened.
constexpr int kHalf = 4;
constexpr std::size_t kLeast = 2 * kHalf + 1;
// So many samples are drawn of few frames, too, for curves without corners. Half: corners may be seen; twice: twice the
// time, not seen.
constexpr std::size_t kSmooth = 240;

/// Sums of powers of k over a window from -left to right, and of them times the values.
struct Window {
  std::array<double, 7> power{};
  std::array<double, 4> moment{};
};

/// Coefficients of the cubic through a window by Cholesky-free elimination of its 4 x 4 normal equations.
std::array<double, 4> fitCubic(const Window& window) {
  double m[4][5];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) m[r][c] = window.power[static_cast<std::size_t>(r + c)];
    m[r][4] = window.moment[static_cast<std::size_t>(r)];
  }
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int r = k + 1; r < 4; ++r) {
      if (std::abs(m[r][k]) > std::abs(m[pivot][k])) pivot = r;
    }
    std::swap(m[k], m[pivot]);
    for (int r = k + 1; r < 4; ++r) {
      const double f = m[r][k] / m[k][k];
      for (int c = k; c < 5; ++c) m[r][c] -= f * m[k][c];
    }
  }
  std::array<double, 4> a{};
  for (int r = 3; r >= 0; --r) {
    double sum = m[r][4];
    for (int c = r + 1; c < 4; ++c) sum -= m[r][c] * a[static_cast<std::size_t>(c)];
    a[static_cast<std::size_t>(r)] = sum / m[r][r];
  }
  return a;
}

void differentiate(MotionCurve& curve, double step) {
  const auto count = static_cast<int>(curve.value.size());
  curve.speed.assign(curve.value.size(), 0.0);
  curve.acceleration = curve.jerk = curve.speed;
  for (int i = 0; i < count; ++i) {
    // At the ends the window lies to one side.
    const int centre = std::clamp(i, kHalf, count - 1 - kHalf);
    Window window;
    for (int k = -kHalf; k <= kHalf; ++k) {
      double power = 1.0;
      for (std::size_t p = 0; p < 7; ++p, power *= k) {
        window.power[p] += power;
        if (p < 4) window.moment[p] += power * curve.value[static_cast<std::size_t>(centre + k)];
      }
    }
    const auto a = fitCubic(window);
    const double u = i - centre;
    const auto at = static_cast<std::size_t>(i);
    curve.speed[at] = (a[1] + u * (2.0 * a[2] + 3.0 * u * a[3])) / step;
    curve.acceleration[at] = (2.0 * a[2] + 6.0 * u * a[3]) / (step * step);
    curve.jerk[at] = 6.0 * a[3] / (step * step * step);
  }
}

/// A rotation vector of the same rotation that is nearest to `before`: no leap at half a turn.
dvec3 nearestTurn(const dvec3& turn, const dvec3& before) {
  const double angle = glm::length(turn);
  if (angle < 1e-9) return turn;
  constexpr double kRound = 2.0 * std::numbers::pi;
  const double rounds = std::round((glm::dot(before, turn) / angle - angle) / kRound);
  return turn * (1.0 + rounds * kRound / angle);
}

}  // namespace

MotionCurves motionCurves(const Trajectory& trajectory, std::size_t most) {
  MotionCurves curves;
  if (trajectory.size() < 2) return curves;
  curves.samples = std::clamp(4 * trajectory.size(), std::min(kSmooth, std::max(most, kLeast)), std::max(most, kLeast));
  curves.begin = trajectory[0].t;
  curves.step = trajectory.duration() / static_cast<double>(curves.samples - 1);
  for (const char* name : {"x", "y", "z"})
    curves.cartesian.push_back({name, MotionCurve::Unit::kMetres, {}, {}, {}, {}});
  for (const char* name : {"turn x", "turn y", "turn z"}) {
    curves.cartesian.push_back({name, MotionCurve::Unit::kRadians, {}, {}, {}, {}});
  }
  for (const std::string& name : trajectory.joint_names) {
    curves.joints.push_back({name, MotionCurve::Unit::kRadians, {}, {}, {}, {}});
  }
  curves.path.name = "path";
  dvec3 turn(0.0), before(0.0);
  double length = 0.0;
  for (std::size_t i = 0; i < curves.samples; ++i) {
    const double t = std::min(curves.timeOf(i), trajectory.frames().back().t);
    const Pose X = trajectory.poseAt(t);
    turn = nearestTurn(difference(X, trajectory[0].X_WT).angular, turn);
    if (i > 0) length += glm::distance(X.p, before);
    before = X.p;
    curves.path.value.push_back(length);
    for (int k = 0; k < 3; ++k) {
      curves.cartesian[static_cast<std::size_t>(k)].value.push_back(X.p[k]);
      curves.cartesian[static_cast<std::size_t>(k) + 3].value.push_back(turn[k]);
    }
    const auto joints = trajectory.jointsAt(t);
    for (std::size_t j = 0; j < joints.size(); ++j) curves.joints[j].value.push_back(joints[j]);
  }
  for (MotionCurve& curve : curves.cartesian) differentiate(curve, curves.step);
  for (MotionCurve& curve : curves.joints) differentiate(curve, curves.step);
  differentiate(curves.path, curves.step);
  return curves;
}

CurvePeaks peaksOf(const MotionCurve& curve) {
  const auto peak = [](const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  };
  return {peak(curve.speed), peak(curve.acceleration), peak(curve.jerk)};
}

}  // namespace hapticell::trajectory
