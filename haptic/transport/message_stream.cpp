// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/message_stream.h"

#include <asio/buffer.hpp>
#include <asio/ip/network_v6.hpp>
#include <string>
#include <utility>

#include "haptic/transport/secure_stream.h"

namespace hapticell::haptic {

MessageStream::MessageStream(std::unique_ptr<ByteStream> stream, Handlers handlers)
    : stream_(std::move(stream)), handlers_(std::move(handlers)), incoming_(kMaxFrameBytes) {}

void MessageStream::start() {
  std::error_code ignored;
  asio::ip::tcp::socket& socket = stream_->socket();
  socket.set_option(asio::ip::tcp::no_delay(true), ignored);
  // A small send buffer keeps stale states out of the kernel's queue when the peer is slow.
  socket.set_option(asio::socket_base::send_buffer_size(32 * 1024), ignored);
  socket.non_blocking(true, ignored);
  writing_ = true;  // Nothing leaves before the other side is known.
  stream_->handshake([self = shared_from_this()](std::error_code failed) {
    if (self->closed_) return;
    self->writing_ = false;
    if (failed) return self->refuse(failed);
    if (self->handlers_.opened) self->handlers_.opened();
    if (self->closed_) return;
    self->read();
    self->write();
  });
}

std::string MessageStream::peer() const {
  std::error_code failed;
  const auto endpoint = std::as_const(*stream_).socket().remote_endpoint(failed);
  return failed ? std::string() : endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
}

std::string MessageStream::peerNetwork() const {
  std::error_code failed;
  const auto address = std::as_const(*stream_).socket().remote_endpoint(failed).address();
  if (failed) return {};
  if (address.is_v4()) return address.to_string();
  const asio::ip::address_v6 whole = address.to_v6();
  if (whole.is_v4_mapped()) return asio::ip::make_address_v4(asio::ip::v4_mapped, whole).to_string();
  return asio::ip::make_network_v6(whole, 64).canonical().to_string();
}

void MessageStream::read() {
  stream_->read(asio::buffer(incoming_), [self = shared_from_this()](std::error_code failed, std::size_t bytes) {
    if (self->closed_) return;
    if (failed) return self->lost();
    self->handle(bytes);
    if (!self->closed_) self->read();
  });
}

void MessageStream::handle(std::size_t bytes) {
  if (finishing_ || garbage_) return;  // Read on only to notice the peer's end.
  reader_.append(std::span<const std::uint8_t>(incoming_).first(bytes));
  while (!closed_ && !finishing_) {
    const auto frame = reader_.next();
    if (frame && frame->empty()) return;
    const auto decoded = frame ? decode(*frame, message_) : Expected<void>(tl::unexpected(frame.error()));
    if (!decoded) {
      garbage_ = true;
      return handlers_.garbage(decoded.error());
    }
    handlers_.message(message_);
  }
}

void MessageStream::send(std::span<const std::uint8_t> frame) {
  if (closed_ || finishing_) return;
  if (queue_.size() + frame.size() > kMaxQueuedBytes) return lost();
  queue_.insert(queue_.end(), frame.begin(), frame.end());
  write();
}

void MessageStream::sendNewest(Slot slot, std::span<const std::uint8_t> frame) {
  if (closed_ || finishing_) return;
  newest_[static_cast<std::size_t>(slot)].assign(frame.begin(), frame.end());
  write();
}

void MessageStream::write() {
  if (writing_ || closed_) return;
  outgoing_.clear();
  outgoing_.swap(queue_);
  for (auto& newest : newest_) {
    if (!finishing_) outgoing_.insert(outgoing_.end(), newest.begin(), newest.end());
    newest.clear();
  }
  if (outgoing_.empty()) {
    std::error_code ignored;
    if (finishing_) stream_->socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    return;
  }
  writing_ = true;
  stream_->write(asio::buffer(outgoing_), [self = shared_from_this()](std::error_code failed) {
    self->writing_ = false;
    if (self->closed_) return;
    if (failed) return self->lost();
    self->write();
  });
}

void MessageStream::finish() {
  if (closed_ || finishing_) return;
  finishing_ = true;
  write();
}

void MessageStream::close() {
  if (closed_) return;
  closed_ = true;
  std::error_code ignored;
  stream_->socket().close(ignored);
}

void MessageStream::lost() {
  if (closed_) return;
  close();
  handlers_.closed();
}

void MessageStream::refuse(std::error_code failed) {
  close();
  handlers_.unauthenticated ? handlers_.unauthenticated(handshakeFailure(failed), handshakeProblem(failed)) : handlers_.closed();
}

}  // namespace hapticell::haptic
