// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/network_server.h"

#include <pthread.h>
#include <sys/prctl.h>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <chrono>
#include <thread>
#include <utility>

#include "haptic/server/client_table.h"
#include "haptic/server/clock.h"
#include "haptic/server/force_loop.h"
#include "haptic/transport/secure_stream.h"

namespace hapticell::haptic {

using asio::ip::tcp;

namespace {

// Between looks at the loop while nobody is connected, and between looks for silent clients: a quick heart's beat,
// within the 50 ms of a lost client. Half: twice the wake-ups; twice: a dead client is noticed up to 10 ms later.
constexpr std::chrono::milliseconds kIdlePeriod(10);
constexpr std::chrono::milliseconds kSweepPeriod(10);
// Between two connections that are taken while others must make room: each has then max_waiting_of_address times this
// for its handshake, however many knock.
constexpr std::chrono::milliseconds kCrowdPeriod(1);
// Connections that the kernel keeps: at kCrowdPeriod they are taken within a quarter of a second, before a client gives
// up. Half: a crowd is refused sooner; twice: the last waits half a second.
constexpr int kBacklog = 256;

std::string endpointText(const NetworkOptions& options) {
  return options.address + ":" + std::to_string(options.port);
}

Expected<tcp::endpoint> endpointOf(const NetworkOptions& options) {
  std::error_code failed;
  const auto address = asio::ip::make_address(options.address == "localhost" ? "127.0.0.1" : options.address, failed);
  if (failed) {
    return makeError({.file = endpointText(options),
                      .found = "not an IP address",
                      .expected = "an address of this machine, such as 127.0.0.1"});
  }
  if (!address.is_loopback() && !options.key) {
    return makeError({.file = endpointText(options),
                      .found = "an address that other machines can reach, so anybody could control the stylus",
                      .expected = "an address of this machine only (127.0.0.1 or ::1)",
                      .fix = "First create a key: hapticell-haptic-server --pair."});
  }
  return tcp::endpoint(address, options.port);
}

Error cannotListen(const NetworkOptions& options, const std::error_code& failed) {
  return {.file = endpointText(options),
          .found = Text("cannot listen at this address: %1", failed.message()),
          .fix = "Another haptic server may be running. Stop it, or set another --port (0: any free port)."};
}

}  // namespace

class NetworkServer::Implementation {
 public:
  Implementation(ForceLoop& loop, const Clock& clock, const DeviceDescription& device, const NetworkOptions& options)
      : device_(device),
        options_(options),
        acceptor_(context_),
        accept_again_(context_),
        broadcast_timer_(context_),
        sweep_timer_(context_),
        table_(std::make_unique<ClientTable>(loop, clock, device_, options_)) {
    if (options_.key) secure_.emplace(SecureStreams::Side::kServer, *options_.key);
  }

  Expected<void> start() {
    const auto endpoint = endpointOf(options_);
    HAPTICELL_TRY(endpoint);
    std::error_code failed;
    acceptor_.open(endpoint->protocol(), failed);
    if (!failed) acceptor_.set_option(asio::socket_base::reuse_address(true), failed);
    if (!failed) acceptor_.bind(*endpoint, failed);
    if (!failed) acceptor_.listen(kBacklog, failed);
    if (!failed) options_.port = acceptor_.local_endpoint(failed).port();
    if (failed) return makeError(cannotListen(options_, failed));
    accept();
    broadcast();
    sweep();
    thread_ = std::thread([this] { run(); });
    return {};
  }

  ~Implementation() {
    asio::post(context_, [this] { context_.stop(); });
    if (thread_.joinable()) thread_.join();
    table_.reset();  // Before the context that its sockets belong to.
  }

  const NetworkOptions& options() const { return options_; }

 private:
  void run() {
    pthread_setname_np(pthread_self(), "network");
    prctl(PR_SET_TIMERSLACK, 1);
    if (options_.priority > 0) {
      sched_param parameter{};
      parameter.sched_priority = options_.priority;
      pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);  // Not granted: the runner says so already.
    }
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception& failure) {
        if (options_.report) options_.report(std::string("The network thread goes on after: ") + failure.what());
      }
    }
  }

  void accept() {
    acceptor_.async_accept([this](std::error_code failed, tcp::socket socket) {
      if (failed == asio::error::operation_aborted) return;
      // Out of file descriptors, mostly: some client will go.
      if (failed) return acceptLater(std::chrono::milliseconds(100));
      const bool room = table_->add(secure_ ? secure_->make(std::move(socket)) : plainStream(std::move(socket)));
      room ? accept() : acceptLater(kCrowdPeriod);
    });
  }

  void acceptLater(std::chrono::milliseconds wait) {
    accept_again_.expires_after(wait);
    accept_again_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) accept();
    });
  }

  void broadcast() {
    table_->broadcast();
    const auto period = std::chrono::nanoseconds(toNanoseconds(1.0 / options_.state_rate_hz));
    const auto now = std::chrono::steady_clock::now();
    next_broadcast_ += period;
    if (next_broadcast_ < now) next_broadcast_ = now + period;
    broadcast_timer_.expires_at(table_->empty() ? now + kIdlePeriod : next_broadcast_);
    broadcast_timer_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) broadcast();
    });
  }

  void sweep() {
    table_->sweep();
    sweep_timer_.expires_after(kSweepPeriod);
    sweep_timer_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) sweep();
    });
  }

  const DeviceDescription device_;
  NetworkOptions options_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer accept_again_, broadcast_timer_, sweep_timer_;
  std::chrono::steady_clock::time_point next_broadcast_{};
  std::optional<SecureStreams> secure_;
  std::unique_ptr<ClientTable> table_;
  std::thread thread_;
};

NetworkServer::NetworkServer(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

NetworkServer::~NetworkServer() = default;

Expected<std::unique_ptr<NetworkServer>> NetworkServer::start(ForceLoop& loop, const Clock& clock,
                                                              const DeviceDescription& device,
                                                              const NetworkOptions& options) {
  auto implementation = std::make_unique<Implementation>(loop, clock, device, options);
  HAPTICELL_TRY(implementation->start());
  return std::unique_ptr<NetworkServer>(new NetworkServer(std::move(implementation)));
}

std::uint16_t NetworkServer::port() const {
  return implementation_->options().port;
}

const std::string& NetworkServer::address() const {
  return implementation_->options().address;
}

}  // namespace hapticell::haptic
