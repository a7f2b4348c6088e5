// SPDX-License-Identifier: Apache-2.0
// Random faults of device, client, network and server in real time, over real sockets. HAPTICELL_LIVE_FAULTS says how
// many (40); docs/dev/reliability.md has the figures of 500. What is asserted is read from the server's own log of
// ticks.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "haptic/client/tcp_link.h"
#include "tests/haptic/server/link_proxy.h"
#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

constexpr double kSlew = 1.0;  // N a millisecond.
constexpr double kRounding = 1e-9;

enum class Trouble { kNone, kGone, kNoNumber, kTeleports, kStuck };

/// The simulated stylus behind a cable, an electronics and a driver that fail at a word.
class FlakyDevice final : public Device {
 public:
  const DeviceCapabilities& capabilities() const override { return inner.capabilities(); }
  Expected<void> open() override { return inner.open(); }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    const DeviceStatus status = inner.read(reading);
    switch (trouble.load()) {
      case Trouble::kNone:
        last_ = reading.X_DS;
        return status;
      case Trouble::kGone:
        return DeviceStatus::kFault;
      case Trouble::kNoNumber:
        reading.X_DS.p.x = std::numeric_limits<double>::quiet_NaN();
        return status;
      case Trouble::kTeleports:
        reading.X_DS.p.x += (++reads_ / 5) % 2 == 0 ? 0.2 : -0.2;
        return status;
      case Trouble::kStuck:
        reading.X_DS = last_;
        return status;
    }
    return status;
  }
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override {
    return trouble.load() == Trouble::kGone ? DeviceStatus::kFault : inner.write(force_D, torque_D);
  }
  void close() noexcept override { inner.close(); }
  SimulatedDevice* simulated() noexcept override { return &inner; }

  SimulatedDevice inner;
  std::atomic<Trouble> trouble{Trouble::kNone};

 private:
  Pose last_;
  int reads_ = 0;
};

/// A server with that device; one life between two restarts.
class Station {
 public:
  explicit Station(std::uint16_t port) : loop_(opened(), clock_, options()), runner_(loop_, {false, false}) {
    NetworkOptions network;
    network.port = port;
    network.takeover_time = 0.1;
    auto started = NetworkServer::start(loop_, clock_, describe(device), network);
    if (!started) throw std::runtime_error(started.error().message());
    network_ = std::move(*started);
    runner_.start();
  }
  ~Station() { stop(); }
  void stop() {
    runner_.stop();
    network_.reset();
  }
  std::uint16_t port() const { return network_->port(); }
  /// After stop(): ticks with a force; every tick is within clamp and slew, but for a cut to nothing.
  int checkedTicksWithForce() const {
    int forced = 0;
    const TickLog& log = loop_.log();
    for (std::size_t i = 0; i < log.size(); ++i) {
      const dvec3 now = log.at(i).force_D;
      EXPECT_TRUE(std::isfinite(now.x + now.y + now.z));
      EXPECT_LE(glm::length(now), device.inner.profile().peak_force + kRounding);
      forced += glm::length(now) > 0.1 ? 1 : 0;
      if (i == 0) continue;
      // A tick that comes late may do what the ticks that it stands for might have done.
      const double milliseconds = 1e-6 * static_cast<double>(log.at(i).stamp_ns - log.at(i - 1).stamp_ns) + 1.0;
      const double step = glm::distance(now, log.at(i - 1).force_D);
      if (step > kSlew * std::clamp(milliseconds, 1.0, 21.0) + kRounding) {
        EXPECT_EQ(now, dvec3(0.0)) << "tick " << log.at(i).tick;
      }
    }
    return forced;
  }

  FlakyDevice device;

 private:
  Device& opened() {
    static_cast<void>(device.open());
    device.inner.place(Pose::translation(dvec3(0.0, 0.0, 0.005)));
    return device;
  }
  ForceLoopOptions options() const {
    ForceLoopOptions chosen = optionsFor(device);
    chosen.log_ticks = 400'000;
    chosen.safety.ramp_time = 0.1;
    return chosen;
  }
  RealClock clock_;
  ForceLoop loop_;
  RealTimeRunner runner_;
  std::unique_ptr<NetworkServer> network_;
};

struct LiveFaults : ::testing::Test {
  LiveFaults() : station(std::make_unique<Station>(0)), port(station->port()) { connect(port); }

  std::uint64_t draw(std::uint64_t count) { return random() % count; }
  void connect(std::uint16_t to) {
    TcpLinkOptions options;
    options.port = to;
    options.retry_time = 0.1;
    link = std::make_unique<TcpLink>(options);
  }
  static void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

  /// A client that does everything right while a hand presses, for so many steps of 10 ms.
  void press(int steps) {
    for (int i = 0; i < steps; ++i) {
      phase += 0.05;
      link->sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, -0.004 + 0.006 * std::sin(phase))), 0});
      link->sendControl({.forces_enabled = true});
      link->sendSet(floorSet(++sequence));
      wait(10);
    }
  }
  void faultOfDevice();
  void faultOfClient();
  void faultOfStrangers();
  void faultOfNetwork();
  void restart();
  bool forceComesBack();

  std::mt19937_64 random{20261122};
  std::unique_ptr<Station> station;
  std::uint16_t port;
  std::unique_ptr<TcpLink> link;
  std::vector<std::unique_ptr<RawClient>> half_open;
  std::uint64_t sequence = 0;
  double phase = 0.0;
  int forced = 0;
  std::vector<double> seconds_to_reconnect;
};

