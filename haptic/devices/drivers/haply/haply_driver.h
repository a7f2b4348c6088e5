// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/drivers/haply/haply_messages.h"
#include "haptic/devices/drivers/haply/web_socket.h"

namespace hapticell::driver {

/// An Inverse3 through its maker's service, with its grip if there is one. Each state from the service is answered by a
/// force; a zero force is sent at once, without waiting for a state.
class HaplyDevice final : public Device {
 public:
  /// `first`: the service's last report; its cursor is the middle of the workspace unless `middle` is given.
  HaplyDevice(std::unique_ptr<WebSocket> socket, const HaplyReport& first, const std::optional<dvec3>& middle);
  ~HaplyDevice();  ///< Sends a last force of zero.
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }

  /// Reads of a millisecond without a state before the service or the device counts as lost: 1 s, long after its force
  /// is zero (kFreshFor). Half: a service that hiccups must be opened again; twice: reported after 2 s.
  static constexpr int kPatience = 1000;

 private:
  std::unique_ptr<WebSocket> socket_;
  std::string device_id_;
  dvec3 middle_;
  Capabilities capabilities_;
  Problem problem_;
  CommandSteps steps_;
  int empty_reads_ = 0;
  bool answer_due_ = false;
};

/// Haply Inverse3 through its maker's service. Settings: `address` (ws://localhost:10001), `middle` ("x,y,z" in metres:
/// the workspace's middle in the service's axes; default: the grip's position at opening).
class HaplyDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` as sent by the service, or an address "ws://..." for its first device.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// Depends on whether the service accepts a connection (nothing is sent) and on the USB devices.
  std::uint64_t presence() noexcept override;

 private:
  Information information_{"haply", "Haply Inverse3", "1.0", "Haply's service (WebSocket)",
                           "Tested against a stand-in of the service, not on a real device."};
  std::string address_ = "ws://localhost:10001";
  std::optional<dvec3> middle_;
};

}  // namespace hapticell::driver
