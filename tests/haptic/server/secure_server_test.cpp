// SPDX-License-Identifier: Apache-2.0
// Two stations: only who has the key gets in, and nobody else troubles the force loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/ssl.h>

#include <memory>

#include "haptic/client/tcp_link.h"
#include "tests/haptic/server/link_proxy.h"
#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

const PairingKey& ourKey() {
  static const PairingKey key = *PairingKey::make();
  return key;
}

NetworkOptions keyed() {
  NetworkOptions options;
  options.key = ourKey();
  return options;
}

TcpLinkOptions to(std::uint16_t port, const std::optional<PairingKey>& key) {
  TcpLinkOptions options;
  options.port = port;
  options.key = key;
  options.retry_time = 0.05;
  return options;
}

bool failsFor(TcpLink& link, const std::string& reason) {
  return eventually([&] { return english(link.problem()).find(reason) != std::string::npos; });
}

/// Whether a paired client still gets in and feels the floor: what every attack must leave as it was.
void expectServes(LiveServer& server) {
  TcpLink link(to(server.port(), ourKey()));
  ASSERT_TRUE(connects(link)) << english(link.problem());
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, 0.005)), 0});
  link.sendControl({.forces_enabled = true});
  link.sendSet(floorSet(1));
  ASSERT_TRUE(eventually([&] {
    const auto state = link.latestState();
    return state && state->force_ramp == 1.0 && state->adopted_set == 1;
  }));
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, -0.010)), 1});
  EXPECT_TRUE(eventually([&] {
    const auto state = link.latestState();
    return state && state->force_D.z > 2.0 && state->buttons == 1;
  }));
}

TEST(SecureServer, APairedStationFeelsTheFloor) {
  LiveServer server(keyed());
  expectServes(server);
}

TEST(SecureServer, AnotherKeyIsRefusedAndBothSidesSaySo) {
  LiveServer server(keyed());
  TcpLink stranger(to(server.port(), *PairingKey::make()));
  EXPECT_TRUE(failsFor(stranger, "do not have the same key")) << english(stranger.problem());
  EXPECT_TRUE(eventually([&] { return server.reported("Refused a program at 127.0.0.1"); }));
  EXPECT_FALSE(server.reported("controls the stylus"));
  expectServes(server);
}

TEST(SecureServer, PlainTextIsRefused) {
  LiveServer server(keyed());
  RawClient plain(server.port());
  EXPECT_FALSE(plain.hello().has_value());
  EXPECT_TRUE(eventually([&] { return server.reported("does not speak TLS"); }));
  TcpLink link(to(server.port(), std::nullopt));
  EXPECT_TRUE(failsFor(link, "wants a key")) << english(link.problem());
  expectServes(server);
}

TEST(SecureServer, AKeyedClientTellsNothingToAPlainServer) {
  LiveServer plain;
  TcpLink link(to(plain.port(), ourKey()));
  EXPECT_TRUE(failsFor(link, "do not have the same key")) << english(link.problem());
  EXPECT_FALSE(plain.reported("controls the stylus"));
}

TEST(SecureServer, ARecordedConnectionPlayedAgainIsWorthNothing) {
  LiveServer server(keyed());
  std::string recorded;
  {
    LinkProxy proxy(server.port(), {});
    TcpLink link(to(proxy.port(), ourKey()));
    ASSERT_TRUE(connects(link));
    link.sendControl({.forces_enabled = true});
    ASSERT_TRUE(eventually([&] { return link.latestState().has_value(); }));
    recorded = proxy.sentByFirst();
  }
  ASSERT_GT(recorded.size(), 200u);
  ASSERT_TRUE(eventually([&] { return server.reported("is gone"); }));
  RawClient replay(server.port());
  replay.sendBytes(recorded);
  EXPECT_FALSE(replay.receive().has_value());
  EXPECT_TRUE(eventually([&] { return server.reported("Refused a program at"); }));
  expectServes(server);
}

unsigned oldKey(SSL*, const char*, char* identity, unsigned room, unsigned char* secret, unsigned most) {
  const std::string name = ourKey().identity();
  const auto bytes = ourKey().secret();
  if (name.size() >= room || bytes.size() > most) return 0;
  std::copy(name.begin(), name.end(), identity);
  identity[name.size()] = '\0';
  std::copy(bytes.begin(), bytes.end(), secret);
  return static_cast<unsigned>(bytes.size());
}

