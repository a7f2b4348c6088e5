// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/time_optimal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Slopes below it are zero: rounding of numbers near 1. Half, twice: no effect.
constexpr double kTiny = 1e-12;

/// With x = (ds/dt)^2 and u = d2s/dt2 each bound on acceleration is -m <= a u + b x <= m.
struct Row {
  double a, b, m;
};

/// u between lines of x: lower <= u <= upper.
struct Line {
  double constant, slope;
  double at(double x) const { return constant + slope * x; }
};

/// All that bounds (u, x) at one grid point.
struct Stage {
  std::vector<Line> lower, upper;
  double x_most = kInfinity;

  void clear() {
    lower.clear();
    upper.clear();
  }
  void add(const Row& row) {
    if (std::abs(row.a) < kTiny) {
      if (std::abs(row.b) > kTiny) x_most = std::min(x_most, row.m / std::abs(row.b));
      return;
    }
    const Line one{row.m / row.a, -row.b / row.a};
    const Line other{-row.m / row.a, -row.b / row.a};
    upper.push_back(row.a > 0.0 ? one : other);
    lower.push_back(row.a > 0.0 ? other : one);
  }
};

struct Interval {
  double least = 0.0, most = 0.0;
  bool isEmpty() const { return most < least; }
};

class Grid {
 public:
  Grid(const LimitedPath& path, const MotionLimits& limits, std::size_t points) : limits_(limits) {
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

  /// The same places of the path under other limits.
  Grid(const Grid& other, const MotionLimits& limits)
      : limits_(limits), dimensions_(other.dimensions_), s_(other.s_), first_(other.first_), second_(other.second_) {}

  /// At any s, from the places known: see useBetween().
  void derivatives(double s, std::span<double> first, std::span<double> second) const {
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

  std::size_t dimensions() const { return dimensions_; }
  std::size_t size() const { return s_.size(); }
  double step(std::size_t i) const { return s_[i + 1] - s_[i]; }
  const std::vector<double>& s() const { return s_; }

  /// Velocity bounds x; velocity and acceleration are bounded here, half way and at the end of the step that begins
  /// here: at a part w of the step x' = x + 2 w step u.
  void fill(std::size_t i, Stage& stage) const {
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

  /// Of x = (ds/dt)^2 at half step k.
  double speedBound(std::size_t k) const {
    double most = 1e12;
    for (std::size_t j = 0; j < dimensions_; ++j) {
      const double slope = std::abs(first_[k * dimensions_ + j]);
      if (slope > kTiny) most = std::min(most, (limits_.velocity[j] / slope) * (limits_.velocity[j] / slope));
    }
    return most;
  }

  /// Largest share of the limits on velocity and acceleration between the grid points, where these speeds are had at
  /// them. Within a step the path is a cubic, or nearly one: its first derivative is the parabola through the three
  /// places known, its second a line, so nothing is evaluated again.
  LimitUse useBetween(const std::vector<double>& speeds) const {
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

 private:
  /// Even steps, and the path's own breaks, where its bend kinks; a break takes the place of a step's end nearby.
  void layGrid(const LimitedPath& path, std::size_t points) {
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

  const MotionLimits& limits_;
  std::size_t dimensions_ = 0;
  std::vector<double> s_;
  std::vector<double> first_, second_;  ///< dq/ds and d2q/ds2 at every half step.
};

/// Upper minus lower envelope at x: as `slope` of the two lines that meet there, and how much room is between them.
struct Room {
  double room, slope;
};

Room roomAt(const Stage& stage, double x) {
  double high = kInfinity, low = -kInfinity, high_slope = 0.0, low_slope = 0.0;
  for (const Line& line : stage.upper) {
    const double u = line.at(x);
    const bool less = u < high;
    high = less ? u : high;
    high_slope = less ? line.slope : high_slope;
  }
  for (const Line& line : stage.lower) {
    const double u = line.at(x);
    const bool more = u > low;
    low = more ? u : low;
    low_slope = more ? line.slope : low_slope;
  }
  return {high - low, high_slope - low_slope};
}

/// The x for which some u lies between all lines. The room between them is concave in x, so that Newton's method from
/// outside comes to its zero in as many steps as lines are met on the way.
Interval feasible(const Stage& stage) {
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

void addNextSet(Stage& stage, const Interval& next, double step) {
  stage.upper.push_back({next.most / (2.0 * step), -1.0 / (2.0 * step)});
  stage.lower.push_back({next.least / (2.0 * step), -1.0 / (2.0 * step)});
}

/// Speeds at the grid points, or none where the start or the end speed cannot be had.
std::optional<std::vector<double>> reach(const Grid& grid, const TimingOptions& options) {
  const std::size_t n = grid.size();
  std::vector<Interval> sets(n);
  const double end = options.end_speed * options.end_speed;
  sets[n - 1] = {end, end};
  if (end > grid.speedBound(2 * (n - 1))) return std::nullopt;
  std::vector<Stage> stages(n);
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
    for (const Line& high : stages[i].upper) u = std::min(u, high.at(x));
    // Rounding may put x a hair outside; the next set is met all the same.
    x = std::clamp(x + 2.0 * grid.step(i) * u, sets[i + 1].least, std::max(sets[i + 1].least, sets[i + 1].most));
    speeds.push_back(std::sqrt(std::max(0.0, x)));
  }
  return speeds;
}

/// The largest use of the limits over some thousand steps of the motion's own time, whatever its scale, the
/// acceleration's growth taken over a step; steps begin at so many places within a step. `path`: a Grid or a path.
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

Expected<PathTiming> fastestOn(const Grid& grid, const TimingOptions& options) {
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

PathTiming::PathTiming(std::vector<double> s, std::vector<double> speed) : s_(std::move(s)), speed_(std::move(speed)) {
  HAPTICELL_DEMAND(s_.size() == speed_.size() && s_.size() >= 2);
  t_.reserve(s_.size());
  t_.push_back(0.0);
  integral_.push_back(0.0);
  for (std::size_t i = 1; i < s_.size(); ++i) {
    const double sum = std::max(speed_[i] + speed_[i - 1], 1e-9);
    const double dt = 2.0 * (s_[i] - s_[i - 1]) / sum;
    t_.push_back(t_.back() + dt);
    const double growth = (speed_[i] - speed_[i - 1]) / 6.0;  // acceleration * dt / 6
    integral_.push_back(integral_.back() +
                        static_cast<long double>(dt) * (s_[i - 1] + dt * (0.5 * speed_[i - 1] + growth)));
  }
}

PathTiming PathTiming::averaged(double window) const {
  PathTiming timing = *this;
  timing.window_ = window / stretch_;
  return timing;
}

PathTiming PathTiming::stretched(double factor) const {
  PathTiming timing = *this;
  timing.stretch_ *= factor;
  return timing;
}

PathTiming::State PathTiming::plainAt(double t) const {
  if (t <= 0.0) return {s_.front(), speed_.front(), 0.0};
  if (t >= t_.back()) return {s_.back(), speed_.back(), 0.0};
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const auto i = static_cast<std::size_t>(after - t_.begin()) - 1;
  const double dt = t_[i + 1] - t_[i];
  const double acceleration = (speed_[i + 1] - speed_[i]) / dt;
  const double tau = t - t_[i];
  return {std::min(s_[i + 1], s_[i] + (speed_[i] + 0.5 * acceleration * tau) * tau), speed_[i] + acceleration * tau,
          acceleration};
}

long double PathTiming::integralTo(double t) const {
  if (t <= 0.0) return static_cast<long double>(t) * s_.front();
  if (t >= t_.back()) return integral_.back() + static_cast<long double>(t - t_.back()) * s_.back();
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const auto i = static_cast<std::size_t>(after - t_.begin()) - 1;
  const double acceleration = (speed_[i + 1] - speed_[i]) / (t_[i + 1] - t_[i]);
  const long double tau = static_cast<long double>(t) - t_[i];
  return integral_[i] + tau * (s_[i] + tau * (0.5 * speed_[i] + tau * acceleration / 6.0));
}

PathTiming::State PathTiming::at(double t) const {
  t /= stretch_;
  State state = plainAt(t);
  if (window_ > 0.0) {
    const State before = plainAt(t - window_);
    const auto mean = static_cast<double>((integralTo(t) - integralTo(t - window_)) / window_);
    state = {std::clamp(mean, s_.front(), s_.back()), (state.s - before.s) / window_,
             (state.speed - before.speed) / window_};
    if (t <= 0.0) state.s = s_.front();
    if (t >= t_.back() + window_) state.s = s_.back();
  }
  return {state.s, state.speed / stretch_, state.acceleration / (stretch_ * stretch_)};
}

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
  return fastestOn(Grid(path, limits, std::max<std::size_t>(options.grid_points, 3)), options);
}

Expected<PathTiming> jerkLimited(const LimitedPath& path, const MotionLimits& limits, const TimingOptions& options) {
  HAPTICELL_TRY(checkPath(path, limits));
  const Grid grid(path, limits, std::max<std::size_t>(options.grid_points, 3));
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
    const auto base = slower == 1.0 ? fastest : fastestOn(Grid(grid, lower), options);
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
