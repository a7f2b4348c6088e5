// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "haptic/protocol/link_problem.h"

namespace hapticell::haptic {

/// Opens TCP connections to one haptic server, one attempt after another. Without a key it goes to this machine only.
/// Used and called back in the thread that runs the io_context; never blocks.
class ServerDialer {
 public:
  struct Handlers {
    std::function<void(asio::ip::tcp::socket)> connected;
    std::function<void(LinkProblem)> failed;
  };

  /// `host`: an IP address or a name. `has_key`: other machines may be called.
  ServerDialer(asio::io_context& context, std::string host, std::uint16_t port, bool has_key, Handlers handlers);

  /// Begins an attempt; one of the handlers is called once with its outcome.
  void dial();
  /// Ends an attempt that takes too long: it fails.
  void giveUp();
  bool isDialing() const { return dialing_; }
  /// Seconds since the attempt began.
  double dialingTime() const;

 private:
  void tryEndpoints(const asio::ip::tcp::resolver::results_type& endpoints);
  void fail(LinkProblem problem);
  std::string server() const { return host_ + ":" + std::to_string(port_); }

  asio::io_context& context_;
  const std::string host_;
  const std::uint16_t port_;
  const bool has_key_;
  const Handlers handlers_;
  asio::ip::tcp::resolver resolver_;
  asio::ip::tcp::socket socket_;
  std::chrono::steady_clock::time_point began_{};
  bool dialing_ = false;
};

}  // namespace hapticell::haptic
