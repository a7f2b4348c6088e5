// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

namespace hapticell::driver {

/// Haply's service on a local socket: sends the state (or whatever the test says) every two milliseconds and remembers
/// the last force. One client at a time.
class FakeHaplyService {
 public:
  explicit FakeHaplyService(unsigned short port = 0) : acceptor_(io_) {
    const boost::asio::ip::tcp::endpoint here(boost::asio::ip::address_v4::loopback(), port);
    acceptor_.open(here.protocol());
    acceptor_.set_option(boost::asio::ip::tcp::acceptor::reuse_address(true));
    acceptor_.bind(here);
    acceptor_.listen();
    acceptor_.non_blocking(true);
    port_ = acceptor_.local_endpoint().port();
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeHaplyService() {
    stopping_ = true;
    thread_.join();
  }

  unsigned short port() const { return port_; }
  std::string address() const { return "ws://127.0.0.1:" + std::to_string(port_); }
  /// Sends this text instead of the state; empty: the state again.
  void say(const std::string& text) {
    const std::scoped_lock lock(mutex_);
    instead_ = text;
  }
  std::optional<nlohmann::json> lastCommand() {
    const std::scoped_lock lock(mutex_);
    return command_;
  }
  std::atomic<double> x{0.05}, y{-0.15}, z{0.2};
  std::atomic<bool> grip{true}, silent{false};

 private:
  std::string message() {
    const std::scoped_lock lock(mutex_);
    if (!instead_.empty()) return instead_;
    nlohmann::json state{{"inverse3",
                          {{{"device_id", "04BD"},
                            {"state", {{"cursor_position", {{"x", x.load()}, {"y", y.load()}, {"z", z.load()}}}}}}}}};
    if (grip) {
      const nlohmann::json turned{{"x", 0.0}, {"y", 0.0}, {"z", 0.6}, {"w", 0.8}};
      state["wireless_verse_grip"] = {
          {{"state", {{"orientation", turned}, {"buttons", {{"a", true}, {"b", false}, {"c", true}}}}}}};
    }
    return state.dump();
  }
  using Stream = boost::beast::websocket::stream<boost::asio::ip::tcp::socket>;

  /// A client's connection: reads whenever something comes, writes every two milliseconds.
  struct Client : std::enable_shared_from_this<Client> {
    Client(FakeHaplyService& owner, boost::asio::ip::tcp::socket socket)
        : service(owner), stream(std::move(socket)), timer(stream.get_executor()) {}
    void readNext() {
      stream.async_read(buffer, [self = shared_from_this()](const boost::system::error_code& error, std::size_t) {
        if (error) return self->end();
        self->service.take(boost::beast::buffers_to_string(self->buffer.data()));
        self->buffer.consume(self->buffer.size());
        self->readNext();
      });
    }
    void writeNext() {
      if (service.stopping_) return end();
      timer.expires_after(std::chrono::milliseconds(2));
      timer.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
        if (error || self->ended) return;
        if (self->service.silent) return self->writeNext();
        self->text = self->service.message();
        self->stream.async_write(
            boost::asio::buffer(self->text),
            [self](const boost::system::error_code& failed, std::size_t) { failed ? self->end() : self->writeNext(); });
      });
    }
    void end() {
      ended = true;
      boost::system::error_code ignored;
      stream.next_layer().close(ignored);
      timer.cancel();
    }
    FakeHaplyService& service;
    Stream stream;
    boost::asio::steady_timer timer;
    boost::beast::flat_buffer buffer;
    std::string text;
    bool ended = false;
  };

  void take(const std::string& text) {
    const std::scoped_lock lock(mutex_);
    command_ = nlohmann::json::parse(text, nullptr, false);
  }
  void serve() {
    while (!stopping_) {
      boost::system::error_code error;
      boost::asio::ip::tcp::socket socket(io_);
      acceptor_.accept(socket, error);
      if (!error) {
        socket.non_blocking(false);
        const auto client = std::make_shared<Client>(*this, std::move(socket));
        client->stream.accept(error);
        if (!error) client->readNext(), client->writeNext();
      }
      io_.restart();
      io_.run_for(std::chrono::milliseconds(5));
    }
    io_.restart();
    io_.run();  // Every connection ends at its next write.
  }

  boost::asio::io_context io_;
  boost::asio::ip::tcp::acceptor acceptor_;
  unsigned short port_ = 0;
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  std::mutex mutex_;
  std::string instead_;
  std::optional<nlohmann::json> command_;
};

}  // namespace hapticell::driver
