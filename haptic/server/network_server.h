// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "haptic/transport/pairing_key.h"
#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

class Clock;
class DeviceCare;
class ForceLoop;

/// Where and how a haptic server listens. Times in seconds.
struct NetworkOptions {
  std::string address = "127.0.0.1";  ///< An IP address or "localhost".
  std::uint16_t port = 4747;          ///< 0: the system chooses one.
  std::optional<PairingKey> key{};    ///< What clients must have; none: plain, and this machine only.
  double state_rate_hz = 1000.0;      ///< How often the newest state is sent at most.
  std::size_t max_clients = 16;       ///< That watch; whoever controls has a place besides.
  std::size_t max_clients_of_address = 8;  ///< That watch from one other machine.
  /// Connections that have not shown the key, or said hello. Where it is full the oldest of the address with most of
  /// them makes room, so that silent connections keep nobody out.
  std::size_t max_waiting = 128;
  std::size_t max_waiting_of_address = 64;
  double handshake_time = 1.0;        ///< The key must have been shown by then.
  double hello_time = 2.0;            ///< A client must have said hello by then.
  double silence_time = 5.0;          ///< A client that is silent for so long is given up.
  double takeover_time = 0.8;         ///< A controller silent for so long makes room for another.
  int priority = 0;            ///< SCHED_FIFO for the network thread where granted, below the force thread's; 0: none.
  DeviceCare* care = nullptr;  ///< The device's; outlives the server. Null: it wants nothing of its user.
  std::function<void(const std::string&)> report{};  ///< Told what happens, in sentences, on the network thread.
};

/// Connects clients to a force loop: one that controls, any number that watch. docs/library/protocol.md tells the
/// rules.
///
/// Runs one thread of its own; the force loop is reached through its lock-free ends only. Whatever clients send,
/// however slowly they read, the loop and the other clients are not held up.
class NetworkServer {
 public:
  /// Binds and starts. Errors: an address that is not one, is not this machine's or is beyond loopback without
  /// a key; a port in use. `loop` and `clock` must outlive the server, and a loop has one server at
  /// a time.
  static Expected<std::unique_ptr<NetworkServer>> start(ForceLoop& loop, const Clock& clock,
                                                        const DeviceDescription& device, const NetworkOptions& options);
  ~NetworkServer();  ///< Closes every connection; the loop's link closes with them.

  std::uint16_t port() const;  ///< The port it listens on.
  const std::string& address() const;

 private:
  class Implementation;
  explicit NetworkServer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hapticell::haptic
