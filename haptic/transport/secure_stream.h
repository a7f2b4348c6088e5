// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/ip/tcp.hpp>
#include <memory>
#include <string>
#include <system_error>

#include "haptic/transport/byte_stream.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::haptic {

/// Makes protected streams with one pairing key: TLS 1.3 only (RFC 8446), keyed by the pre-shared key with an ephemeral
/// Diffie-Hellman exchange, so that nobody can decrypt a recorded connection, even with the key. No certificates,
/// tickets or early data, so nothing can be replayed.
class SecureStreams {
 public:
  enum class Side { kClient, kServer };

  SecureStreams(Side side, const PairingKey& key);
  ~SecureStreams();
  SecureStreams(const SecureStreams&) = delete;
  SecureStreams& operator=(const SecureStreams&) = delete;

  /// The stream keeps the needed parts of this object alive.
  std::unique_ptr<ByteStream> make(asio::ip::tcp::socket socket) const;

 private:
  struct Context;
  Side side_;
  std::shared_ptr<Context> context_;
};

/// The kind of failure that ended a handshake.
HandshakeFailure handshakeFailure(const std::error_code& failed);

/// Why a handshake failed, for the user.
Text handshakeProblem(const std::error_code& failed);

}  // namespace hapticell::haptic