/// A handshake by OpenSSL itself with the right key; whether it came about.
bool handshake(std::uint16_t port, int version, const char* older_ciphers) {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(SSL_CTX_new(TLS_client_method()), &SSL_CTX_free);
  SSL_CTX_set_max_proto_version(context.get(), version);
  SSL_CTX_set_psk_client_callback(context.get(), &oldKey);
  SSL_CTX_set_cipher_list(context.get(), older_ciphers);
  SSL_CTX_set_ciphersuites(context.get(), "TLS_AES_128_GCM_SHA256");
  const std::unique_ptr<BIO, decltype(&BIO_free_all)> bio(BIO_new_ssl_connect(context.get()), &BIO_free_all);
  BIO_set_conn_hostname(bio.get(), ("127.0.0.1:" + std::to_string(port)).c_str());
  return BIO_do_connect(bio.get()) == 1;
}

TEST(SecureServer, OlderVersionsOfTlsAreRefusedEvenWithTheKey) {
  LiveServer server(keyed());
  EXPECT_TRUE(handshake(server.port(), TLS1_3_VERSION, "PSK")) << "the key is the one";
  EXPECT_FALSE(handshake(server.port(), TLS1_2_VERSION, "PSK:@SECLEVEL=0"));
  EXPECT_TRUE(eventually([&] { return server.reported("Refused a program at"); }));
  expectServes(server);
}

TEST(SecureServer, APairedControllerKeepsTheStylusThroughAFloodAndSlowTalkers) {
  NetworkOptions options = keyed();
  options.hello_time = 0.3;
  LiveServer server(options);
  TcpLink link(to(server.port(), ourKey()));
  ASSERT_TRUE(connects(link));
  std::vector<std::unique_ptr<RawClient>> crowd;
  const std::string drop("\x16\x03\x01\x02\x00\x01", 6);  // The first bytes of a TLS greeting that never ends.
  for (int i = 0; i < 200; ++i) {
    crowd.push_back(std::make_unique<RawClient>(server.port()));
    crowd.back()->sendBytes(std::string_view(drop).substr(0, 1 + static_cast<std::size_t>(i) % drop.size()));
  }
  const auto before = link.latestState();
  EXPECT_TRUE(eventually([&] {
    const auto state = link.latestState();
    return state && (!before || state->tick > before->tick + 200);
  }));
  EXPECT_EQ(link.connections(), 1u) << "it was not pushed out";
  EXPECT_EQ(link.grantedKind(), ClientKind::kController);
  for (const auto& raw : crowd) EXPECT_FALSE(raw->receive().has_value()) << "ended by the server";
  TcpLink watcher([&] {
    TcpLinkOptions watch = to(server.port(), ourKey());
    watch.kind = ClientKind::kWatcher;
    return watch;
  }());
  EXPECT_TRUE(connects(watcher)) << english(watcher.problem());
}

TEST(SecureServer, ASecondPairedControllerIsToldWhoHasTheStylus) {
  LiveServer server(keyed());
  TcpLink first(to(server.port(), ourKey()));
  ASSERT_TRUE(connects(first));
  TcpLink second(to(server.port(), ourKey()));
  ASSERT_TRUE(eventually([&] { return second.linkState() == LinkState::kRefused; }));
  EXPECT_THAT(english(second.problem()), HasSubstr("controls the stylus"));
}

class SlowLink : public ::testing::TestWithParam<double> {};

/// The link between two stations may be slow, jitter and lose: what arrives is still felt, and the round trip is told.
TEST_P(SlowLink, TheFloorIsFeltAndTheRoundTripIsTold) {
  LiveServer server(keyed());
  const double delay = GetParam();
  LinkProxy proxy(server.port(), {.delay = delay, .jitter = 0.5 * delay, .loss = 0.01});
  TcpLink link(to(proxy.port(), ourKey()));
  ASSERT_TRUE(connects(link));
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, 0.005)), 0});
  link.sendControl({.forces_enabled = true});
  link.sendSet(floorSet(1));
  ASSERT_TRUE(eventually([&] {
    const auto state = link.latestState();
    return state && state->force_ramp == 1.0 && state->adopted_set == 1;
  }));
  link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, -0.010)), 1});
  EXPECT_TRUE(eventually([&] {
    const auto state = link.latestState();
    return state && state->force_D.z > 2.0;
  }));
  EXPECT_TRUE(eventually([&] {
    const auto statistics = link.latestStatistics();
    return statistics && statistics->round_trip_ms >= 2e3 * delay;
  }));
  // Both clocks are this machine's: jitter makes one way longer than the other by one delay at most.
  EXPECT_TRUE(eventually([&] {
    const auto statistics = link.latestStatistics();
    return statistics && statistics->clock_offset_ms && std::abs(*statistics->clock_offset_ms) <= 1e3 * delay + 1.0;
  }));
}

INSTANTIATE_TEST_SUITE_P(Delays, SlowLink, ::testing::Values(0.0, 0.005, 0.020, 0.050),
                         [](const auto& entry) { return std::to_string(std::lround(1e3 * entry.param)) + "_ms"; });

}  // namespace
}  // namespace hapticell::haptic
