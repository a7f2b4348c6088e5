// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/tcp_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptic/devices/device_care.h"
#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

TcpLinkOptions to(std::uint16_t port) {
  TcpLinkOptions options;
  options.port = port;
  options.retry_time = 0.02;
  return options;
}

/// Polls until a state fulfils the condition.
template <typename Condition>
bool eventuallyState(HapticLink& link, Condition&& condition) {
  return eventually([&] {
    const auto state = link.latestState();
    return state && condition(*state);
  });
}

TEST(TcpLink, ConnectsAndHearsTheDeviceStatesAndStatistics) {
  LiveServer server;
  TcpLink link(to(server.port()));
  ASSERT_TRUE(connects(link));
  EXPECT_TRUE(link.problem().empty());
  ASSERT_TRUE(link.device().has_value());
  EXPECT_EQ(link.device()->peak_force, 6.4);
  EXPECT_EQ(link.grantedKind(), ClientKind::kController);
  EXPECT_TRUE(eventuallyState(link, [](const HapticState& state) { return state.tick > 100; }));
  EXPECT_TRUE(eventually([&] {
    const auto statistics = link.latestStatistics();
    return statistics && statistics->round_trip_ms > 0.0;
  })) << "heart-beats come by themselves";
}

TEST(TcpLink, APressBetweenTwoLooksIsSeenOnce) {
  LiveServer server;
  TcpLink link(to(server.port()));
  ASSERT_TRUE(connects(link));
  TcpLinkOptions options = to(server.port());
  options.kind = ClientKind::kWatcher;
  TcpLink watcher(options);
  const auto watched = [&](std::uint32_t buttons) {
    return eventuallyState(watcher, [&](const HapticState& state) { return state.buttons == buttons; });
  };
  ASSERT_TRUE(eventuallyState(link, [](const HapticState& state) { return state.buttons == 0; }));
  // Pressed and let go while nobody looks.
  link.sendHandTarget({.holding = true, .buttons = 1});
  ASSERT_TRUE(watched(1));
  link.sendHandTarget({.holding = true, .buttons = 0});
  ASSERT_TRUE(watched(0));
  ASSERT_TRUE(watched(0));
  int pressed = 0;
  std::uint64_t first = 0;
  ASSERT_TRUE(eventuallyState(link, [&](const HapticState& state) {
    if (first == 0) first = state.tick;
    pressed += state.buttons == 1 ? 1 : 0;
    return state.tick > first + 200;
  }));
  EXPECT_EQ(pressed, 1);
}

TEST(TcpLink, HearsHowTheDeviceIsAndAsksForItsCalibration) {
  DeviceCare care;
  care.tell({.calibrated = false, .calibration = {"Put the stylus into its inkwell."}});
  LiveServer server({.care = &care});
  TcpLink link(to(server.port()));
  ASSERT_TRUE(eventually([&] { return link.condition().has_value(); }));
  EXPECT_FALSE(link.condition()->calibrated);
  EXPECT_EQ(link.condition()->calibration, std::vector<std::string>{"Put the stylus into its inkwell."});
  link.calibrate(0);
  std::optional<std::uint32_t> step;
  EXPECT_TRUE(eventually([&] { return (step = care.takeCalibration()).has_value(); }));
  EXPECT_EQ(step, 0u);
  care.tell({.answers = false, .sentence = "It was unplugged. Plug it in again."});
  EXPECT_TRUE(eventually([&] { return link.condition() && !link.condition()->answers; }));
  EXPECT_THAT(link.condition()->sentence, HasSubstr("unplugged"));

  // A watcher hears it too, and a client that did not ask neither hears of it nor may ask.
  TcpLinkOptions watching = to(server.port());
  watching.kind = ClientKind::kWatcher;
  TcpLink watcher(watching);
  EXPECT_TRUE(eventually([&] { return watcher.condition() && !watcher.condition()->answers; }));
  RawClient plain(server.port());
  ASSERT_TRUE(plain.hello(ClientKind::kWatcher).has_value());
  ASSERT_TRUE(plain.send(Calibrate{0}));
  const auto refusal = plain.receiveOf<Refusal>();
  ASSERT_TRUE(refusal.has_value());
  EXPECT_FALSE(care.takeCalibration().has_value());
}

TEST(TcpLink, ASessionOverTheSocketFeelsTheFloor) {
  LiveServer server;
  TcpLink link(to(server.port()));
  ASSERT_TRUE(connects(link));
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, 0.005)), 0});
  link.sendControl({.forces_enabled = true});
  link.sendSet(floorSet(1));
  ASSERT_TRUE(eventuallyState(link, [](const HapticState& s) { return s.force_ramp == 1.0 && s.adopted_set == 1; }));
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, -0.010)), 1});
  EXPECT_TRUE(eventuallyState(link, [](const HapticState& s) { return s.force_D.z > 2.0 && s.buttons == 1; }));
}

