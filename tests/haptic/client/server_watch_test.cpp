// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "haptic/client/server_address.h"
#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

TEST(ServerAddress, ThePortIsBehindTheLastColon) {
  for (const auto& [text, host, port] :
       {std::tuple("station-2:4711", "station-2", 4711), std::tuple("[fe80::1]:1", "[fe80::1]", 1),
        std::tuple("10.0.0.7:65535", "10.0.0.7", 65535)}) {
    const auto address = parseServerAddress(text, "--server");
    ASSERT_TRUE(address) << text;
    EXPECT_EQ(address->host, host);
    EXPECT_EQ(address->port, port);
  }
  const auto usual = parseServerAddress("station-2", "server", 7000);
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->host, "station-2");
  EXPECT_EQ(usual->port, 7000);
  EXPECT_EQ(parseServerAddress("station-2:8", "server", 7000)->port, 8);
}

TEST(ServerAddress, OthersAreErrorsThatNameTheOption) {
  for (const char* bad : {"", "host", ":80", "host:", "host:0", "host:65536", "host:-1", "host:8o", "host: 80", "a:b:"}) {
    const auto address = parseServerAddress(bad, "--server");
    ASSERT_FALSE(address) << bad;
    EXPECT_THAT(address.error().message(), HasSubstr("--server"));
    EXPECT_THAT(address.error().message(), HasSubstr(std::string("'") + bad + "'"));
  }
  for (const char* bad : {"", ":80", "host:"}) EXPECT_FALSE(parseServerAddress(bad, "server", 7000)) << bad;
}

TEST(ServerWatch, GivesALinkThatIsConnectedAndTakesTheStylusFromNobody) {
  LiveServer server;
  RawClient controller(server.port());
  ASSERT_TRUE(controller.hello());
  const auto link = watchServer("127.0.0.1", server.port(), "a watching program", 30.0);
  ASSERT_TRUE(link) << link.error().message();
  EXPECT_EQ((*link)->linkState(), LinkState::kConnected);
  EXPECT_EQ((*link)->grantedKind(), ClientKind::kWatcher);
  ASSERT_TRUE((*link)->device());
  EXPECT_EQ((*link)->device()->peak_force, 6.4);
  EXPECT_TRUE(server.reported("a watching program at 127.0.0.1"));
  EXPECT_TRUE(eventually([&] { return (*link)->latestState().has_value(); }));
}

TEST(ServerWatch, SaysThatNobodyAnswers) {
  std::uint16_t port = 0;
  {
    LiveServer server;
    port = server.port();
  }
  const auto link = watchServer("127.0.0.1", port, "test", 0.05);
  ASSERT_FALSE(link);
  EXPECT_THAT(link.error().message(), HasSubstr("127.0.0.1:" + std::to_string(port)));
  EXPECT_THAT(link.error().message(), HasSubstr("no haptic server answers"));
  EXPECT_THAT(link.error().message(), HasSubstr("hapticell-haptic-server"));
}

TEST(ServerWatch, AWatcherThatDoesNotWaitConnectsOnceTheServerIsThere) {
  std::uint16_t port = 0;
  {
    LiveServer server;
    port = server.port();
  }
  const auto link = openWatcher("127.0.0.1", port, "test");
  ASSERT_TRUE(link);
  EXPECT_FALSE(waitUntilConnected(**link, 0.02));
  NetworkOptions options;
  options.port = port;
  LiveServer server(options);
  EXPECT_TRUE(waitUntilConnected(**link, 30.0));
}

TEST(ServerWatch, ARefusalIsTheServersOwnReasonAtOnce) {
  NetworkOptions options;
  options.max_clients = 0;
  LiveServer server(options);
  RawClient controller(server.port());
  ASSERT_TRUE(controller.hello());
  const auto link = watchServer("127.0.0.1", server.port(), "test", 30.0);
  ASSERT_FALSE(link);
  EXPECT_THAT(link.error().message(), ::testing::Not(HasSubstr("no haptic server answers")));
}

}  // namespace
}  // namespace hapticell::haptic