void LiveFaults::faultOfDevice() {
  constexpr Trouble kTroubles[] = {Trouble::kGone, Trouble::kNoNumber, Trouble::kTeleports, Trouble::kStuck};
  station->device.trouble = kTroubles[draw(4)];
  press(1 + static_cast<int>(draw(10)));
  station->device.trouble = Trouble::kNone;
  // What tripped stays off until the client takes its enable back.
  link->sendControl({.forces_enabled = false});
  wait(10);
}

void LiveFaults::faultOfClient() {
  switch (draw(4)) {
    case 0:  // Its loop hangs; its network thread lives.
      return wait(static_cast<int>(draw(900)));
    case 1:  // It is gone, and another comes.
      link.reset();
      wait(static_cast<int>(draw(200)));
      return connect(port);
    case 2: {  // Sets that no proper client would say.
      ConstraintSet set = floorSet(++sequence);
      set.constraints[0].gap = 1e-3 * static_cast<double>(draw(100)) - 0.05;
      set.constraints[0].stiffness = draw(2) == 0 ? 1e12 : std::numeric_limits<double>::quiet_NaN();
      set.zone_radius = draw(2) == 0 ? std::numeric_limits<double>::infinity() : 1e-9;
      link->sendSet(set);
      return press(3);
    }
    default: {  // Doubled, out of order, from the future.
      ConstraintSet set = floorSet(draw(sequence + 2));
      set.stamp_ns = static_cast<std::int64_t>(random());
      link->sendSet(set);
      link->sendSet(set);
      return press(3);
    }
  }
}

void LiveFaults::faultOfStrangers() {
  switch (draw(3)) {
    case 0: {
      RawClient stranger(port);
      std::string bytes(1 + draw(4000), '\0');
      for (char& byte : bytes) byte = static_cast<char>(random());
      stranger.sendBytes(bytes);
      return press(3);
    }
    case 1:  // Connections that never say a word.
      if (half_open.size() > 8) half_open.clear();
      half_open.push_back(std::make_unique<RawClient>(port));
      return press(3);
    default: {  // Another who wants to control while this one does.
      press(20);
      RawClient second(port);
      const auto answer = second.hello(ClientKind::kController);
      EXPECT_TRUE(!answer || !std::holds_alternative<Welcome>(*answer) || link->linkState() != LinkState::kConnected)
          << "two clients may not both control";
      return;
    }
  }
}

void LiveFaults::faultOfNetwork() {
  link.reset();
  LinkProxy relay(port,
                  {1e-3 * static_cast<double>(draw(30)), 0.01, 0.01, 0.05, static_cast<std::uint32_t>(draw(1000))});
  connect(relay.port());
  press(30);
  link.reset();  // With what was under way.
  connect(port);
}

void LiveFaults::restart() {
  const std::uint64_t before = link->connections();
  half_open.clear();
  station->stop();
  forced += station->checkedTicksWithForce();
  station.reset();
  EXPECT_TRUE(eventually([&] { return link->linkState() != LinkState::kConnected; }));
  EXPECT_FALSE(link->problem().empty()) << "the user is told";
  station = std::make_unique<Station>(port);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually([&] { return link->connections() > before && link->linkState() == LinkState::kConnected; }));
  seconds_to_reconnect.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  for (int i = 0; i < 10; ++i) {
    wait(10);
    if (const auto state = link->latestState()) {
      EXPECT_EQ(state->force_D, dvec3(0.0)) << "nobody enabled it";
    }
  }
}

bool LiveFaults::forceComesBack() {
  link->sendControl({.forces_enabled = false});
  wait(50);
  return eventually([&] {
    press(10);
    const auto state = link->latestState();
    return state && glm::length(state->force_D) > 0.3;
  });
}

TEST_F(LiveFaults, KeepClampAndSlewAndTheForceComesBack) {
  const char* const asked = std::getenv("HAPTICELL_LIVE_FAULTS");
  const int faults = asked ? std::max(1, std::atoi(asked)) : 40;
  for (int i = 0; i < faults && !HasFatalFailure(); ++i) {
    press(10);
    const std::uint64_t kind = draw(20);
    if (kind < 7) {
      faultOfDevice();
    } else if (kind < 12) {
      faultOfClient();
    } else if (kind < 16) {
      faultOfStrangers();
    } else if (kind < 18) {
      faultOfNetwork();
    } else {
      restart();
    }
    if (i % 10 == 9) {
      EXPECT_TRUE(forceComesBack()) << "after fault " << i;
    }
  }
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(forceComesBack());
  station->stop();
  forced += station->checkedTicksWithForce();
  EXPECT_GT(forced, 10 * faults) << "forces acted while it went on";
  std::sort(seconds_to_reconnect.begin(), seconds_to_reconnect.end());
  if (!seconds_to_reconnect.empty()) {
    RecordProperty("seconds_to_reconnect_at_most", std::to_string(seconds_to_reconnect.back()));
    std::printf("%d faults, %zu restarts, connected again after %.3f s in the middle, %.3f s at most\n", faults,
                seconds_to_reconnect.size(), seconds_to_reconnect[seconds_to_reconnect.size() / 2],
                seconds_to_reconnect.back());
  }
}

}  // namespace
}  // namespace hapticell::haptic
