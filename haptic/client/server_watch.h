// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/system/error.h"
#include "haptic/client/tcp_link.h"

namespace hapticell::haptic {

/// s that a program waits for a haptic server. Half: a server that is just starting is missed; twice: a user who
/// mistyped an address waits 10 s to learn it.
inline constexpr double kServerPatience = 5.0;

/// A link that only watches the server at host:port, with this user's key for it; it starts connecting and does not
/// wait. `program` is how the server names it to others. Error: the key file cannot be used.
Expected<std::unique_ptr<TcpLink>> openWatcher(const std::string& host, std::uint16_t port, const std::string& program);

/// Blocks until the link is connected or was refused, at most `seconds`. True: it is connected. Any thread.
bool waitUntilConnected(const TcpLink& link, double seconds = kServerPatience);

/// openWatcher(), connected: blocks until then. Errors: no server answers within `seconds`, or it refuses, with the
/// link's reason.
Expected<std::unique_ptr<TcpLink>> watchServer(const std::string& host, std::uint16_t port, const std::string& program,
                                               double seconds = kServerPatience);

}  // namespace hapticell::haptic
