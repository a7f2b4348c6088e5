// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/transport/byte_stream.h"
#include "haptic/protocol/codec.h"

namespace hapticell::haptic {

/// A connection that carries whole messages both ways without ever blocking. Used by both ends, each from its one
/// network thread; always owned by a shared_ptr.
///
/// Two kinds of sending: send() keeps the order and loses nothing; sendNewest() fills one of a few slots, and what has
/// not left when the next comes is replaced. So a slow peer gets fewer messages, never old ones.
class MessageStream : public std::enable_shared_from_this<MessageStream> {
 public:
  enum class Slot : std::uint8_t { kState, kStatistics, kSet, kHandTarget };

  struct Handlers {
    std::function<void(const Message&)> message;
    /// What came is not of this protocol. Nothing more is read; sending still works.
    std::function<void(const Error&)> garbage;
    /// The other side did not show that it has the key, and why in a few words. The connection is closed; nothing else
    /// is called. Null: counts as closed.
    std::function<void(HandshakeFailure failure, const std::string& why)> stranger = nullptr;
    /// The other side has shown that it has the key; at once where none is asked for. May be null.
    std::function<void()> opened = nullptr;
    /// The connection is gone (closed, reset, or not writable for too long). Called once, not after close().
    std::function<void()> closed;
  };

  MessageStream(std::unique_ptr<ByteStream> stream, Handlers handlers);

  /// Sets TCP_NODELAY and small buffers, makes sure of the other side, begins to read. What is sent before waits.
  void start();
  void send(std::span<const std::uint8_t> frame);
  void sendNewest(Slot slot, std::span<const std::uint8_t> frame);
  /// Sends what send() queued, then says goodbye (FIN). Whatever still comes is not read any more.
  void finish();
  /// Closes at once; no handler is called afterwards.
  void close();

  bool finishing() const { return finishing_; }
  std::string peer() const;  ///< "127.0.0.1:53412", empty when unknown.
  /// Whom the connection is reckoned to where addresses are counted: "127.0.0.1"; of IPv6 the network, which one
  /// machine may have all addresses of ("2001:db8::/64"). Empty when unknown.
  std::string peerNetwork() const;

 private:
  static constexpr std::size_t kSlots = 4;
  /// More than this unsent in order means a peer that does not read: it is given up.
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
