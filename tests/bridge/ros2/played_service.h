// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <ros2_messages.h>

#include <cstdint>
#include <string>

#include "bridge/ros2/rpc_client.h"

namespace hapticell::bridge {

/// The server's side of a service, which a test answers by hand. The node must outlive it.
template <typename Request, typename Response, typename NumberedRequest, typename NumberedResponse>
class PlayedService {
 public:
  using Client = RpcClient<Request, Response, NumberedRequest, NumberedResponse>;
  /// Who asked, and which request it was; both 0 in the plain form.
  struct Asker {
    std::uint64_t client = 0;
    std::int64_t number = 0;
  };

  PlayedService(RosNode& node, const std::string& service, const typename Client::Types& types, RpcForm form)
      : node_(node), form_(form) {
    const bool is_plain = form == RpcForm::kPlain;
    const auto reader = node.openReader("rq" + service + "Request", is_plain ? types.request : types.numbered_request,
                                        RosQuality::kDefault, types.request.m_typename);
    const auto writer = node.openWriter("rr" + service + "Reply", is_plain ? types.response : types.numbered_response,
                                        RosQuality::kDefault, types.response.m_typename);
    EXPECT_TRUE(reader && writer);
    reader_ = reader.value_or(0);
    writer_ = writer.value_or(0);
  }

  /// Calls `take` with every request that came and its asker.
  template <typename Take>
  void takeRequests(const Take& take) {
    if (form_ == RpcForm::kPlain) return takeAll<Request>(reader_, [&](const Request& request) { take(request, Asker{}); });
    takeAll<NumberedRequest>(reader_, [&](const NumberedRequest& request) {
      take(request.content, Asker{request.client, request.number});
    });
  }

  void answer(const Asker& asker, const Response& response) {
    const NumberedResponse numbered{asker.client, asker.number, response};
    const auto written = form_ == RpcForm::kPlain ? node_.write(writer_, &response) : node_.write(writer_, &numbered);
    EXPECT_TRUE(written) << written.error().message();
  }

 private:
  RosNode& node_;
  RpcForm form_;
  dds_entity_t reader_ = 0, writer_ = 0;
};

/// The service by which goals are cancelled.
using PlayedCancelGoal = PlayedService<action_msgs_srv_dds__CancelGoal_Request_, action_msgs_srv_dds__CancelGoal_Response_,
                                       hapticell_numbered_CancelGoalRequest, hapticell_numbered_CancelGoalResponse>;

inline PlayedCancelGoal::Client::Types cancelGoalTypes() {
  return {action_msgs_srv_dds__CancelGoal_Request__desc, action_msgs_srv_dds__CancelGoal_Response__desc,
          hapticell_numbered_CancelGoalRequest_desc, hapticell_numbered_CancelGoalResponse_desc};
}

}  // namespace hapticell::bridge
