// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <system_error>

namespace hapticell::haptic {

/// Why the other side could not be authenticated.
enum class HandshakeFailure {
  kOtherKey,     ///< It has another key, or no key.
  kOtherSpeech,  ///< It does not speak TLS 1.3: a server without a key, another program.
  kEnded,        ///< The connection ended before the keys were compared: they may well be the same.
};

/// A connection for bytes in both directions, plain or protected. Used by one network thread; at most one read and one
/// write are active at a time. The caller keeps the stream until the handler is called. It is always called, with an
/// error if the socket was closed.
class ByteStream {
 public:
  using Done = std::function<void(std::error_code)>;
  using Received = std::function<void(std::error_code, std::size_t bytes)>;

  virtual ~ByteStream() = default;
  /// The underlying socket: for options, its peer's address, and to close it.
  virtual asio::ip::tcp::socket& socket() = 0;
  virtual const asio::ip::tcp::socket& socket() const = 0;
  /// Authenticates the other side before anything is read or written. A plain stream has nothing to do and calls `done`
  /// before it returns.
  virtual void handshake(Done done) = 0;
  virtual void read(asio::mutable_buffer into, Received received) = 0;  ///< Reads what has arrived, at least one byte.
  virtual void write(asio::const_buffer bytes, Done done) = 0;          ///< Writes all of it.
};

/// Unprotected: for connections that do not leave this machine.
std::unique_ptr<ByteStream> plainStream(asio::ip::tcp::socket socket);

}  // namespace hapticell::haptic
