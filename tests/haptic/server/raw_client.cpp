// SPDX-License-Identifier: Apache-2.0
#include "tests/haptic/server/raw_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace hapticell::haptic {

RawClient::RawClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) close();
}

RawClient::~RawClient() {
  close();
}

void RawClient::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

bool RawClient::sendBytes(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool RawClient::send(const Message& message) {
  return sendBytes(frameText(message));
}

std::optional<Message> RawClient::hello(ClientKind kind, bool accept_watching, const std::string& program) {
  if (!send(Hello{.kind = kind, .accept_watching = accept_watching, .program = program})) return std::nullopt;
  return receive();
}

std::optional<Message> RawClient::receive() {
  while (true) {
    const auto frame = reader_.next();
    if (!frame) return std::nullopt;
    Message message;
    if (!frame->empty()) return decode(*frame, message) ? std::optional(message) : std::nullopt;
    pollfd readable{socket_, POLLIN, 0};
    std::array<std::uint8_t, 4096> bytes;
    if (::poll(&readable, 1, 30'000) <= 0) return std::nullopt;
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (count <= 0) return std::nullopt;
    reader_.append(std::span(bytes).first(static_cast<std::size_t>(count)));
  }
}

std::string RawClient::refusalThenEnd() {
  std::string sentence;
  while (const auto message = receive()) {
    if (const auto* refusal = std::get_if<Refusal>(&*message)) sentence = refusal->sentence;
  }
  return sentence;
}

std::string frameText(const Message& message) {
  Encoder encoder;
  const auto frame = encoder.encode(message);
  return {frame.begin(), frame.end()};
}

}  // namespace hapticell::haptic
