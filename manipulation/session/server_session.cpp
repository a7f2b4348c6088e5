// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/server_session.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>
#include <utility>

#include "haptic/client/tcp_link.h"
#include "manipulation/session/watched_engine.h"

namespace hapticell::manipulation {

namespace {

using ServerClock = std::chrono::steady_clock;

/// s for a server to answer: it starts in well under one. Half: a busy machine fails; twice: slower to report that none
/// is there.
constexpr double kPatience = 5.0;
double secondsOnServerSince(ServerClock::time_point begin) {
  return std::chrono::duration<double>(ServerClock::now() - begin).count();
}

haptic::MetricVector commandOf(const haptic::HapticState& state) {
  return {state.force_D, state.torque_D / haptic::kRotationLever};
}

/// Turning that costs no torque is no work, so that it may be counted where none is driven, too.
haptic::MetricVector wayBetween(const haptic::HapticState& state, const haptic::HapticState& before) {
  return haptic::metricVector(haptic::metricDifference(state.X_DS, before.X_DS));
}

/// Waits until the server has answered and its device can be held.
Expected<haptic::DeviceDescription> awaitServer(haptic::TcpLink& link, const std::string& address) {
  const ServerClock::time_point begin = ServerClock::now();
  while (link.linkState() != haptic::LinkState::kConnected || !link.device()) {
    const bool refused = link.linkState() == haptic::LinkState::kRefused;
    if (refused || secondsOnServerSince(begin) > kPatience) {
      return makeError({.file = address,
                        .found = link.problem().empty() ? Text("no answer") : wholeText(link.problem()),
                        .expected = "a haptic server",
                        .fix = "Start hapticell-haptic-server."});
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const haptic::DeviceDescription device = *link.device();
  if (device.simulated) return device;
  return makeError(
      {.file = address, .found = Text("'%1' is real hardware", device.name), .expected = "a simulated device"});
}

/// s for the state that shows that the server lived to the end, over TcpLink's 1 s. Half: as long as that; twice:
/// slower to fail.
constexpr double kLastPatience = 2.0;

/// A session is one connection from its beginning to its end: what a server does that was lost and found again, and who
/// held its stylus meanwhile, is not known.
class WatchedLink {
 public:
  WatchedLink(haptic::TcpLink& link, std::string address)
      : link_(link), address_(std::move(address)), connection_(link.connections()) {}

  Expected<void> check(double t) const {
    if (link_.linkState() != haptic::LinkState::kConnected) return lost(t, wholeText(link_.problem()));
    if (link_.connections() != connection_) return lost(t, Text("the connection was interrupted"));
    return {};
  }

  /// After the hand path: that the server is still there. A server that hangs is silent at first.
  Expected<void> checkEnd(double t) {
    static_cast<void>(link_.latestState());  // May have been waiting.
    const ServerClock::time_point begin = ServerClock::now();
    while (!link_.latestState()) {
      if (auto there = check(t); !there) return there;
      if (secondsOnServerSince(begin) > kLastPatience)
        return lost(t, Text("the server stopped sending the state of the stylus"));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return check(t);
  }

 private:
  Expected<void> lost(double t, const Text& why) const {
    char when[32];
    std::snprintf(when, sizeof when, "%.2f", t);
    const std::string seconds = when;
    return makeError({.file = address_,
                      .found = why.empty() ? Text("the haptic server was lost after %1 s", seconds)
                                           : Text("the haptic server was lost after %1 s: %2", seconds, why),
                      .expected = "a server that answers until the hand path ends",
                      .fix = "Nothing was written. Check the messages of the server, then run the session again."});
  }

  haptic::TcpLink& link_;
  std::string address_;
  std::uint64_t connection_;
};

}  // namespace

Expected<SessionReport> runSessionOnServer(const SessionOptions& options, const std::string& host, int port,
                                           const TraceSink& trace) {
  auto link_options = haptic::linkOptionsFor(host, static_cast<std::uint16_t>(port));
  HAPTICELL_TRY(link_options);
  link_options->program = "hapticell-cli session";
  haptic::TcpLink link(*link_options);
  const auto device = awaitServer(link, host + ":" + std::to_string(port));
  HAPTICELL_TRY(device);
  WatchedLink watched(link, host + ":" + std::to_string(port));
  WatchedEngine engine(link, options);
  engine.searchInThread();
  HAPTICELL_TRY(engine.prepare());

  const double stiffness = device->stiffness > 0.0 ? device->stiffness : 1000.0;
  const double step_period = 1.0 / std::clamp(options.configuration.manipulation.rate_hz, 10.0, 1000.0);
  const double picture_period = 1.0 / std::clamp(options.rate_gui_hz, 1.0, 1000.0);
  const ServerClock::time_point begin = ServerClock::now();
  std::optional<haptic::HapticState> first, last;
  double next_picture = 0.0;
  for (double t = 0.0; t < options.hand.duration(); t = secondsOnServerSince(begin)) {
    const haptic::HandSample sample = options.hand.at(t);
    HAPTICELL_TRY(watched.check(t));
    link.sendHandTarget({true, sample.X_DH, sample.buttons});
    const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(ServerClock::now().time_since_epoch());
    engine.step(t, now.count());
    if (const auto& state = engine.state(); state && (!last || state->tick != last->tick)) {
      if (!first) first = state;
      engine.count({1e-9 * static_cast<double>(state->server_stamp_ns), state->force_D, commandOf(*state),
                    wayBetween(*state, last.value_or(*state)), stiffness});
      last = state;
      if (trace) {
        trace({t, state->X_DS, state->X_DP, state->force_D, state->torque_D, state->buttons, engine.inContact(),
               engine.movedFrame()});
      }
    }
    if (t >= next_picture) {
      engine.showPicture(t);
      next_picture = t + picture_period;
    }
    std::this_thread::sleep_until(
        begin + std::chrono::duration_cast<ServerClock::duration>(std::chrono::duration<double>(t + step_period)));
  }
  HAPTICELL_TRY(watched.checkEnd(options.hand.duration()));
  SessionReport report = engine.finish(options.hand.duration());
  const haptic::ServerStatistics& server = engine.serverStatistics();
  report.ticks = first && last ? last->tick - first->tick + 1 : 0;
  report.ticks_missed = server.missed_ticks;
  report.rate_haptic_hz = server.rate_hz;
  report.delays.latency_p50_ms = server.set_age_p50_ms;
  report.delays.latency_p99_ms = server.set_age_p99_ms;
  report.machine_time_s = secondsOnServerSince(begin);
  link.sendHandTarget({false, {}, 0});
  return report;
}

}  // namespace hapticell::manipulation
