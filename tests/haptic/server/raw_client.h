// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/protocol/codec.h"

namespace hapticell::haptic {

/// A plain blocking socket to a server on this machine, for sending what no proper client would.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  /// False when the server has closed the connection.
  bool sendBytes(std::string_view bytes);
  bool send(const Message& message);
  /// A Hello; the answer as receive() gives it.
  std::optional<Message> hello(ClientKind kind = ClientKind::kController, bool accept_watching = false,
                               const std::string& program = "test");

  /// The next message; nothing when the server closed the connection (or sent nothing for half a minute).
  std::optional<Message> receive();
  /// The next message of the type; others are passed over.
  template <typename T>
  std::optional<T> receiveOf() {
    while (auto message = receive()) {
      if (auto* wanted = std::get_if<T>(&*message)) return std::move(*wanted);
    }
    return std::nullopt;
  }
  /// The sentence of the Refusal that ends the connection; empty when it ends without one.
  std::string refusalThenEnd();
  void close();

 private:
  int socket_ = -1;
  Encoder encoder_;
  FrameReader reader_;
};

/// The frame of a message as text, to be bent.
std::string frameText(const Message& message);

}  // namespace hapticell::haptic
