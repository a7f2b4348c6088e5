// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/network_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

template <typename T>
bool is(const std::optional<Message>& message) {
  return message && std::holds_alternative<T>(*message);
}

/// The server still serves: states go on, and a set of the controller is adopted.
void expectServing(RawClient& controller, std::uint64_t sequence) {
  ASSERT_TRUE(controller.send(floorSet(sequence)));
  while (true) {
    const auto state = controller.receiveOf<HapticState>();
    ASSERT_TRUE(state.has_value());
    if (state->adopted_set == sequence) return;
  }
}

TEST(NetworkServer, WelcomesAControllerAndTellsItTheDevice) {
  LiveServer server;
  RawClient client(server.port());
  const auto answer = client.hello();
  ASSERT_TRUE(is<Welcome>(answer));
  const auto& welcome = std::get<Welcome>(*answer);
  EXPECT_EQ(welcome.protocol_version, kProtocolVersion);
  EXPECT_EQ(welcome.kind, ClientKind::kController);
  EXPECT_EQ(welcome.tick_rate_hz, 1000.0);
  EXPECT_EQ(welcome.device.peak_force, 6.4);
  EXPECT_TRUE(welcome.device.simulated);
  expectServing(client, 1);
  const auto statistics = client.receiveOf<ServerStatistics>();
  ASSERT_TRUE(statistics.has_value());
  EXPECT_GT(statistics->ticks, 0u);
}

TEST(NetworkServer, StatesComeInOrderAndNeverTwice) {
  LiveServer server;
  RawClient client(server.port());
  ASSERT_TRUE(is<Welcome>(client.hello(ClientKind::kWatcher)));
  std::uint64_t last = 0;
  for (int i = 0; i < 60; ++i) {
    const auto state = client.receiveOf<HapticState>();
    ASSERT_TRUE(state.has_value());
    EXPECT_GT(state->tick, last);
    last = state->tick;
  }
}

/// Counted in the server's ticks, a thousand a second: how fast the machine is does not matter.
TEST(NetworkServer, AStylusThatLiesStillWithoutForcesIsToldOfSeldomAndAtOnceWhenItMoves) {
  LiveServer server;
  RawClient client(server.port());
  ASSERT_TRUE(is<Welcome>(client.hello()));
  ASSERT_TRUE(client.send(Message(HandTarget{true, Pose::translation(dvec3(0.0, 0.0, 0.005)), 0})));
  int seldom = 0;  // In a row.
  std::optional<HapticState> state = client.receiveOf<HapticState>();
  for (int i = 0; i < 2000 && seldom < 5; ++i) {
    const auto next = client.receiveOf<HapticState>();
    ASSERT_TRUE(next.has_value());
    seldom = next->tick - state->tick >= 30 ? seldom + 1 : 0;
    state = next;
  }
  EXPECT_EQ(seldom, 5);
  ASSERT_TRUE(client.send(Message(HandTarget{true, Pose::translation(dvec3(0.0, 0.0, -0.02)), 1})));
  dvec3 before = state->X_DS.p;
  double longest = 0.0;  // Way between two states.
  while (state->X_DS.p.z > -0.015) {
    state = client.receiveOf<HapticState>();
    ASSERT_TRUE(state.has_value());
    longest = std::max(longest, glm::length(state->X_DS.p - before));
    before = state->X_DS.p;
  }
  EXPECT_GT(longest, 0.0);
  EXPECT_EQ(state->buttons, 1u);
}

TEST(NetworkServer, AnswersHeartbeatsWithTheStampItHeard) {
  LiveServer server;
  RawClient client(server.port());
  ASSERT_TRUE(is<Welcome>(client.hello()));
  ASSERT_TRUE(client.send(Heartbeat{.sent_ns = 4711, .echo_ns = 0, .held_ns = 0}));
  const auto answer = client.receiveOf<Heartbeat>();
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->echo_ns, 4711);
  ASSERT_TRUE(client.send(Heartbeat{.sent_ns = 4712, .echo_ns = answer->sent_ns, .held_ns = 0}));
  while (true) {
    const auto statistics = client.receiveOf<ServerStatistics>();
    ASSERT_TRUE(statistics.has_value());
    if (statistics->round_trip_ms > 0.0) break;
    ASSERT_TRUE(client.send(Heartbeat{.sent_ns = 4713, .echo_ns = 0, .held_ns = 0}));
  }
}

