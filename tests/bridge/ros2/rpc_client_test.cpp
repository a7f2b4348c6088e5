// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/rpc_client.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "tests/bridge/ros2/played_service.h"
#include "tests/bridge/ros2/private_domain.h"

namespace hapticell::bridge {
namespace {

constexpr const char* kService = "/arm/cancel";

/// A service with two clients in nodes of their own. Requests tell themselves apart by a stamp, replies by a code.
struct ServiceOfTwo {
  using Asker = PlayedCancelGoal::Asker;
  PrivateDomain domain;
  std::unique_ptr<RosNode> nodes[3] = {PrivateDomain::node(), PrivateDomain::node(), PrivateDomain::node()};
  PlayedCancelGoal service;
  PlayedCancelGoal::Client clients[2];
  std::vector<std::pair<int, Asker>> requests;
  std::vector<int> replies[2];

  explicit ServiceOfTwo(RpcForm form) : service(*nodes[2], kService, cancelGoalTypes(), form) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(clients[i].open(*nodes[i], kService, cancelGoalTypes(), form));
      EXPECT_TRUE(eventually([&] { return clients[i].isConnected(*nodes[i]); }));
    }
  }
  void ask(std::size_t client, int stamp) {
    action_msgs_srv_dds__CancelGoal_Request_ request{};
    request.goal_info.stamp.sec = stamp;
    EXPECT_TRUE(clients[client].ask(*nodes[client], request));
  }
  bool hasRequests(std::size_t count) {
    return eventually([&] {
      service.takeRequests([&](const auto& request, const Asker& asker) { requests.emplace_back(request.goal_info.stamp.sec, asker); });
      return requests.size() >= count;
    });
  }
  void answer(const Asker& asker, int code) {
    action_msgs_srv_dds__CancelGoal_Response_ response{};
    response.return_code = static_cast<std::int8_t>(code);
    service.answer(asker, response);
  }
  /// Until a client has the reply `last`.
  bool hasReply(std::size_t client, int last) {
    return eventually([&] {
      takeReplies(client);
      return !replies[client].empty() && replies[client].back() == last;
    });
  }
  void takeReplies(std::size_t client) {
    clients[client].takeResponses([&](const auto& response) { replies[client].push_back(response.return_code); });
  }
};

TEST(RpcClient, NumbersItsRequestsFromOneOn) {
  ServiceOfTwo two(RpcForm::kNumbered);
  for (const int stamp : {10, 20, 30}) two.ask(0, stamp);
  ASSERT_TRUE(two.hasRequests(3));
  two.ask(1, 40);
  ASSERT_TRUE(two.hasRequests(4));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(two.requests[i].first, 10 * (static_cast<int>(i) + 1));
    EXPECT_EQ(two.requests[i].second.number, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(two.requests[i].second.client, two.requests[0].second.client);
  }
  EXPECT_EQ(two.requests[3].first, 40);
  EXPECT_EQ(two.requests[3].second.number, 1);
  EXPECT_NE(two.requests[3].second.client, two.requests[0].second.client);
}

TEST(RpcClient, TakesOnlyTheReplyToItsOwnLastRequest) {
  ServiceOfTwo two(RpcForm::kNumbered);
  two.ask(0, 1);
  two.ask(0, 2);
  ASSERT_TRUE(two.hasRequests(2));
  two.ask(1, 3);
  ASSERT_TRUE(two.hasRequests(3));
  const auto first = two.requests[0].second, last = two.requests[1].second, others = two.requests[2].second;
  two.answer(first, 1);
  two.answer({last.client + 1000, last.number}, 2);
  two.answer({last.client, last.number + 1}, 3);
  two.answer(others, 4);
  two.answer(last, 5);
  EXPECT_TRUE(two.hasReply(0, 5));
  EXPECT_EQ(two.replies[0], std::vector<int>{5});
  EXPECT_TRUE(two.hasReply(1, 4));
  two.takeReplies(1);
  EXPECT_EQ(two.replies[1], std::vector<int>{4});
}

TEST(RpcClient, TakesEveryPlainReply) {
  ServiceOfTwo two(RpcForm::kPlain);
  two.ask(0, 10);
  ASSERT_TRUE(two.hasRequests(1));
  EXPECT_EQ(two.requests[0].first, 10) << "nothing stands before the message";
  two.answer({}, 1);
  two.answer({}, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(two.hasReply(i, 2));
    EXPECT_EQ(two.replies[i], (std::vector<int>{1, 2})) << i;
  }
}

TEST(RpcClient, IsConnectedOnceBothTopicsAre) {
  const PrivateDomain domain;
  const auto own = PrivateDomain::node(), other = PrivateDomain::node();
  PlayedCancelGoal::Client client;
  ASSERT_TRUE(client.open(*own, kService, cancelGoalTypes(), RpcForm::kPlain));
  EXPECT_FALSE(client.isConnected(*own));
  const auto writer = own->openWriter("rq" + std::string(kService) + "Request", cancelGoalTypes().request, RosQuality::kDefault,
                                      cancelGoalTypes().request.m_typename);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(other->openReader("rq" + std::string(kService) + "Request", cancelGoalTypes().request, RosQuality::kDefault,
                                cancelGoalTypes().request.m_typename));
  ASSERT_TRUE(eventually([&] { return own->readersOf(*writer) == 1; }));
  EXPECT_FALSE(client.isConnected(*own)) << "nobody answers";
  ASSERT_TRUE(other->openWriter("rr" + std::string(kService) + "Reply", cancelGoalTypes().response, RosQuality::kDefault,
                                cancelGoalTypes().response.m_typename));
  EXPECT_TRUE(eventually([&] { return client.isConnected(*own); }));
}

}  // namespace
}  // namespace hapticell::bridge
