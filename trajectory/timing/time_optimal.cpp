// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/time_optimal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "trajectory/timing/timing_grid.h"

namespace hapticell::trajectory {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Slopes below it are zero: rounding of numbers near 1. Half, twice: no effect.
constexpr double kTiny = 1e-12;

struct Interval {
  double least = 0.0, most = 0.0;
  bool isEmpty() const { return most < least; }
};

/// Upper minus lower envelope at x: as `slope` of the two lines that meet there, and how much room is between them.
struct Room {
  double room, slope;
};

Room roomAt(const TimingStage& stage, double x) {
  double high = kInfinity, low = -kInfinity, high_slope = 0.0, low_slope = 0.0;
  for (const BoundLine& line : stage.upper) {
    const double u = line.at(x);
    const bool less = u < high;
    high = less ? u : high;
    high_slope = less ? line.slope : high_slope;
  }
  for (const BoundLine& line : stage.lower) {
    const double u = line.at(x);
    const bool more = u > low;
    low = more ? u : low;
    low_slope = more ? line.slope : low_slope;
  }
  return {high - low, high_slope - low_slope};
}

/// The x for which some u lies between all lines. The room between them is concave in x, so that Newton's method from
/// outside comes to its zero in as many steps as lines are met on the way.
Interval feasible(const TimingStage& stage) {
  constexpr Interval kEmpty{1.0, 0.0};
  Interval x{0.0, stage.x_most};
  for (const bool from_above : {true, false}) {
    double& end = from_above ? x.most : x.least;
    for (Room at = roomAt(stage, end); at.room < 0.0; at = roomAt(stage, end)) {
      const double next = end - at.room / at.slope;
      if (std::abs(at.slope) < kTiny || (at.slope > 0.0) == from_above) {
        if (at.room < -kTiny) return kEmpty;
        break;
      }
      if (from_above ? next >= end : next <= end) break;  // as near as doubles come
      end = next;
      if (x.isEmpty()) return kEmpty;
    }
  }
  return x;
}

void addNextSet(TimingStage& stage, const Interval& next, double step) {
  stage.upper.push_back({next.most / (2.0 * step), -1.0 / (2.0 * step)});
  stage.lower.push_back({next.least / (2.0 * step), -1.0 / (2.0 * step)});
}

/// Speeds at the grid points, or none where the start or the end speed cannot be had.
std::optional<std::vector<double>> reach(const TimingGrid& grid, const TimingOptions& options) {
  const std::size_t n = grid.size();
  std::vector<Interval> sets(n);
  const double end = options.end_speed * options.end_speed;
  sets[n - 1] = {end, end};
  if (end > grid.speedBound(2 * (n - 1))) return std::nullopt;
  std::vector<TimingStage> stages(n);
  for (std::size_t i = n - 1; i-- > 0;) {
    grid.fill(i, stages[i]);
    addNextSet(stages[i], sets[i + 1], grid.step(i));
    sets[i] = feasible(stages[i]);
    if (sets[i].isEmpty()) return std::nullopt;
  }
  double x = options.start_speed * options.start_speed;
  if (x < sets[0].least - 1e-9 || x > sets[0].most + 1e-9) return std::nullopt;
  std::vector<double> speeds{std::sqrt(x)};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    double u = kInfinity;
    for (const BoundLine& high : stages[i].upper) u = std::min(u, high.at(x));
    // Rounding may put x a hair outside; the next set is met all the same.
    x = std::clamp(x + 2.0 * grid.step(i) * u, sets[i + 1].least, std::max(sets[i + 1].least, sets[i + 1].most));
    speeds.push_back(std::sqrt(std::max(0.0, x)));
  }
  return speeds;
}

/// The largest use of the limits over some thousand steps of the motion's own time, whatever its scale, the
/// acceleration's growth taken over a step; steps begin at so many places within a step. `path`: a TimingGrid or a path.
template <class Path>
LimitUse worstUse(const Path& path, const PathTiming& timing, const MotionLimits& limits, std::size_t phases) {
  // Places in time where limits are checked, each with `phases`. Half: peaks of a 1500th of the time may be over a
  // limit (the frames' own check finds them); twice: twice the time.
  constexpr std::size_t kSteps = 3000;
  const std::size_t d = path.dimensions();
  const double dt = timing.duration() / static_cast<double>(kSteps);
  std::vector<double> first(d), second(d), accelerations(phases * d, 0.0);
  LimitUse use;
  for (std::size_t i = 0; i <= phases * (kSteps + 1); ++i) {
    const PathTiming::State state = timing.at(dt / static_cast<double>(phases) * static_cast<double>(i));
    path.derivatives(state.s, first, second);
    for (std::size_t j = 0; j < d; ++j) {
      double& before = accelerations[(i % phases) * d + j];  // One step ago.
      const double acceleration = first[j] * state.acceleration + second[j] * state.speed * state.speed;
      use.velocity = std::max(use.velocity, std::abs(first[j] * state.speed) / limits.velocity[j]);
      use.acceleration = std::max(use.acceleration, std::abs(acceleration) / limits.acceleration[j]);
      use.jerk = std::max(use.jerk, std::abs(acceleration - before) / dt / limits.jerk[j]);
      before = acceleration;
    }
  }
  return use;
}

/// Stretched until its limits hold. All uses fall with a power of the stretch, so this ends in a few steps.
PathTiming held(const LimitedPath& path, PathTiming timing, const MotionLimits& limits) {
  for (int round = 0; round < 8; ++round) {
    const double factor = stretchFor(worstUse(path, timing, limits, 3));
    if (factor <= 1.0 + 1e-6) break;
    timing = timing.stretched(factor * (1.0 + 1e-7));
  }
  return timing;
}

