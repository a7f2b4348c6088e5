// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/viewer_server.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <future>
#include <set>
#include <thread>

#include "bridge/foxglove/viewer_session.h"

namespace hapticell::bridge {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

bool isThisMachine(const std::string& host) {
  error_code failed;
  const auto address = asio::ip::make_address(host, failed);
  return !failed && address.is_loopback();
}

std::vector<std::string> addressesForOthers() {
  std::vector<std::string> found;
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return found;
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(list, &::freeifaddrs);
  for (const ifaddrs* one = list; one; one = one->ifa_next) {
    if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
    if ((one->ifa_flags & IFF_UP) == 0 || (one->ifa_flags & IFF_LOOPBACK) != 0) continue;
    char text[INET_ADDRSTRLEN] = {};
    ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr, text, sizeof text);
    found.emplace_back(text);
  }
  return found;
}

/// Everything but the counters belongs to the network thread.
class ViewerServer::Impl : public std::enable_shared_from_this<ViewerServer::Impl> {
 public:
  explicit Impl(std::string code) : code_(std::move(code)), acceptor_(io_) {}

  Expected<void> open(const ViewerAddress& address) {
    error_code failed;
    const auto host = asio::ip::make_address(address.host, failed);
    if (failed) return makeError({.file = address.host, .found = "no IP address", .expected = "127.0.0.1, 0.0.0.0 or an address of this machine"});
    const tcp::endpoint where(host, address.port);
    const auto refused = [&] {
      return makeError({.file = address.host + ":" + std::to_string(address.port),
                        .found = systemText(failed.value()),
                        .expected = "an address of this machine and a free port",
                        .fix = "Choose another port, or end the program that uses it."});
    };
    if (acceptor_.open(where.protocol(), failed)) return refused();
    acceptor_.set_option(tcp::acceptor::reuse_address(true), failed);
    if (acceptor_.bind(where, failed)) return refused();
    if (acceptor_.listen(asio::socket_base::max_listen_connections, failed)) return refused();
    port_ = acceptor_.local_endpoint(failed).port();
    return {};
  }

  void start() {
    accept();
    thread_ = std::thread([this] { io_.run(); });
  }

  void stop() {
    asio::post(io_, [self = shared_from_this()] {
      error_code ignored;
      self->acceptor_.close(ignored);
      for (const auto& session : self->sessions_) session->close();
      self->sessions_.clear();
    });
    if (thread_.joinable()) thread_.join();  // The last operation ends with the last socket.
  }

  void post(std::function<void(Impl&)> work) {
    asio::post(io_, [self = shared_from_this(), work = std::move(work)] { work(*self); });
  }

  std::uint32_t addTopic(const ViewerTopic& topic) {
    const std::uint32_t id = ++topic_count_;
    post([id, topic](Impl& me) {
      me.board_.topics.push_back({id, topic, {}});
      for (const auto& session : me.sessions_) session->advertise({id, topic, {}});
    });
    return id;
  }

  void publish(std::uint32_t topic, std::int64_t stamp_ns, std::string message, const std::string& key) {
    const ViewerMessage sent{topic, stamp_ns, std::make_shared<const std::string>(std::move(message)), key};
    post([sent](Impl& me) {
      if (!sent.key.empty()) me.board_.keep(sent);
      for (const auto& session : me.sessions_) session->send(sent);
    });
  }

  std::uint16_t port() const { return port_; }
  std::size_t viewers() const { return counts_.viewers; }
  std::uint64_t sent() const { return counts_.sent; }
  std::uint64_t dropped() const { return counts_.dropped; }

 private:
  /// A seventeenth viewer is refused. Half: fewer than a class of trainees; twice: each costs the messages again.
  static constexpr std::size_t kMostViewers = 16;

  void accept() {
    acceptor_.async_accept([self = shared_from_this()](error_code failed, tcp::socket socket) {
      if (!self->acceptor_.is_open()) return;
      if (!failed) self->welcome(std::move(socket));
      self->accept();
    });
  }

  void welcome(tcp::socket socket) {
    std::erase_if(sessions_, [](const auto& session) { return session->isClosed(); });
    if (sessions_.size() >= kMostViewers) return;  // The socket closes.
    const auto session = std::make_shared<ViewerSession>(std::move(socket), code_, board_, counts_);
    sessions_.insert(session);
    session->start();
  }

  const std::string code_;
  asio::io_context io_;
  tcp::acceptor acceptor_;
  std::thread thread_;
  std::uint16_t port_ = 0;
  std::atomic<std::uint32_t> topic_count_{0};
  ViewerBoard board_;
  ViewerCounts counts_;
  std::set<std::shared_ptr<ViewerSession>> sessions_;
};

ViewerServer::ViewerServer(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

ViewerServer::~ViewerServer() {
  impl_->stop();
}

Expected<std::unique_ptr<ViewerServer>> ViewerServer::listen(const ViewerAddress& address) {
  if (address.code.empty() && !isThisMachine(address.host))
    return makeError({.file = address.host, .found = "an address that other machines reach, without a code",
                      .expected = "a code that viewers have to name"});
  auto impl = std::make_shared<Impl>(address.code);
  HAPTICELL_TRY(impl->open(address));
  impl->start();
  return std::unique_ptr<ViewerServer>(new ViewerServer(std::move(impl)));
}

std::uint32_t ViewerServer::addTopic(const ViewerTopic& topic) {
  return impl_->addTopic(topic);
}

void ViewerServer::publish(std::uint32_t topic, std::int64_t stamp_ns, std::string message) {
  impl_->publish(topic, stamp_ns, std::move(message), {});
}

void ViewerServer::keep(std::uint32_t topic, const std::string& key, std::int64_t stamp_ns, std::string message) {
  impl_->publish(topic, stamp_ns, std::move(message), key);
}

std::uint16_t ViewerServer::port() const {
  return impl_->port();
}

std::size_t ViewerServer::viewers() const {
  return impl_->viewers();
}

std::uint64_t ViewerServer::sent() const {
  return impl_->sent();
}

std::uint64_t ViewerServer::dropped() const {
  return impl_->dropped();
}

}  // namespace hapticell::bridge
