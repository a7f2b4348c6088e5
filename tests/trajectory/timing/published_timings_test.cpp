// SPDX-License-Identifier: Apache-2.0
// Published problems of timing: paths through random waypoints as in the examples of TOPP-RA (github.com/hungpham2511/
// toppra, examples/plot_kinematics.py: five waypoints, a cubic spline, limits on speed and acceleration), and motions
// from rest to rest as Ruckig's without waypoints (github.com/pantor/ruckig, examples 01 and 02). References are
// written here and share nothing with the code: sweeps over a dense grid of the path for the first, and for the second
// a dense grid over all motions of that form.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "trajectory/timing/straight_timing.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {
namespace {

/// Shortest time along a path by dynamic programming in the phase plane: at each of `steps` places the greatest squared
/// path speed from which the rest can be reached, then forwards. Bounds are looked at on both ends of each step.
double sweptDuration(const CubicSpline& path, double velocity, double acceleration, std::size_t steps) {
  const std::size_t d = path.dimensions();
  const double length = path.breaks().back() - path.breaks().front(), h = length / static_cast<double>(steps);
  std::vector<std::vector<double>> first(steps + 1, std::vector<double>(d)), second = first;
  std::vector<double> ceiling(steps + 1, 1e9);
  for (std::size_t i = 0; i <= steps; ++i) {
    const double s = path.breaks().front() + h * static_cast<double>(i);
    path.evaluate(s, 1, first[i]);
    path.evaluate(s, 2, second[i]);
    for (std::size_t j = 0; j < d; ++j)
      ceiling[i] = std::min(ceiling[i], std::pow(velocity / std::max(1e-12, std::abs(first[i][j])), 2.0));
  }
  // From x only the y between two ends may follow: each bound is a line in y.
  const auto next = [&](std::size_t i, double x) {
    std::pair<double, double> y{0.0, ceiling[i + 1]};
    const auto bound = [&](double factor, double constant) {  // -acceleration <= factor y + constant <= acceleration
      if (std::abs(factor) < 1e-12) return;
      const double one = (-acceleration - constant) / factor, other = (acceleration - constant) / factor;
      y.first = std::max(y.first, std::min(one, other));
      y.second = std::min(y.second, std::max(one, other));
    };
    for (std::size_t j = 0; j < d; ++j) {
      bound(first[i][j] / (2.0 * h), (second[i][j] - first[i][j] / (2.0 * h)) * x);
      bound(first[i + 1][j] / (2.0 * h) + second[i + 1][j], -first[i + 1][j] / (2.0 * h) * x);
    }
    return y;
  };
  // Standing is always possible, and what is possible is convex: bisect for the greatest x that can go on.
  std::vector<double> reach(steps + 1, 0.0);
  for (std::size_t i = steps; i-- > 0;) {
    double low = 0.0, high = ceiling[i];
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      const auto [least, most] = next(i, middle);
      (least <= std::min(most, reach[i + 1]) ? low : high) = middle;
    }
    reach[i] = low;
  }
  double x = 0.0, time = 0.0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double y = std::min(next(i, x).second, reach[i + 1]);
    time += 2.0 * h / std::max(1e-9, std::sqrt(x) + std::sqrt(y));
    x = y;
  }
  return time;
}

CubicSpline waypointPath(std::mt19937& random, std::size_t points, std::size_t joints) {
  std::normal_distribution<double> joint(0.0, 1.0);
  std::vector<double> u, values;
  for (std::size_t i = 0; i < points; ++i) {
    u.push_back(static_cast<double>(i) / static_cast<double>(points - 1));
    for (std::size_t j = 0; j < joints; ++j) values.push_back(joint(random));
  }
  return fitSpline({u, values, {}, joints}, u, 1e-9);
}

TEST(PublishedTimings, PathsThroughWaypointsAsOfToppRa) {
  std::mt19937 random(1);
  for (int k = 0; k < 6; ++k) {
    const CubicSpline path = waypointPath(random, 5, 6);
    MotionLimits limits{std::vector<double>(6, 10.0), std::vector<double>(6, 10.0), {}};
    const auto timing = timeOptimal(path, limits);
    ASSERT_TRUE(timing.has_value());
    const double swept = sweptDuration(path, 10.0, 10.0, 3000);
    EXPECT_NEAR(timing->duration(), swept, 0.01 * swept) << k;
  }
}

/// The least time in which a way is run from rest to rest with bounded speed, acceleration and jerk: gaining speed is
/// the mirror of losing it, so a dense grid over the acceleration that is reached and how long it is held has all of
/// them.
double leastTime(double way, double velocity, double acceleration, double jerk) {
  double least = 1e300;
  for (int i = 1; i <= 2000; ++i) {
    const double a = acceleration * std::pow(10.0, 0.002 * (i - 2000)), ramp = a / jerk;
    for (int k = 0; k <= 2000; ++k) {
      // Time at that acceleration: from none to what reaches the greatest speed.
      const double longest = velocity / a - ramp;
      if (longest < 0.0) break;
      const double hold = longest * k / 2000.0;
      const double speed = a * (ramp + hold), gain = 2.0 * ramp + hold;
      const double run = speed * gain;  // Gained and lost.
      if (run > way) break;
      least = std::min(least, 2.0 * gain + (way - run) / speed);
    }
  }
  return least;
}

TEST(PublishedTimings, RestToRestWithoutWaypointsAsOfRuckig) {
  // Ways long and short: each bound is met or not.
  for (const auto& [way, v, a, j] : {std::tuple{3.0, 3.0, 3.0, 4.0},
                                     {1.0, 1.0, 2.0, 5.0},
                                     {0.01, 1.0, 2.0, 5.0},
                                     {0.3, 0.5, 10.0, 40.0},
                                     {10.0, 0.5, 10.0, 4.0},
                                     {0.2, 2.0, 0.5, 1000.0},
                                     {1.0, 100.0, 1.0, 0.001}}) {
    const StraightTiming timing(way, v, a, j);
    const double reference = leastTime(way, v, a, j);
    EXPECT_NEAR(timing.duration(), reference, 0.002 * reference) << way;
    EXPECT_LE(timing.duration(), reference * (1.0 + 1e-9)) << way << ": the grid's are motions too";
    // And it is a motion: by differences of its own.
    const double dt = timing.duration() / 5000.0;
    double most_v = 0.0, most_a = 0.0, most_j = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double p[] = {timing.at(dt * (i - 1)), timing.at(dt * i), timing.at(dt * (i + 1)), timing.at(dt * (i + 2))};
      most_v = std::max(most_v, (p[2] - p[1]) / dt);
      most_a = std::max(most_a, std::abs(p[2] - 2.0 * p[1] + p[0]) / (dt * dt));
      most_j = std::max(most_j, std::abs(p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0]) / (dt * dt * dt));
    }
    EXPECT_LE(most_v, v * 1.0001) << way;
    EXPECT_LE(most_a, a * 1.0001) << way;
    EXPECT_LE(most_j, j * 1.001) << way;
    EXPECT_NEAR(timing.at(timing.duration()), way, 1e-12) << way;
  }
  // Published: with a way of 1, speed 1, acceleration 2, jerk 5 all three bounds are met: 1/1 + 1/2 + 2/5 s.
  EXPECT_NEAR(StraightTiming(1.0, 1.0, 2.0, 5.0).duration(), 1.9, 1e-12);
}

}  // namespace
}  // namespace hapticell::trajectory
