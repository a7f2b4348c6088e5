// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/haply/web_socket.h"

#include <atomic>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;
using std::chrono::milliseconds;

/// Bytes; a longer message is no state of a device. Half and twice only bound memory.
constexpr std::size_t kMostMessage = 1 << 20;

struct Address {
  std::string host, port, path;
};

Address parse(std::string text) {
  if (text.starts_with("ws://")) text.erase(0, 5);
  Address address;
  const std::size_t slash = text.find('/');
  address.path = slash == std::string::npos ? "/" : text.substr(slash);
  text = text.substr(0, slash);
  const std::size_t colon = text.rfind(':');
  address.host = text.substr(0, colon);
  address.port = colon == std::string::npos ? "10001" : text.substr(colon + 1);
  return address;
}

}  // namespace

/// Everything but the mailbox belongs to the network thread.
class WebSocket::Connection : public std::enable_shared_from_this<WebSocket::Connection> {
 public:
  explicit Connection(Address address) : address_(std::move(address)), resolver_(io_), socket_(io_) {}

  /// True when the hands are shaken within the time.
  bool open(int wait_ms, std::string& why) {
    asio::post(io_, [self = shared_from_this()] { self->resolve(); });
    thread_ = std::thread([this] { io_.run(); });
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, milliseconds(wait_ms), [this] { return open_ || !why_.empty(); });
    why = why_.empty() ? "it did not answer in time" : why_;
    if (open_) why.clear();
    return open_;
  }
  void close() {
    asio::post(io_, [self = shared_from_this()] { self->finish(); });
    {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, milliseconds(100), [this] { return !open_; });
    }
    io_.stop();
    if (thread_.joinable()) thread_.join();
    // What still waits holds this object: it ends with the socket.
    resolver_.cancel();
    beast::get_lowest_layer(socket_).close();
    io_.restart();
    io_.poll();
  }
  std::optional<std::string> take(int wait_ms) {
    std::unique_lock lock(mutex_);
    if (wait_ms > 0) changed_.wait_for(lock, milliseconds(wait_ms), [this] { return newest_.has_value() || !open_; });
    std::optional<std::string> text = std::move(newest_);
    newest_.reset();
    return text;
  }
  void send(std::string text) {
    asio::post(io_, [self = shared_from_this(), text = std::move(text)]() mutable {
      self->waiting_ = std::move(text);
      self->writeNext();
    });
  }
  bool isOpen() const {
    const std::scoped_lock lock(mutex_);
    return open_;
  }

 private:
  void resolve() {
    resolver_.async_resolve(address_.host, address_.port, [self = shared_from_this()](error_code error, auto results) {
      if (error) return self->lose(error);
      self->socket_.next_layer().async_connect(results, [self](error_code failed, const auto&) {
        if (failed) return self->lose(failed);
        self->shakeHands();
      });
    });
  }
  void shakeHands() {
    error_code ignored;
    socket_.next_layer().socket().set_option(asio::ip::tcp::no_delay(true), ignored);
    socket_.read_message_max(kMostMessage);
    socket_.async_handshake(address_.host + ":" + address_.port, address_.path,
                            [self = shared_from_this()](error_code error) {
                              if (error) return self->lose(error);
                              {
                                const std::scoped_lock lock(self->mutex_);
                                self->open_ = true;
                              }
                              self->changed_.notify_all();
                              self->readNext();
                            });
  }
  void readNext() {
    socket_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->lose(error);
      std::string text = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.consume(self->buffer_.size());
      {
        const std::scoped_lock lock(self->mutex_);
        self->newest_ = std::move(text);
      }
      self->changed_.notify_all();
      self->readNext();
    });
  }
  void writeNext() {
    if (writing_ || !waiting_) return;
    writing_ = true;
    outgoing_ = std::move(*waiting_);
    waiting_.reset();
    socket_.text(true);
    socket_.async_write(asio::buffer(outgoing_), [self = shared_from_this()](error_code error, std::size_t) {
      self->writing_ = false;
      if (error) return self->lose(error);
      if (self->finishing_ && !self->waiting_) return self->finish();
      self->writeNext();
    });
  }
  void finish() {
    finishing_ = true;
    if (writing_) return;
    socket_.async_close(websocket::close_code::normal, [self = shared_from_this()](error_code error) {
      self->lose(error ? error : asio::error::make_error_code(asio::error::eof));
    });
  }
  void lose(const error_code& error) {
    {
      const std::scoped_lock lock(mutex_);
      open_ = false;
      why_ = error.message();
    }
    changed_.notify_all();
  }

  Address address_;
  asio::io_context io_;
  asio::ip::tcp::resolver resolver_;
  websocket::stream<beast::tcp_stream, false> socket_;  // Without deflate, which was never offered.
  beast::flat_buffer buffer_;
  std::string outgoing_;
  std::optional<std::string> waiting_;
  bool writing_ = false, finishing_ = false;
  std::thread thread_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  std::string why_;
  std::optional<std::string> newest_;
};

WebSocket::WebSocket(std::shared_ptr<Connection> connection) : connection_(std::move(connection)) {}

WebSocket::~WebSocket() {
  connection_->close();
}

bool WebSocket::isServed(const std::string& address, int wait_ms) {
  const Address where = parse(address);
  asio::io_context io;
  asio::ip::tcp::resolver resolver(io);
  asio::ip::tcp::socket socket(io);
  bool served = false;
  resolver.async_resolve(where.host, where.port, [&](error_code error, auto results) {
    if (error) return;
    asio::async_connect(socket, results, [&](error_code failed, const auto&) { served = !failed; });
  });
  io.run_for(milliseconds(wait_ms));
  return served;
}

std::unique_ptr<WebSocket> WebSocket::connect(const std::string& address, int wait_ms, Problem& problem) {
  auto connection = std::make_shared<Connection>(parse(address));
  std::string why;
  if (connection->open(wait_ms, why)) return std::unique_ptr<WebSocket>(new WebSocket(std::move(connection)));
  connection->close();
  refuse(problem, Status::kNotFound, "nobody answers at " + address + ": " + why);
  return nullptr;
}

std::optional<std::string> WebSocket::read(int wait_ms) {
  return connection_->take(wait_ms);
}

void WebSocket::send(std::string text) {
  connection_->send(std::move(text));
}

bool WebSocket::isOpen() const {
  return connection_->isOpen();
}

}  // namespace hapticell::driver
