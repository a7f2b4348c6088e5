// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace hapticell::haptic {

/// What a network between two stations does to a TCP connection. Times in seconds.
struct LinkTrouble {
  double delay = 0.0;   ///< One way.
  double jitter = 0.0;  ///< As much again at most, drawn for each piece; the order is kept, as TCP does.
  double loss = 0.0;    ///< Part of the pieces that comes later by `retransmit`, with everything behind it.
  double retransmit = 0.2;
  std::uint32_t seed = 1;
};

/// A relay on this machine between a client and a server, which delays what passes and keeps what clients sent.
class LinkProxy {
 public:
  LinkProxy(std::uint16_t server_port, const LinkTrouble& trouble);
  ~LinkProxy();
  LinkProxy(const LinkProxy&) = delete;
  LinkProxy& operator=(const LinkProxy&) = delete;

  std::uint16_t port() const { return port_; }
  /// What the first client has sent so far.
  std::string sentByFirst() const;

 private:
  struct Pair;
  struct Direction;
  void accept();
  static void pump(const std::shared_ptr<Pair>& pair, Direction& direction);
  static void deliver(const std::shared_ptr<Pair>& pair, Direction& direction);
  double lateness();

  const std::uint16_t server_port_;
  const LinkTrouble trouble_;
  std::mt19937 random_;
  asio::io_context context_{1};
  asio::ip::tcp::acceptor acceptor_;
  std::uint16_t port_;
  mutable std::mutex mutex_;
  std::string first_;
  int accepted_ = 0;
  std::thread thread_;
};

}  // namespace hapticell::haptic
