// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/heartbeat.h"

#include <gtest/gtest.h>

#include <limits>

namespace hapticell::haptic {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

/// Client and server whose clocks differ by `shift`, joined by a network of fixed delays; one exchange each call.
struct Exchange {
  std::int64_t shift;  // Server's clock minus client's.
  std::int64_t to_server, to_client;
  std::int64_t now = 5'000 * kMillisecond;  // Client's clock.
  HeartbeatExchange client, server;

  void run() {
    const Heartbeat up = client.next(now);
    now += to_server;
    server.heard(up, now + shift);
    const Heartbeat down = server.next(now + shift);
    now += to_client;
    client.heard(down, now);
    now += 100 * kMillisecond;
  }
};

TEST(Heartbeat, BothSidesLearnTheRoundTrip) {
  Exchange exchange{
      .shift = 0, .to_server = 3 * kMillisecond, .to_client = 2 * kMillisecond, .client = {}, .server = {}};
  exchange.run();
  EXPECT_NEAR(exchange.client.roundTrip(), 0.005, 1e-12);
  EXPECT_EQ(exchange.server.roundTrip(), 0.0);
  exchange.run();
  EXPECT_NEAR(exchange.server.roundTrip(), 0.005, 1e-12) << "the client's 100 ms of waiting do not count";
}

TEST(Heartbeat, TheOtherClockIsLearntExactlyWhenBothWaysTakeTheSameTime) {
  const std::int64_t shift =
      -3'600'000 * kMillisecond;  // The server booted an hour later; its stamps would be negative.
  Exchange exchange{.shift = -shift, .to_server = kMillisecond, .to_client = kMillisecond, .client = {}, .server = {}};
  exchange.run();
  exchange.run();
  ASSERT_TRUE(exchange.server.fromPeerClock().has_value());
  EXPECT_EQ(*exchange.server.fromPeerClock(), -shift);
  EXPECT_EQ(*exchange.client.fromPeerClock(), shift);
}

TEST(Heartbeat, ASlowExchangeDoesNotSpoilWhatAQuickOneTold) {
  Exchange exchange{.shift = 0, .to_server = kMillisecond, .to_client = kMillisecond, .client = {}, .server = {}};
  exchange.run();
  exchange.run();
  exchange.to_server = 80 * kMillisecond;
  exchange.run();
  EXPECT_NEAR(exchange.client.roundTrip(), 0.081, 1e-12);
  EXPECT_EQ(*exchange.client.fromPeerClock(), 0) << "the lopsided one would say 39.5 ms";
}

TEST(Heartbeat, StampsThatMakeNoSenseAreIgnored) {
  const std::int64_t least = std::numeric_limits<std::int64_t>::min(), most = std::numeric_limits<std::int64_t>::max();
  const std::int64_t now = 5'000 * kMillisecond;
  for (const std::int64_t echo : {least, std::int64_t{-1}, std::int64_t{0}, now + 1, most}) {
    for (const std::int64_t held : {least, std::int64_t{-1}, std::int64_t{0}, most}) {
      HeartbeatExchange exchange;
      exchange.heard({.sent_ns = most, .echo_ns = echo, .held_ns = held}, now);
      EXPECT_EQ(exchange.roundTrip(), 0.0);
      EXPECT_FALSE(exchange.fromPeerClock().has_value());
    }
  }
}

}  // namespace
}  // namespace hapticell::haptic
