// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "manipulation/session/session.h"

namespace hapticell::manipulation {

/// As runSession(), through a haptic server over TCP, in real time. The server's device must be a simulated one, which
/// this session's hand holds. Further errors: no server answers within five seconds; its device cannot be held; the
/// connection is lost before the end of the hand path (closed, silent for a second, reconnected, taken by another
/// client), with the time and the reason.
Expected<SessionReport> runSessionOnServer(const SessionOptions& options, const std::string& host, int port,
                                           const TraceSink& trace = {});

}  // namespace hapticell::manipulation
