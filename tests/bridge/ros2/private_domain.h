// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "bridge/ros2/ros_node.h"

namespace hapticell::bridge {

/// A domain of DDS for this process alone: loopback, and a tag that other processes do not have. What joins it by options()
/// must end before it.
class PrivateDomain {
 public:
  PrivateDomain() {
    const std::string settings =
        "<General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces><AllowMulticast>false</AllowMulticast>"
        "</General><Discovery><ParticipantIndex>none</ParticipantIndex><Tag>hapticell-test-" +
        std::to_string(::getpid()) + "</Tag></Discovery>";
    domain_ = dds_create_domain(kNumber, settings.c_str());
    EXPECT_GT(domain_, 0) << dds_strretcode(-domain_);
  }
  ~PrivateDomain() { dds_delete(domain_); }
  PrivateDomain(const PrivateDomain&) = delete;
  PrivateDomain& operator=(const PrivateDomain&) = delete;

  /// With this_machine_only a node would make the domain again.
  static RosNodeOptions options() { return {kNumber, false}; }

  static std::unique_ptr<RosNode> node() {
    auto made = RosNode::create(options());
    if (!made) throw std::runtime_error(made.error().message());
    return std::move(*made);
  }

 private:
  static constexpr int kNumber = 83;
  dds_entity_t domain_ = 0;
};

/// Waits until `condition` holds and returns true, or false after half a minute: a wait that is ever that long is a fault.
template <typename Condition>
bool eventually(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace hapticell::bridge
