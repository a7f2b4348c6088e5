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
  std::optional<PairingKey> key{};    ///< The key that clients need; unset: unencrypted, and this machine only.
  double state_rate_hz = 1000.0;      ///< Largest rate at which the newest state is sent.
  std::size_t max_clients = 16;       ///< Watchers; the controller has an additional place.
  std::size_t max_clients_of_address = 8;  ///< Watchers from one other machine.
  /// Connections that have not proven the key or not sent Hello yet. If the limit is reached, the oldest connection of
  /// the address with the most of them is closed, so that silent connections cannot block others.
  std::size_t max_waiting = 128;
  std::size_t max_waiting_of_address = 64;
  double handshake_time = 1.0;        ///< Time limit to prove the key.
  double hello_time = 2.0;            ///< Time limit for a client's Hello.
  double silence_time = 5.0;          ///< A client that is silent for this long is disconnected.
  double takeover_time = 0.8;         ///< A controller that is silent for this long can be replaced.
  int priority = 0;            ///< SCHED_FIFO priority of the network thread if granted, below the force thread's; 0:
                               ///< no real-time priority.
  DeviceCare* care = nullptr;  ///< The device's; outlives the server. Null: the device needs nothing from the user.
  std::function<void(const std::string&)> report{};  ///< Gets sentences about events, in the network thread.
};

/// Connects clients to a force loop: one controller, any number of watchers. docs/library/protocol.md has the rules.
///
/// Runs one thread and uses only the lock-free interface of the force loop. Whatever clients send and however slowly
/// they read, they do not delay the loop or other clients.
class NetworkServer {
 public:
  /// Binds and starts. Errors: an address that is invalid, not this machine's, or beyond loopback without a key; a port
  /// in use. `loop` and `clock` must outlive the server, and a loop has one server at a time.
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
