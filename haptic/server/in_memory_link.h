// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "haptic/transport/haptic_link.h"
#include "haptic/transport/press_latch.h"
#include "haptic/protocol/codec.h"
#include "haptic/server/force_loop.h"

namespace hapticell::haptic {

/// Properties of the simulated network. Like TCP it keeps the order of messages.
struct InMemoryLinkOptions {
  double latency = 0.0;    ///< One way, seconds; 0: received at the next tick (server) or poll (client).
  double jitter = 0.0;     ///< Up to this much more, uniformly distributed, seconds.
  double loss = 0.0;       ///< Share of states, sets and hand targets that never arrive (0 to 1).
  std::uint64_t seed = 1;  ///< Same seed, same jitter and loss.
};

/// Joins a manipulation loop and a force loop in virtual time, in one thread; every message is encoded, decoded and
/// checked as on a socket.
///
/// step() advances by one tick. The session calls it 1000 times per second of virtual time and polls the client's side
/// at the client's rate. The link is connected from the start.
class InMemoryLink final : public HapticLink {
 public:
  /// `clock` must be the one that `loop` was made with; both must outlive the link. `device` is sent to the client.
  InMemoryLink(ForceLoop& loop, VirtualClock& clock, const DeviceDescription& device,
               const InMemoryLinkOptions& options = {});

  /// One tick of virtual time: advances the clock, passes arrived messages to the server, ticks the loop, sends its
  /// state. `skipped` ticks before it are missed, as when a real force thread is delayed.
  void step(std::uint32_t skipped = 0);

  /// The client's process stops (SIGSTOP) or continues. While stopped it sends nothing, not even heart-beats.
  void setSilent(bool silent) { silent_ = silent; }
  /// The socket closes (the client ends, or is killed); messages on the way are lost.
  void disconnect();
  /// The client connects again, as a new session.
  void connect();

  LinkState linkState() const override;
  LinkProblem problem() const override;
  std::optional<DeviceDescription> device() const override;
  std::optional<HapticState> latestState() override;
  std::optional<ServerStatistics> latestStatistics() override;
  void sendSet(const ConstraintSet& set) override;
  void sendControl(const HapticControl& control) override;
  void sendHandTarget(const HandTarget& target) override;

 private:
  struct Parcel {
    std::int64_t due = 0;
    std::vector<std::uint8_t> frame;
  };
  /// One direction: parcels in the order they were sent.
  struct Pipe {
    std::deque<Parcel> parcels;
    std::vector<std::vector<std::uint8_t>> spare;  // Memory of delivered frames, for reuse.
    std::int64_t last_due = 0;
  };

  void send(Pipe& pipe, std::span<const std::uint8_t> frame, bool may_be_lost);
  bool receive(Pipe& pipe, Message& message);
  void sendToServer(std::span<const std::uint8_t> frame, bool may_be_lost);
  void sendHeartbeat();
  void deliverToServer();
  void sendState();
  void receiveAtClient();
  double random() { return std::uniform_real_distribution<double>(0.0, 1.0)(generator_); }

  ForceLoop& loop_;
  VirtualClock& clock_;
  DeviceDescription device_;
  InMemoryLinkOptions options_;
  std::mt19937_64 generator_;
  Encoder encoder_;
  Pipe to_server_, to_client_;
  Message at_server_, at_client_;
  std::optional<HapticState> newest_state_;
  PressLatch presses_;
  std::optional<ServerStatistics> newest_statistics_;
  bool connected_ = false, silent_ = false;
  std::int64_t next_heartbeat_ = 0;
};

}  // namespace hapticell::haptic
