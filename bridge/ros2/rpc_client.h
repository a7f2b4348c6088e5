// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "bridge/ros2/ros_node.h"
#include "bridge/ros2/taken_samples.h"

namespace hapticell::bridge {

/// How a service of ROS 2 writes its requests and replies. The two have the same names of topics and types.
enum class RpcForm {
  kPlain,     ///< The message alone, as rmw_fastrtps. Who asked is in RTPS, where Cyclone DDS does not show it.
  kNumbered,  ///< Client and number of the request before the message, as rmw_cyclonedds.
};

/// Client of one service. Plain replies do not say which request they answer: whoever asks compares them with what else
/// the server publishes. One thread. The node must outlive it.
template <typename Request, typename Response, typename NumberedRequest, typename NumberedResponse>
class RpcClient {
 public:
  /// Descriptors of the four types.
  struct Types {
    const dds_topic_descriptor_t& request;
    const dds_topic_descriptor_t& response;
    const dds_topic_descriptor_t& numbered_request;
    const dds_topic_descriptor_t& numbered_response;
  };

  /// `service`: "/arm_controller/follow_joint_trajectory/_action/send_goal". Error: what DDS says.
  Expected<void> open(RosNode& node, const std::string& service, const Types& types, RpcForm form) {
    form_ = form;
    const bool is_plain = form == RpcForm::kPlain;
    const auto writer = node.openWriter("rq" + service + "Request", is_plain ? types.request : types.numbered_request,
                                        RosQuality::kDefault, types.request.m_typename);
    HAPTICELL_TRY(writer);
    const auto reader = node.openReader("rr" + service + "Reply", is_plain ? types.response : types.numbered_response,
                                        RosQuality::kDefault, types.response.m_typename);
    HAPTICELL_TRY(reader);
    writer_ = *writer;
    reader_ = *reader;
    client_ = node.handleOf(writer_);
    return {};
  }

  bool isConnected(const RosNode& node) const { return node.readersOf(writer_) > 0 && node.writersOf(reader_) > 0; }

  /// Error: what DDS says.
  Expected<void> ask(RosNode& node, const Request& request) {
    ++number_;
    if (form_ == RpcForm::kPlain) return node.write(writer_, &request);
    const NumberedRequest numbered{client_, number_, request};
    return node.write(writer_, &numbered);
  }

  /// Calls `take` with every response that came: of the numbered form, only those to the last request of this client.
  template <typename Take>
  void takeResponses(const Take& take) {
    if (form_ == RpcForm::kPlain) return takeAll<Response>(reader_, take);
    takeAll<NumberedResponse>(reader_, [&](const NumberedResponse& response) {
      if (response.client == client_ && response.number == number_) take(response.content);
    });
  }

 private:
  RpcForm form_ = RpcForm::kPlain;
  dds_entity_t writer_ = 0, reader_ = 0;
  std::uint64_t client_ = 0;
  std::int64_t number_ = 0;
};

}  // namespace hapticell::bridge
