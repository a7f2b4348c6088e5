// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A client's end of a WebSocket that carries texts, newest wins in both directions. Its network runs in a thread of
/// its own; no call waits longer than it says. One user thread.
class WebSocket {
 public:
  /// Connects and shakes hands within `wait_ms`; null and a problem where nobody answers. `address`:
  /// "ws://host:port/path", the path may be missing.
  static std::unique_ptr<WebSocket> connect(const std::string& address, int wait_ms, Problem& problem);
  ~WebSocket();  ///< Closes; what was sent just before is given 100 ms to go out.

  /// Somebody listens there: connects, says nothing and goes again. Waits `wait_ms` at most.
  static bool isServed(const std::string& address, int wait_ms);

  /// The newest text that came since the last call, waiting `wait_ms` at most.
  std::optional<std::string> read(int wait_ms);
  /// Sends it, unless a newer one overtakes it before the line is free.
  void send(std::string text);
  /// False once the other side has gone.
  bool isOpen() const;

 private:
  class Connection;
  explicit WebSocket(std::shared_ptr<Connection> connection);
  std::shared_ptr<Connection> connection_;
};

}  // namespace hapticell::driver
