// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptic/protocol/link_problem.h"
#include "haptic/transport/byte_stream.h"

namespace hapticell::haptic {

// Why a client is not connected to the haptic server at `server` ("host:port"), with what the user can do. `has_key`:
// this station has a pairing key for that server.

LinkProblem connectingTo(const std::string& server);
LinkProblem noServerAt(const std::string& server);
/// The server is on another machine, and this station has no key for it.
LinkProblem noKeyFor(const std::string& server);
/// What helps differs: only another key needs new pairing. `why`: in a few words, from the handshake.
LinkProblem noHandshakeWith(const std::string& server, HandshakeFailure failure, const Text& why);
/// `welcomed`: the server had accepted this client before.
LinkProblem closedBy(const std::string& server, bool has_key, bool welcomed);
/// What was received is not this protocol.
LinkProblem strangerAt(const std::string& server, bool has_key);
LinkProblem silentServer(const std::string& server);

}  // namespace hapticell::haptic
