// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/drivers/haply/haply_messages.h"
#include "haptic/devices/drivers/haply/web_socket.h"

namespace hapticell::driver {

/// An Inverse3 behind its maker's service, with the grip on it where there is one. Each state that comes is answered by
/// a force; a force of zero is sent at once, whether or not anything comes.
class HaplyDevice final : public Device {
 public:
  /// `first`: what the service told last; its cursor is the middle of the workspace unless `middle` is given.
  HaplyDevice(std::unique_ptr<WebSocket> socket, const HaplyReport& first, const std::optional<dvec3>& middle);
  ~HaplyDevice();  ///< Sends a last force of zero.
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }

  /// Reads of a millisecond without a state until service or device counts as gone: a second.
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
/// the workspace's middle in the service's axes; else where the grip is when it is opened).
class HaplyDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` as the service tells it, or an address "ws://..." whose first device is meant.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// By whether the service can be reached (it is not spoken to), and by what is plugged into the USB.
  std::uint64_t presence() noexcept override;

 private:
  Information information_{"haply", "Haply Inverse3", "1.0", "Haply's service (WebSocket)",
                           "Tested against a stand-in of the service, not on a real device."};
  std::string address_ = "ws://localhost:10001";
  std::optional<dvec3> middle_;
};

}  // namespace hapticell::driver