struct BadInput {
  const char* name;
  std::string bytes;
  const char* sentence;
};

std::vector<BadInput> badInputs() {
  ConstraintSet not_a_number = floorSet(1);
  not_a_number.constraints[0].gap = std::numeric_limits<double>::quiet_NaN();
  const std::string hello = frameText(Hello{.kind = ClientKind::kWatcher});
  std::string bent = frameText(Hello{});
  for (std::size_t i = 12; i < 20; ++i) bent[i] = '\xff';
  const std::string old_version = frameText(Hello{.protocol_version = kProtocolVersion + 1});
  return {{"garbage", "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n", "frame length"},
          {"oversized", std::string("\x01\x00\x01\x00", 4) + std::string(100, 'x'), "frame length"},
          {"huge", std::string("\xff\xff\xff\xff", 4), "frame length"},
          {"empty frame", std::string(4, '\0'), "frame length"},
          {"no FlatBuffer", std::string("\x20\x00\x00\x00", 4) + std::string(32, 'x'), "HCEL"},
          {"bent FlatBuffer", bent, "Not understood"},
          {"another version", old_version, "version"},
          {"no hello", frameText(Heartbeat{1, 2, 3}), "must be a Hello"},
          {"hello twice", hello + hello, "only constraint sets"},
          {"a server's message", hello + frameText(HapticState{}), "only constraint sets"},
          {"a watcher that controls", hello + frameText(HapticControl{.forces_enabled = true}), "watcher"},
          {"a watcher that sends sets", hello + frameText(floorSet(3)), "watcher"},
          {"not a number", hello + frameText(not_a_number), "finite"}};
}

TEST(NetworkServer, BadInputIsRefusedWithASentenceAndTheServerGoesOn) {
  LiveServer server;
  RawClient good(server.port());
  ASSERT_TRUE(is<Welcome>(good.hello()));
  std::uint64_t sequence = 0;
  for (const BadInput& bad : badInputs()) {
    SCOPED_TRACE(bad.name);
    RawClient client(server.port());
    ASSERT_TRUE(client.sendBytes(bad.bytes));
    EXPECT_THAT(client.refusalThenEnd(), HasSubstr(bad.sentence));
    expectServing(good, ++sequence);
  }
}

TEST(NetworkServer, BadInputCutAnywhereAndThenTheEndDoesNoHarm) {
  LiveServer server;
  RawClient good(server.port());
  ASSERT_TRUE(is<Welcome>(good.hello()));
  const std::string bytes = frameText(Hello{.kind = ClientKind::kWatcher}) + frameText(floorSet(1));
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    RawClient client(server.port());
    client.sendBytes(std::string_view(bytes).substr(0, length));
  }
  expectServing(good, 1);
}

TEST(NetworkServer, AControllerThatTurnsToGarbageLosesControlAtOnce) {
  LiveServer server;
  RawClient bad(server.port());
  ASSERT_TRUE(is<Welcome>(bad.hello()));
  ASSERT_TRUE(bad.sendBytes("garbage that is long enough to be read as a length"));
  EXPECT_THAT(bad.refusalThenEnd(), HasSubstr("Not understood"));
  RawClient next(server.port());
  EXPECT_TRUE(is<Welcome>(next.hello()));
}

TEST(NetworkServer, AClientThatSaysHelloTooSlowlyIsRefused) {
  LiveServer server({.hello_time = 0.2});
  RawClient slow(server.port());
  ASSERT_TRUE(slow.sendBytes(frameText(Hello{}).substr(0, 9)));
  EXPECT_THAT(slow.refusalThenEnd(), HasSubstr("No Hello"));
}

TEST(NetworkServer, AMessageMayComeByteByByte) {
  LiveServer server;
  RawClient client(server.port());
  for (const char byte : frameText(Hello{})) ASSERT_TRUE(client.sendBytes(std::string_view(&byte, 1)));
  EXPECT_TRUE(is<Welcome>(client.receive()));
}

