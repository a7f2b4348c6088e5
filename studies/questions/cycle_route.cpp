// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/cycle_route.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trajectory/timing/straight_timing.h"

namespace hapticell::studies {

namespace {

using manipulation::FreeAnswer;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Times of the best ways to each solution of one target, and from which solution of the target before.
struct Stage {
  std::vector<double> time;
  std::vector<std::size_t> before;
};

Stage firstStage(const JointRates& rates, const std::vector<double>& start, const FreeAnswer& target) {
  Stage stage;
  for (const auto& solution : target.free) stage.time.push_back(straightTime(rates, start, solution.joints));
  stage.before.resize(stage.time.size());
  return stage;
}

Stage nextStage(const JointRates& rates, const FreeAnswer& from, const Stage& known, const FreeAnswer& to) {
  Stage stage;
  for (const auto& solution : to.free) {
    double least = kNever;
    std::size_t before = 0;
    for (std::size_t i = 0; i < from.free.size(); ++i) {
      const double time = known.time[i] + straightTime(rates, from.free[i].joints, solution.joints);
      if (time < least) {
        least = time;
        before = i;
      }
    }
    stage.time.push_back(least);
    stage.before.push_back(before);
  }
  return stage;
}

}  // namespace

JointRates jointRates(const kinematics::RobotModel& model, double time_to_speed) {
  JointRates rates;
  for (const int joint : model.moving) {
    rates.speed.push_back(kinematics::greatestSpeed(model.joints[static_cast<std::size_t>(joint)]));
    rates.acceleration.push_back(rates.speed.back() / time_to_speed);
  }
  return rates;
}

double straightTime(const JointRates& rates, const std::vector<double>& from, const std::vector<double>& to) {
  // Along the way from 0 to 1 the slowest joint decides, as no joint is then faster than it may be.
  double speed = kNever, acceleration = kNever;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double way = std::abs(to[i] - from[i]);
    if (way == 0.0) continue;
    speed = std::min(speed, rates.speed[i] / way);
    acceleration = std::min(acceleration, rates.acceleration[i] / way);
  }
  return speed == kNever ? 0.0 : trajectory::StraightTiming(1.0, speed, acceleration).duration();
}

CycleRoute fastestRoute(const JointRates& rates, const std::vector<double>& start,
                        const std::vector<FreeAnswer>& targets, bool returns) {
  CycleRoute route;
  if (targets.empty() || !std::all_of(targets.begin(), targets.end(), [](const auto& t) { return t.isFree(); }))
    return route;
  std::vector<Stage> stages{firstStage(rates, start, targets.front())};
  for (std::size_t k = 1; k < targets.size(); ++k)
    stages.push_back(nextStage(rates, targets[k - 1], stages.back(), targets[k]));
  std::vector<double> last = stages.back().time;
  for (std::size_t i = 0; returns && i < last.size(); ++i)
    last[i] += straightTime(rates, targets.back().free[i].joints, start);
  auto at = static_cast<std::size_t>(std::min_element(last.begin(), last.end()) - last.begin());
  route.time_s = last[at];
  route.stops.resize(targets.size());
  for (std::size_t k = targets.size(); k-- > 0;) {
    route.stops[k] = &targets[k].free[at];
    at = stages[k].before[at];
  }
  for (std::size_t k = 1; k < route.stops.size(); ++k)
    route.changes += route.stops[k]->configuration != route.stops[k - 1]->configuration ? 1 : 0;
  return route;
}

}  // namespace hapticell::studies
