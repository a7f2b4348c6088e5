// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <system_error>

namespace hapticell::haptic {

/// Why the other side was not made sure of.
enum class HandshakeFailure {
  kOtherKey,     ///< It has another key, or none.
  kOtherSpeech,  ///< It does not speak TLS 1.3: a server without a key, another program.
  kEnded,        ///< The connection ended before the keys were compared: they may well be the same.
};

/// A connection that carries bytes both ways, plain or protected. Used by one network thread; at most one read and one
/// write are under way at a time. Whoever starts one keeps the stream until its handler was called, which it always is
/// (with an error after the socket was closed).
class ByteStream {
 public:
  using Done = std::function<void(std::error_code)>;
  using Received = std::function<void(std::error_code, std::size_t bytes)>;

  virtual ~ByteStream() = default;
  /// The connection below: for options, its peer's address, and to close it.
  virtual asio::ip::tcp::socket& socket() = 0;
  virtual const asio::ip::tcp::socket& socket() const = 0;
  /// Makes sure of the other side before anything is read or written. A plain stream has nothing to do: `done` is
  /// called before the call returns.
  virtual void handshake(Done done) = 0;
  virtual void read(asio::mutable_buffer into, Received received) = 0;  ///< Whatever has come, at least one byte.
  virtual void write(asio::const_buffer bytes, Done done) = 0;          ///< All of it.
};

/// Bytes as they are: for connections that do not leave this machine.
std::unique_ptr<ByteStream> plainStream(asio::ip::tcp::socket socket);

}  // namespace hapticell::haptic
