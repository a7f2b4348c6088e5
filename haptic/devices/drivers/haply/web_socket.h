// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// The client's end of a WebSocket for texts; the newest wins in both directions. A separate thread does the network
/// work; no call waits longer than stated. One user thread.
class WebSocket {
 public:
  /// Connects and does the handshake within `wait_ms`; null and a problem if that fails. `address`:
  /// "ws://host:port/path"; the path is optional.
  static std::unique_ptr<WebSocket> connect(const std::string& address, int wait_ms, Problem& problem);
  ~WebSocket();  ///< Closes; texts sent just before have 100 ms to leave.

  /// Whether a server listens there: connects, sends nothing and disconnects. Waits at most `wait_ms`.
  static bool isServed(const std::string& address, int wait_ms);

  /// The newest text received since the last call; waits at most `wait_ms`.
  std::optional<std::string> read(int wait_ms);
  /// Sends the text, unless a newer one replaces it before it leaves.
  void send(std::string text);
  /// False after the other side has disconnected.
  bool isOpen() const;

 private:
  class Connection;
  explicit WebSocket(std::shared_ptr<Connection> connection);
  std::shared_ptr<Connection> connection_;
};

}  // namespace hapticell::driver
