// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "trajectory/motion/trajectory.h"

namespace hapticell::test {

/// A gesture through a cell as a function of time: loops of some 0.3 m and turns of half a radian.
inline Pose gestureAt(double t) {
  const dvec3 p(0.3 * std::sin(0.4 * t) + 0.05 * std::sin(1.3 * t), 0.25 * std::cos(0.33 * t),
                0.1 * std::sin(0.7 * t) + 0.5);
  return {p,
          quaternionFromRotationVector({0.4 * std::sin(0.3 * t), 0.5 * std::cos(0.25 * t), 0.6 * std::sin(0.2 * t)})};
}

/// That gesture sampled, with a hand's tremor (m, at 9 Hz, in a direction that turns) and measuring noise on it.
inline trajectory::Trajectory recordedGesture(double seconds, double rate_hz, double tremor, double noise = 0.0) {
  trajectory::Trajectory result;
  result.name = "gesture";
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  const auto count = static_cast<int>(seconds * rate_hz);
  for (int i = 0; i <= count; ++i) {
    const double t = i / rate_hz;
    Pose X = gestureAt(t);
    const double wave = std::sin(2.0 * std::numbers::pi * 9.0 * t);
    X.p += tremor * wave * glm::normalize(dvec3(std::cos(t), std::sin(t), 0.5));
    X.p += noise * dvec3(normal(random), normal(random), normal(random));
    result.addFrame({t, X});
  }
  return result;
}

}  // namespace hapticell::test
