// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hapticell::haptic {

/// The process at the other end of a connection within this machine. It tells that it dies at once, whereas its sockets
/// are closed only when its memory has been freed, and a slow heart is missed only after 0.6 s.
class PeerProcess {
 public:
  /// Whose socket is bound to `client` ("127.0.0.1:53412", "[::1]:53412", "::1:53412") and connected to port
  /// `server_port` of this machine. Nothing where it is on another machine, or may not be looked at (another user's).
  /// Takes some milliseconds: it looks through /proc.
  static std::optional<PeerProcess> find(const std::string& client, std::uint16_t server_port);

  /// It has been killed, or ends: none of its threads will run again. Some microseconds; never wrong about one that
  /// lives.
  bool isDying() const;
  pid_t id() const { return id_; }

 private:
  explicit PeerProcess(pid_t id) : id_(id) {}
  pid_t id_;
};

}  // namespace hapticell::haptic
