// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

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