TEST(TcpLink, SaysWhatToDoWhenNoServerAnswers) {
  std::uint16_t unused = 0;
  {
    LiveServer server;
    unused = server.port();
  }
  TcpLink link(to(unused));
  EXPECT_TRUE(eventually([&] { return link.linkState() == LinkState::kDisconnected; }));
  EXPECT_EQ(english(link.problem()),
            "No haptic server answers at 127.0.0.1:" + std::to_string(unused) + ". Start hapticell-haptic-server.");
  EXPECT_FALSE(link.device().has_value());
  link.sendSet(floorSet(1));  // Dropped.
  EXPECT_FALSE(link.latestState().has_value());
}

TEST(TcpLink, ConnectsAgainWhenTheServerComesBack) {
  NetworkOptions options;
  auto server = std::make_unique<LiveServer>(options);
  options.port = server->port();
  TcpLink link(to(options.port));
  ASSERT_TRUE(connects(link));
  link.sendControl({.forces_enabled = true});
  server.reset();
  ASSERT_TRUE(eventually([&] { return link.linkState() != LinkState::kConnected; }));
  EXPECT_FALSE(link.problem().empty());
  server = std::make_unique<LiveServer>(options);
  ASSERT_TRUE(connects(link));
  EXPECT_EQ(link.connections(), 2u);
  link.sendSet(floorSet(1));
  EXPECT_TRUE(eventuallyState(link, [](const HapticState& s) { return s.adopted_set == 1 && !s.forces_on; }))
      << "forces must be enabled again";
}

TEST(TcpLink, ARefusedOneTellsTheServersSentenceAndGetsInWhenThereIsRoom) {
  LiveServer server;
  auto first = std::make_unique<TcpLink>(to(server.port()));
  ASSERT_TRUE(connects(*first));
  TcpLink second(to(server.port()));
  ASSERT_TRUE(eventually([&] { return second.linkState() == LinkState::kRefused; }));
  EXPECT_THAT(english(second.problem()), HasSubstr("controls the stylus"));
  first.reset();
  EXPECT_TRUE(connects(second));
}

TEST(TcpLink, WatchesWhereItMayNotControl) {
  LiveServer server;
  TcpLink first(to(server.port()));
  ASSERT_TRUE(connects(first));
  TcpLinkOptions options = to(server.port());
  options.accept_watching = true;
  TcpLink second(options);
  ASSERT_TRUE(connects(second));
  EXPECT_EQ(second.grantedKind(), ClientKind::kWatcher);
  EXPECT_TRUE(eventuallyState(second, [](const HapticState& s) { return s.tick > 0; }));
  first.sendSet(floorSet(7));
  EXPECT_TRUE(eventuallyState(second, [](const HapticState& s) { return s.adopted_set == 7; }));
}

TEST(TcpLink, TakesTheStylusOnlyByAWordOfItsUser) {
  LiveServer server({.takeover_time = 0.05});
  TcpLink first(to(server.port()));
  ASSERT_TRUE(connects(first));
  TcpLinkOptions options = to(server.port());
  options.accept_watching = true;
  TcpLink second(options);
  ASSERT_TRUE(connects(second));
  ASSERT_EQ(second.grantedKind(), ClientKind::kWatcher);
  second.takeOver();
  ASSERT_TRUE(eventually(
      [&] { return second.linkState() == LinkState::kConnected && second.grantedKind() == ClientKind::kController; }));
  EXPECT_TRUE(eventually([&] { return first.linkState() == LinkState::kRefused; }));
  EXPECT_THAT(english(first.problem()), HasSubstr("stylus"));
}

TEST(TcpLink, AWatcherThatTriesToControlStaysConnected) {
  LiveServer server;
  TcpLinkOptions options = to(server.port());
  options.kind = ClientKind::kWatcher;
  TcpLink link(options);
  ASSERT_TRUE(connects(link));
  link.sendSet(floorSet(7));
  link.sendControl({.forces_enabled = true});
  EXPECT_TRUE(eventuallyState(link, [](const HapticState& s) { return s.tick > 50; }));
  EXPECT_EQ(link.connections(), 1u) << "it does not send what it may not";
}

TEST(TcpLink, EndsAtOnceInAnyState) {
  LiveServer server;
  for (int i = 0; i < 20; ++i) {
    TcpLink link(to(server.port()));
    if (i % 2) link.sendSet(floorSet(1));
  }
  TcpLinkOptions nowhere = to(1);
  nowhere.host = "no.such.host.invalid";
  TcpLink link(nowhere);
  EXPECT_FALSE(link.problem().empty());
}

}  // namespace
}  // namespace hapticell::haptic
