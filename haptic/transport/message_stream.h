// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/protocol/codec.h"
#include "haptic/transport/byte_stream.h"

namespace hapticell::haptic {

/// A connection for complete messages in both directions; it never blocks. Both ends use it, each from one network
/// thread; always owned by a shared_ptr.
///
/// Two ways to send: send() keeps the order and loses nothing. sendNewest() fills one of a few slots; a message that
/// has not left when the next one arrives is replaced. So a slow peer gets fewer messages, never old ones.
class MessageStream : public std::enable_shared_from_this<MessageStream> {
 public:
  enum class Slot : std::uint8_t { kState, kStatistics, kSet, kHandTarget };

  struct Handlers {
    std::function<void(const Message&)> message;
    /// The received data violate the protocol. Nothing more is read; sending still works.
    std::function<void(const Error&)> garbage;
    /// The other side did not prove that it has the key; `why` gives the reason in a few words. The connection is
    /// closed; nothing else is called. Null: closed() is called instead.
    std::function<void(HandshakeFailure failure, const Text& why)> unauthenticated = nullptr;
    /// The other side has proven that it has the key; called at once if no key is required. May be null.
    std::function<void()> opened = nullptr;
    /// The connection is gone (closed, reset, or not writable for too long). Called once, not after close().
    std::function<void()> closed;
  };

  MessageStream(std::unique_ptr<ByteStream> stream, Handlers handlers);

  /// Sets TCP_NODELAY and small buffers, authenticates the other side and begins to read. Messages sent before that
  /// wait.
  void start();
  void send(std::span<const std::uint8_t> frame);
  void sendNewest(Slot slot, std::span<const std::uint8_t> frame);
  /// Sends the queue of send(), then FIN. Nothing more is read.
  void finish();
  /// Closes at once; no handler is called afterwards.
  void close();

  bool finishing() const { return finishing_; }
  std::string peer() const;  ///< "127.0.0.1:53412", empty when unknown.
  /// The address under which the connection is counted: "127.0.0.1"; for IPv6 the network ("2001:db8::/64"), because
  /// one machine may own all its addresses. Empty when unknown.
  std::string peerNetwork() const;

 private:
  static constexpr std::size_t kSlots = 4;
  /// Bytes unsent before the peer, who does not read, is disconnected: two of the largest frames (kMaxFrameBytes), five
  /// full sets. Half: one full frame behind another ends the link; twice: a hung peer is noticed later.
  static constexpr std::size_t kMaxQueuedBytes = 128 * 1024;

  void read();
  void handle(std::size_t bytes);
  void write();
  void lost();
  void refuse(std::error_code failed);

  std::unique_ptr<ByteStream> stream_;
  Handlers handlers_;
  FrameReader reader_;
  Message message_;
  std::vector<std::uint8_t> incoming_;
  std::vector<std::uint8_t> queue_;                       // Frames of send() that wait.
  std::array<std::vector<std::uint8_t>, kSlots> newest_;  // Frames of sendNewest() that wait; empty: none.
  std::vector<std::uint8_t> outgoing_;                    // What is being written now.
  bool writing_ = false, finishing_ = false, garbage_ = false, closed_ = false;
};

}  // namespace hapticell::haptic
