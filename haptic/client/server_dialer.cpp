// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_dialer.h"

#include <algorithm>
#include <asio/connect.hpp>
#include <system_error>
#include <utility>

#include "haptic/client/server_problems.h"

namespace hapticell::haptic {

using asio::ip::tcp;

ServerDialer::ServerDialer(asio::io_context& context, std::string host, std::uint16_t port, bool has_key,
                           Handlers handlers)
    : context_(context),
      host_(std::move(host)),
      port_(port),
      has_key_(has_key),
      handlers_(std::move(handlers)),
      resolver_(context),
      socket_(context) {}

void ServerDialer::dial() {
  began_ = std::chrono::steady_clock::now();
  dialing_ = true;
  resolver_.async_resolve(host_, std::to_string(port_),
                          [this](std::error_code failed, const tcp::resolver::results_type& endpoints) {
                            if (failed) return fail(noServerAt(server()));
                            tryEndpoints(endpoints);
                          });
}

void ServerDialer::tryEndpoints(const tcp::resolver::results_type& endpoints) {
  const bool leaves = std::any_of(endpoints.begin(), endpoints.end(),
                                  [](const auto& entry) { return !entry.endpoint().address().is_loopback(); });
  if (leaves && !has_key_) return fail(noKeyFor(server()));
  socket_ = tcp::socket(context_);
  asio::async_connect(socket_, endpoints, [this](std::error_code failed, const tcp::endpoint&) {
    if (failed) return fail(noServerAt(server()));
    dialing_ = false;
    handlers_.connected(std::move(socket_));
  });
}

void ServerDialer::giveUp() {
  std::error_code ignored;
  socket_.close(ignored);
}

double ServerDialer::dialingTime() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

void ServerDialer::fail(LinkProblem problem) {
  dialing_ = false;
  handlers_.failed(std::move(problem));
}

}  // namespace hapticell::haptic
