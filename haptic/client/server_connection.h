// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "haptic/client/link_mailboxes.h"
#include "haptic/client/link_report.h"
#include "haptic/client/server_dialer.h"
#include "haptic/client/tcp_link.h"
#include "haptic/protocol/heartbeat.h"
#include "haptic/transport/message_stream.h"
#include "haptic/transport/secure_stream.h"

namespace hapticell::haptic {

/// The network thread of a client: keeps one connection to its haptic server alive, reports on it in `report` and moves
/// the newest values through `mailboxes`. No call waits for the network; the destructor waits for the thread.
class ServerConnection {
 public:
  /// Starts the thread, which begins to connect.
  explicit ServerConnection(const TcpLinkOptions& options);
  ~ServerConnection();

  /// Sends `value` through `outbox`, one of `mailboxes`; the newest wins. Dropped if not connected, or if another
  /// client controls the stylus. The client's thread only.
  template <typename T>
  void submit(TripleBuffer<T>& outbox, const T& value) {
    if (report.state() != LinkState::kConnected || !report.hasStylus()) return;
    outbox.write(value);
    if (!wake_pending_.exchange(true)) asio::post(context_, [this] { sendNewest(); });
  }
  /// Reports that the user has done calibration step `step`. Any thread.
  void calibrate(std::uint32_t step);
  /// Reconnects and takes control of the stylus. Any thread.
  void takeOver();

  LinkReport report;
  LinkMailboxes mailboxes;

 private:
  std::string server() const { return options_.host + ":" + std::to_string(options_.port); }
  void run();
  void connect();
  void open(asio::ip::tcp::socket socket);
  void hear(const Message& message);
  void hearWelcome(const Welcome& welcome);
  void hearState(const HapticState& state);
  void disconnect(LinkProblem problem, LinkState state = LinkState::kDisconnected);
  void sendNewest();
  void sendHeartbeat();
  void beat();

  const TcpLinkOptions options_;
  asio::io_context context_{1};
  ServerDialer dialer_;
  asio::steady_timer retry_timer_, heartbeat_timer_;
  std::optional<SecureStreams> secure_;
  std::shared_ptr<MessageStream> stream_;
  Encoder encoder_;
  HeartbeatExchange heartbeat_;
  std::int64_t heard_ = 0;
  bool welcomed_ = false, take_over_ = false;
  bool wants_forces_ = false, forces_on_ = false;  // What was sent last, and whether there may be any.
  std::atomic<bool> wake_pending_{false};
  std::thread thread_;
};

}  // namespace hapticell::haptic
