// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/byte_stream.h"

#include <asio/write.hpp>
#include <utility>

namespace hapticell::haptic {

namespace {

class PlainStream final : public ByteStream {
 public:
  explicit PlainStream(asio::ip::tcp::socket socket) : socket_(std::move(socket)) {}

  asio::ip::tcp::socket& socket() override { return socket_; }
  const asio::ip::tcp::socket& socket() const override { return socket_; }
  void handshake(Done done) override { done({}); }
  void read(asio::mutable_buffer into, Received received) override {
    socket_.async_read_some(into, std::move(received));
  }
  void write(asio::const_buffer bytes, Done done) override {
    asio::async_write(socket_, bytes, [done = std::move(done)](std::error_code failed, std::size_t) { done(failed); });
  }

 private:
  asio::ip::tcp::socket socket_;
};

}  // namespace

std::unique_ptr<ByteStream> plainStream(asio::ip::tcp::socket socket) {
  return std::make_unique<PlainStream>(std::move(socket));
}

}  // namespace hapticell::haptic
