// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A device on a FireWire bus: registers, and packets at a fixed rate in both directions.
class FireWirePort {
 public:
  virtual ~FireWirePort() = default;
  virtual std::optional<std::uint32_t> readQuadlet(std::uint64_t address) = 0;  ///< In this machine's byte order.
  virtual bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) = 0;
  /// Allocates a channel in each direction and starts both. The host's packet is repeated until send() changes it.
  virtual bool startStreams(std::uint8_t& to_device, std::uint8_t& from_device) = 0;
  /// Sets the packet that is sent from now on.
  virtual void send(std::span<const std::uint8_t> packet) = 0;
  /// The newest packet, waiting at most `wait_ms`; an empty vector if none arrived. No value if the bus is gone or was
  /// reset.
  virtual std::optional<std::vector<std::uint8_t>> receive(int wait_ms) = 0;
};

/// A node on one of the buses.
struct FireWireNode {
  int bus = 0;
  std::uint16_t node = 0;
  std::uint64_t guid = 0;
  std::string place;  ///< "/dev/fw1".
};

class FireWireBus {
 public:
  virtual ~FireWireBus() = default;
  virtual std::vector<FireWireNode> nodes(Problem& problem) = 0;
  virtual std::unique_ptr<FireWirePort> open(const FireWireNode& node, Problem& problem) = 0;
};

/// Through libraw1394.
std::unique_ptr<FireWireBus> makeRaw1394();

}  // namespace hapticell::driver