Expected<void> checkPath(const LimitedPath& path, const MotionLimits& limits) {
  if (auto checked = checkLimits(path.dimensions(), limits); !checked) return checked;
  if (path.breaks().back() > path.breaks().front()) return {};
  return makeError({.place = "path", .found = "a path of length zero", .expected = "at least two different frames"});
}

Expected<PathTiming> fastestOn(const TimingGrid& grid, const TimingOptions& options) {
  auto speeds = reach(grid, options);
  if (!speeds) {
    return makeError({.place = "path",
                      .found = "a start or end speed that the limits do not allow",
                      .expected = "no motion at start and end"});
  }
  const LimitUse use = grid.useBetween(*speeds);
  PathTiming timing(grid.s(), std::move(*speeds));
  if (options.start_speed > 0.0 || options.end_speed > 0.0) return timing;
  // Between the places looked at a limit may still be passed by parts in a thousand.
  return timing.stretched(stretchFor(use));
}

}  // namespace

double stretchFor(const LimitUse& use) {
  return std::max({1.0, use.velocity, std::sqrt(use.acceleration), std::cbrt(use.jerk)});
}

LimitUse limitUse(const CubicSpline& path, const PathTiming& timing, const MotionLimits& limits, double dt) {
  const std::size_t d = path.dimensions();
  std::vector<double> first(d), second(d), before(d, 0.0), acceleration(d);
  LimitUse use;
  const auto steps = static_cast<std::size_t>(std::ceil(timing.duration() / dt));
  for (std::size_t i = 0; i <= steps; ++i) {
    const PathTiming::State state = timing.at(static_cast<double>(i) * dt);
    path.evaluate(state.s, 1, first);
    path.evaluate(state.s, 2, second);
    for (std::size_t j = 0; j < d; ++j) {
      acceleration[j] = first[j] * state.acceleration + second[j] * state.speed * state.speed;
      use.velocity = std::max(use.velocity, std::abs(first[j] * state.speed) / limits.velocity[j]);
      use.acceleration = std::max(use.acceleration, std::abs(acceleration[j]) / limits.acceleration[j]);
      if (!limits.jerk.empty()) {
        use.jerk = std::max(use.jerk, std::abs(acceleration[j] - before[j]) / dt / limits.jerk[j]);
      }
    }
    before = acceleration;
  }
  return use;
}

Expected<void> checkLimits(std::size_t dimensions, const MotionLimits& limits) {
  const auto bad = [](const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double v) { return !(v > 0.0) || !std::isfinite(v); });
  };
  if (limits.velocity.size() != dimensions || limits.acceleration.size() != dimensions || bad(limits.velocity) ||
      bad(limits.acceleration) || (!limits.jerk.empty() && (limits.jerk.size() != dimensions || bad(limits.jerk)))) {
    return makeError({.place = "limits",
                      .found = "limits that are missing or not above 0",
                      .expected = Text("a velocity and an acceleration above 0 for each of %1 axes", dimensions)});
  }
  return {};
}

Expected<PathTiming> timeOptimal(const LimitedPath& path, const MotionLimits& limits, const TimingOptions& options) {
  HAPTICELL_TRY(checkPath(path, limits));
  return fastestOn(TimingGrid(path, limits, std::max<std::size_t>(options.grid_points, 3)), options);
}

Expected<PathTiming> jerkLimited(const LimitedPath& path, const MotionLimits& limits, const TimingOptions& options) {
  HAPTICELL_TRY(checkPath(path, limits));
  const TimingGrid grid(path, limits, std::max<std::size_t>(options.grid_points, 3));
  auto fastest = fastestOn(grid, options);
  if (!fastest || limits.jerk.empty()) return fastest;
  // Many are compared, so the path is looked at by its grid; the best alone is held to the path itself.
  PathTiming best;
  const auto tryWindow = [&](const PathTiming& base, double share) {
    const PathTiming averaged = base.averaged(share * base.duration());
    // All uses fall with a power of the stretch.
    PathTiming timing = averaged.stretched(stretchFor(worstUse(grid, averaged, limits, 1)));
    const double duration = timing.duration();
    if (best.duration() == 0.0 || duration < best.duration()) best = std::move(timing);
    return duration;
  };
  const double peak = worstUse(grid, *fastest, limits, 1).velocity;
  // With a lower speed there is a time between gaining and losing it, which small jerk limits leave none of.
  for (const double slower : {1.0, 0.8, 0.65, 0.5}) {
    MotionLimits lower = limits;
    for (double& velocity : lower.velocity) velocity *= slower == 1.0 ? 1.0 : std::max(slower * peak, 1e-9);
    const auto base = slower == 1.0 ? fastest : fastestOn(TimingGrid(grid, lower), options);
    if (!base) continue;
    double before = kInfinity;
    for (double share = 0.01; share < 0.6; share *= 1.4) {
      const double duration = tryWindow(*base, share);
      if (duration > 1.1 * before) break;  // Past the best one.
      before = std::min(before, duration);
    }
  }
  return held(path, std::move(best), limits);
}

Expected<PathTiming> timeOptimal(const CubicSpline& path, const MotionLimits& limits, const TimingOptions& options) {
  return timeOptimal(LimitedSpline(path), limits, options);
}

Expected<PathTiming> jerkLimited(const CubicSpline& path, const MotionLimits& limits, const TimingOptions& options) {
  return jerkLimited(LimitedSpline(path), limits, options);
}

}  // namespace hapticell::trajectory
