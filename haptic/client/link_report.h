// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "haptic/transport/haptic_link.h"

namespace hapticell::haptic {

/// What a client's network thread says about its connection. The network thread writes, any thread reads; a reader
/// waits at most while one value is copied. Device, condition and role are those of the newest connection.
class LinkReport {
 public:
  /// Begins in kConnecting with this problem.
  explicit LinkReport(LinkProblem problem) : problem_(std::move(problem)) {}

  // Any thread.
  LinkState state() const { return state_.load(std::memory_order_acquire); }
  LinkProblem problem() const;                       ///< Empty if connected.
  std::optional<DeviceDescription> device() const;   ///< Empty if not connected.
  std::optional<DeviceCondition> condition() const;  ///< Empty if not connected or not yet received.
  ClientKind grantedKind() const;                    ///< kController before the first connection.
  /// The server granted control of the stylus.
  bool hasStylus() const { return has_stylus_; }
  std::uint64_t connections() const { return connections_; }

  // The network thread only.
  /// Not connected: in which state, and why.
  void become(LinkState state, LinkProblem problem);
  /// A new attempt begins: kConnecting instead of kDisconnected. A refusal stays to be read until the attempt has
  /// another outcome.
  void tryAgain();
  /// The server accepted this client: its device and role. Not yet kConnected; the condition is unknown.
  void take(const Welcome& welcome);
  void take(const DeviceCondition& condition);
  /// kConnected, and one connection more.
  void connect();

 private:
  std::atomic<LinkState> state_{LinkState::kConnecting};
  std::atomic<bool> has_stylus_{false};
  std::atomic<std::uint64_t> connections_{0};
  mutable std::mutex mutex_;
  LinkProblem problem_;
  Welcome welcome_;
  std::optional<DeviceCondition> condition_;
};

}  // namespace hapticell::haptic
