// SPDX-License-Identifier: Apache-2.0
// Re-timing a path: the same places, passed as fast as the joints may go, or at one speed of the tool.
#include <trajectory/files/trajectory_io.h>
#include <trajectory/motion/trajectory.h>
#include <trajectory/timing/retiming.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

using hapticell::Pose;
namespace trajectory = hapticell::trajectory;

namespace {

/// A portal of two slides whose tool goes round half a circle of 200 mm: slow, and not even, as a hand has led it.
trajectory::Trajectory ledByHand() {
  trajectory::Trajectory led;
  led.name = "half circle";
  led.joint_names = {"slide_x", "slide_y"};
  for (int i = 0; i <= 100; ++i) {
    const double angle = std::numbers::pi * i / 100.0;
    const std::vector<double> joints{0.2 * std::cos(angle), 0.2 * std::sin(angle)};
    const double t = 0.08 * i + 0.2 * std::sin(0.3 * i);  // s
    led.addFrame({.t = t, .X_WT = Pose::translation({joints[0], joints[1], 0.0})}, joints);
  }
  return led;
}

int tell(const char* what, const hapticell::Expected<trajectory::Retimed>& made) {
  if (!made) {
    std::fprintf(stderr, "%s\n", made.error().message().c_str());
    return 1;
  }
  const trajectory::RetimingReport& report = made->report;
  std::printf("%-18s %6.2f s instead of %.2f s, %zu frames, off the path by at most %.3f mm\n", what,
              report.duration_after, report.duration_before, made->trajectory.size(),
              1e3 * report.max_deviation.position);
  return 0;
}

}  // namespace

int main() {
  const trajectory::Trajectory led = ledByHand();

  trajectory::RetimingOptions fast;
  fast.mode = trajectory::TimingMode::kTimeOptimal;
  fast.limits = {.velocity = {0.5, 0.5}, .acceleration = {2.0, 2.0}, .jerk = {}};  // m/s and m/s2 of the slides.
  const auto optimal = trajectory::retimed(led, fast);

  trajectory::RetimingOptions even;
  even.mode = trajectory::TimingMode::kConstantSpeed;
  even.speed = 0.1;  // m/s of the tool.
  const int failed = tell("as fast as can be", optimal) + tell("at 100 mm/s", trajectory::retimed(led, even));
  if (failed > 0) return 1;

  const trajectory::LimitUse& use = optimal->report.use;
  std::printf("of the limits: %.0f %% of the speed, %.0f %% of the acceleration\n", 100.0 * use.velocity,
              100.0 * use.acceleration);
  return 0;
}