TEST(NetworkServer, ASecondControllerIsRefusedOrWatchesAsItAsked) {
  LiveServer server;
  RawClient first(server.port());
  ASSERT_TRUE(is<Welcome>(first.hello(ClientKind::kController, false, "first program")));
  RawClient second(server.port());
  const auto refusal = second.hello();
  ASSERT_TRUE(is<Refusal>(refusal));
  EXPECT_THAT(std::get<Refusal>(*refusal).sentence, HasSubstr("first program"));
  EXPECT_EQ(second.refusalThenEnd(), "");
  RawClient third(server.port());
  const auto watching = third.hello(ClientKind::kController, true);
  ASSERT_TRUE(is<Welcome>(watching));
  EXPECT_EQ(std::get<Welcome>(*watching).kind, ClientKind::kWatcher);
  first.close();
  EXPECT_TRUE(eventually([&] {
    RawClient next(server.port());
    return is<Welcome>(next.hello());
  }));
}

TEST(NetworkServer, AControllerThatFellSilentMakesRoomForAnother) {
  LiveServer server({.takeover_time = 0.05});
  RawClient silent(server.port());
  ASSERT_TRUE(is<Welcome>(silent.hello()));
  EXPECT_TRUE(eventually([&] {
    RawClient next(server.port());
    return is<Welcome>(next.hello());
  }));
  EXPECT_THAT(silent.refusalThenEnd(), HasSubstr("Silent for too long"));
}

TEST(NetworkServer, AClientThatIsSilentForLongIsGivenUp) {
  LiveServer server({.silence_time = 0.2});
  RawClient silent(server.port());
  ASSERT_TRUE(is<Welcome>(silent.hello()));
  EXPECT_EQ(silent.refusalThenEnd(), "");
  EXPECT_TRUE(eventually([&] { return server.reported("was silent for too long"); }));
}

TEST(NetworkServer, ConnectionsAreLimitedAndFreeAgainWhenClosed) {
  LiveServer server({.max_clients = 3});
  RawClient one(server.port()), two(server.port()), three(server.port());
  for (RawClient* client : {&one, &two, &three}) ASSERT_TRUE(is<Welcome>(client->hello(ClientKind::kWatcher)));
  RawClient four(server.port());
  ASSERT_TRUE(four.send(Hello{.kind = ClientKind::kWatcher}));
  EXPECT_THAT(four.refusalThenEnd(), HasSubstr("3 connections"));
  two.close();
  EXPECT_TRUE(eventually([&] {
    RawClient again(server.port());
    return is<Welcome>(again.hello(ClientKind::kWatcher));
  }));
}

TEST(NetworkServer, AWatcherThatNeverReadsHoldsNobodyUp) {
  LiveServer server;
  RawClient lazy(server.port());
  ASSERT_TRUE(lazy.send(Hello{.kind = ClientKind::kWatcher}));
  RawClient good(server.port());
  ASSERT_TRUE(is<Welcome>(good.hello()));
  for (std::uint64_t sequence = 1; sequence <= 100; ++sequence) expectServing(good, sequence);
}

TEST(NetworkServer, TheNewestOfManySetsWins) {
  LiveServer server;
  RawClient client(server.port());
  ASSERT_TRUE(is<Welcome>(client.hello()));
  for (std::uint64_t sequence = 1; sequence <= 500; ++sequence) ASSERT_TRUE(client.send(floorSet(sequence)));
  expectServing(client, 501);
}

Expected<std::unique_ptr<NetworkServer>> tryToListen(LiveServer& other, const NetworkOptions& options) {
  return NetworkServer::start(other.loop, other.clock, describe(other.device), options);
}

TEST(NetworkServer, ListensBeyondThisMachineOnlyWithAKey) {
  LiveServer server;
  const auto open = tryToListen(server, {.address = "0.0.0.0", .port = 0});
  ASSERT_FALSE(open.has_value());
  EXPECT_THAT(open.error().message(), HasSubstr("--pair"));
  server.stop();  // A loop has one server at a time.
  EXPECT_TRUE(tryToListen(server, {.address = "0.0.0.0", .port = 0, .key = *PairingKey::make()}).has_value());
  EXPECT_TRUE(tryToListen(server, {.address = "localhost", .port = 0}).has_value());
}

TEST(NetworkServer, CannotListenWhereAnotherDoesOrThereIsNoAddress) {
  LiveServer server;
  const auto taken = tryToListen(server, {.port = server.port()});
  ASSERT_FALSE(taken.has_value());
  EXPECT_THAT(taken.error().message(), HasSubstr(std::to_string(server.port())));
  const auto nowhere = tryToListen(server, {.address = "here", .port = 0});
  ASSERT_FALSE(nowhere.has_value());
  EXPECT_THAT(nowhere.error().message(), HasSubstr("here"));
}

}  // namespace
}  // namespace hapticell::haptic
