// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "geometry/system/percentile.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/force_loop.h"
#include "haptic/server/in_memory_link.h"
#include "manipulation/session/watched_engine.h"

namespace hapticell::manipulation {

namespace {

using SteadyClock = std::chrono::steady_clock;

/// s of a live hand: a day. Half: a shift and a half; twice: memory for a trace of nobody's use.
constexpr double kLongestHand = 86400.0;

double secondsSince(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

haptic::HandSample handAt(const SessionOptions& options, double t, const haptic::HapticState& felt) {
  return options.live_hand ? options.live_hand->at(t, felt) : options.hand.at(t);
}

}  // namespace

Expected<SessionReport> runSession(const SessionOptions& options, const TraceSink& trace) {
  if (options.live_hand && !(options.live_hand->duration_s > 0.0 && options.live_hand->duration_s < kLongestHand)) {
    return makeError(
        {.place = "duration", .found = "a duration out of range", .expected = "seconds above 0, 24 h at most"});
  }
  const SteadyClock::time_point begin = SteadyClock::now();
  haptic::VirtualClock clock;
  haptic::SimulatedDevice device(options.device);
  device.hand().setOptions(haptic::configuredHand(options.configuration));
  HAPTICELL_TRY(device.open());
  device.place(handAt(options, 0.0, {}).X_DH);
  haptic::ForceLoop loop(device, clock, haptic::configuredLoop(device, options.configuration));
  haptic::InMemoryLink link(loop, clock, haptic::describe(device), {.latency = options.latency_s});
  WatchedEngine engine(link, options);
  HAPTICELL_TRY(engine.prepare());

  const double period = loop.period();
  const double duration = options.live_hand ? options.live_hand->duration_s : options.hand.duration();
  const double step_period = 1.0 / std::clamp(options.configuration.manipulation.rate_hz, 10.0, 1000.0);
  const double picture_period = 1.0 / std::clamp(options.rate_gui_hz, 1.0, 1000.0);
  const auto ticks = static_cast<std::uint64_t>(std::ceil(duration / period - 1e-9));
  std::uint64_t steps = 0, pictures = 0, adopted = 0;
  std::vector<double> latencies;
  Pose X_DSBefore = device.truePose();
  std::optional<StraightHand> straight;
  if (options.straight_hand) straight.emplace(*options.straight_hand);
  double ended = 0.0;
  for (std::uint64_t tick = 0; tick <= ticks; ++tick) {
    const double t = static_cast<double>(tick) * period;
    if (straight && engine.isSolved(t)) break;
    ended = t;
    const haptic::HandSample sample =
        straight ? straight->next(t, X_DSBefore, engine.movedFrame()) : handAt(options, t, loop.current());
    device.hand().hold(sample.X_DH, sample.buttons);
    link.step();
    const haptic::HapticState& state = loop.current();
    const haptic::MetricVector carried{period * loop.lastRender().v_DO, dvec3(0.0)};
    engine.count({t, state.force_D, loop.renderer().applied(), loop.renderer().way(state.X_DS, X_DSBefore) - carried,
                  loop.lastRender().stiffness, loop.lastRender().load_D});
    X_DSBefore = state.X_DS;
    if (state.adopted_set != adopted) {
      adopted = state.adopted_set;
      if (const double sent = engine.sentAt(adopted); sent >= 0.0) latencies.push_back(1e3 * (t - sent));
    }
    if (t + 1e-9 >= static_cast<double>(steps) * step_period) {
      engine.step(t, clock.now());
      ++steps;
    }
    if (t + 1e-9 >= static_cast<double>(pictures) * picture_period) {
      engine.showPicture(t);
      ++pictures;
    }
    if (trace) {
      trace({t, state.X_DS, state.X_DP, state.force_D, state.torque_D, state.buttons, engine.inContact(),
             engine.movedFrame(), loop.lastRender().load_D});
    }
  }
  SessionReport report = engine.finish(ended);
  report.ticks = static_cast<std::uint64_t>(std::lround(ended / period)) + 1;
  report.rate_haptic_hz = 1.0 / period;
  report.delays.latency_p50_ms = percentile(latencies, 0.5);
  report.delays.latency_p99_ms = percentile(latencies, 0.99);
  report.machine_time_s = secondsSince(begin);
  return report;
}

}  // namespace hapticell::manipulation
