// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hapticell::haptic {

/// The process at the other end of a connection within this machine. It shows at once that the process dies. The kernel
/// closes the sockets only after freeing the memory, and slow heart-beats are missed only after 0.6 s.
class PeerProcess {
 public:
  /// The process whose socket is bound to `client` ("127.0.0.1:53412", "[::1]:53412", "::1:53412") and connected to
  /// port `server_port` of this machine. Empty if it is on another machine or belongs to another user. Takes some
  /// milliseconds, because it searches /proc.
  static std::optional<PeerProcess> find(const std::string& client, std::uint16_t server_port);

  /// Whether it has been killed or ends, so that none of its threads will run again. Some microseconds; never true for
  /// a living process.
  bool isDying() const;
  pid_t id() const { return id_; }

 private:
  explicit PeerProcess(pid_t id) : id_(id) {}
  pid_t id_;
};

}  // namespace hapticell::haptic
