// SPDX-License-Identifier: Apache-2.0
#include "tests/haptic/server/link_proxy.h"

#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>
#include <chrono>
#include <deque>

namespace hapticell::haptic {

using asio::ip::tcp;
using std::chrono::steady_clock;

/// One way through the proxy: pieces wait until they are due, none before the one ahead of it.
struct LinkProxy::Direction {
  Direction(asio::io_context& context, tcp::socket& source, tcp::socket& target)
      : from(source), to(target), timer(context) {}
  struct Piece {
    steady_clock::time_point due;
    std::string bytes;
  };
  tcp::socket& from;
  tcp::socket& to;
  asio::steady_timer timer;
  std::array<char, 8192> incoming{};
  std::deque<Piece> waiting;
  bool delivering = false, ended = false;
  std::string outgoing;
};

struct LinkProxy::Pair {
  explicit Pair(LinkProxy& owner, tcp::socket accepted)
      : proxy(owner),
        client(std::move(accepted)),
        server(owner.context_),
        up(owner.context_, client, server),
        down(owner.context_, server, client) {}
  LinkProxy& proxy;
  tcp::socket client, server;
  Direction up, down;
  bool first = false;
};

LinkProxy::LinkProxy(std::uint16_t server_port, const LinkTrouble& trouble)
    : server_port_(server_port),
      trouble_(trouble),
      random_(trouble.seed),
      acceptor_(context_, tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
      port_(acceptor_.local_endpoint().port()) {
  accept();
  thread_ = std::thread([this] { context_.run(); });
}

LinkProxy::~LinkProxy() {
  asio::post(context_, [this] { context_.stop(); });
  thread_.join();
}

std::string LinkProxy::sentByFirst() const {
  const std::scoped_lock lock(mutex_);
  return first_;
}

double LinkProxy::lateness() {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double lost = unit(random_) < trouble_.loss ? trouble_.retransmit : 0.0;
  return trouble_.delay + trouble_.jitter * unit(random_) + lost;
}

void LinkProxy::accept() {
  acceptor_.async_accept([this](std::error_code failed, tcp::socket socket) {
    if (failed) return;
    auto pair = std::make_shared<Pair>(*this, std::move(socket));
    pair->first = accepted_++ == 0;
    pair->server.async_connect({asio::ip::address_v4::loopback(), server_port_}, [pair](std::error_code refused) {
      if (refused) return;
      std::error_code ignored;
      pair->client.set_option(tcp::no_delay(true), ignored);
      pair->server.set_option(tcp::no_delay(true), ignored);
      pump(pair, pair->up);
      pump(pair, pair->down);
    });
    accept();
  });
}

void LinkProxy::pump(const std::shared_ptr<Pair>& pair, Direction& direction) {
  direction.from.async_read_some(
      asio::buffer(direction.incoming), [pair, &direction](std::error_code failed, std::size_t count) {
        LinkProxy& proxy = pair->proxy;
        std::string bytes(direction.incoming.data(), failed ? 0 : count);
        if (pair->first && &direction == &pair->up) {
          const std::scoped_lock lock(proxy.mutex_);
          proxy.first_ += bytes;
        }
        auto due = steady_clock::now() +
                   std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(proxy.lateness()));
        if (!direction.waiting.empty()) due = std::max(due, direction.waiting.back().due);
        direction.ended = static_cast<bool>(failed);
        direction.waiting.push_back({due, std::move(bytes)});
        if (!direction.delivering) deliver(pair, direction);
        if (!failed) pump(pair, direction);
      });
}

void LinkProxy::deliver(const std::shared_ptr<Pair>& pair, Direction& direction) {
  direction.delivering = !direction.waiting.empty();
  if (!direction.delivering) return;
  direction.timer.expires_at(direction.waiting.front().due);
  direction.timer.async_wait([pair, &direction](std::error_code) {
    direction.outgoing = std::move(direction.waiting.front().bytes);
    direction.waiting.pop_front();
    if (direction.outgoing.empty()) {
      std::error_code ignored;
      direction.to.shutdown(tcp::socket::shutdown_send, ignored);
      return;
    }
    asio::async_write(direction.to, asio::buffer(direction.outgoing),
                      [pair, &direction](std::error_code, std::size_t) { deliver(pair, direction); });
  });
}

}  // namespace hapticell::haptic
