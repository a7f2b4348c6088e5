// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/viewer_server.h"

#include <gtest/gtest.h>

#include "bridge/foxglove/viewer_session.h"

namespace hapticell::bridge {
namespace {

TEST(ViewerServer, KnowsAddressesOfThisMachine) {
  for (const char* host : {"127.0.0.1", "127.8.8.8", "::1"}) EXPECT_TRUE(isThisMachine(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "192.168.0.1", "localhost", "", "127.0.0.1.evil"}) EXPECT_FALSE(isThisMachine(host)) << host;
}

TEST(ViewerServer, ListensNowhereElseWithoutACode) {
  const auto open = ViewerServer::listen({"0.0.0.0", 0, ""});
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().message().find("without a code"), std::string::npos);
  EXPECT_TRUE(ViewerServer::listen({"0.0.0.0", 0, "CODE"}));
}

TEST(ViewerServer, SaysThatAPortIsTaken) {
  const auto first = ViewerServer::listen({"127.0.0.1", 0, ""});
  ASSERT_TRUE(first);
  EXPECT_GT((*first)->port(), 0);
  EXPECT_EQ((*first)->viewers(), 0u);
  const auto second = ViewerServer::listen({"127.0.0.1", (*first)->port(), ""});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find(std::to_string((*first)->port())), std::string::npos);
}

TEST(ViewerServer, EndsWithMessagesWaiting) {
  const auto server = ViewerServer::listen({"127.0.0.1", 0, ""});
  ASSERT_TRUE(server);
  const std::uint32_t topic = (*server)->addTopic({"/a", "json", "A", "jsonschema", "{}"});
  for (int k = 0; k < 1000; ++k) (*server)->keep(topic, std::to_string(k % 7), k, "{}");
  (*server)->publish(topic, 1, "{}");
  EXPECT_EQ((*server)->sent(), 0u);  // Nobody watches.
}

TEST(ViewerBoard, KeepsTheNewestOfEachKeyInTheOrderOfTheFirst) {
  ViewerBoard board;
  board.topics.push_back({1, {}, {}});
  const auto message = [](std::int64_t stamp, const char* key) {
    return ViewerMessage{1, stamp, std::make_shared<const std::string>("x"), key};
  };
  board.keep(message(1, "a"));
  board.keep(message(2, "b"));
  board.keep(message(3, "a"));
  board.keep({2, 4, nullptr, "of another topic"});
  ASSERT_EQ(board.topics[0].kept.size(), 2u);
  EXPECT_EQ(board.topics[0].kept[0].stamp_ns, 3);
  EXPECT_EQ(board.topics[0].kept[1].stamp_ns, 2);
}

}  // namespace
}  // namespace hapticell::bridge
