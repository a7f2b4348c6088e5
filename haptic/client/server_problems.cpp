// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_problems.h"

namespace hapticell::haptic {

LinkProblem connectingTo(const std::string& server) {
  return {Text("Connecting to the haptic server at %1.", server)};
}

LinkProblem noServerAt(const std::string& server) {
  return {Text("No haptic server answers at %1.", server), Text("Start hapticell-haptic-server.")};
}

LinkProblem noKeyFor(const std::string& server) {
  return {Text("This station has no key for the haptic server at %1.", server),
          Text("Show one there with hapticell-haptic-server --pair, and type it here: hapticell-cli pair %1.", server)};
}

LinkProblem noHandshakeWith(const std::string& server, HandshakeFailure failure, const Text& why) {
  if (failure == HandshakeFailure::kEnded)
    return {Text("The haptic server at %1 is there, but %2: it may be busy with many connections.", server, why),
            Text("HaptiCell tries again by itself; the key that is kept stays good.")};
  const Text what("The haptic server at %1 and this station do not have the same key: %2.", server, why);
  if (failure == HandshakeFailure::kOtherSpeech)
    return {what, Text("Start the server with its key (hapticell-haptic-server --listen ADDRESS), or see what else "
                       "answers there.")};
  return {what, Text("Pair them again: hapticell-haptic-server --pair there, hapticell-cli pair here.")};
}

LinkProblem closedBy(const std::string& server, bool has_key, bool welcomed) {
  if (welcomed || has_key) return {Text("The haptic server at %1 closed the connection.", server)};
  return {
      Text("The haptic server at %1 closed the connection at once: it may be one that wants a key "
           "(hapticell-cli pair), or busy with many connections.",
           server)};
}

LinkProblem strangerAt(const std::string& server, bool has_key) {
  if (has_key) return {Text("What answers at %1 is not a haptic server of this release.", server)};
  return {
      Text("What answers at %1 is not a haptic server of this release, or one that wants a key "
           "(hapticell-cli pair).",
           server)};
}

LinkProblem silentServer(const std::string& server) {
  return {Text("The haptic server at %1 does not answer any more.", server)};
}

}  // namespace hapticell::haptic
