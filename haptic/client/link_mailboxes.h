// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "haptic/protocol/messages.h"
#include "haptic/rendering/triple_buffer.h"
#include "haptic/transport/press_latch.h"

namespace hapticell::haptic {

/// The newest values on their way between a client's thread and its network thread; neither ever waits. What is
/// received is written by the network thread and read by the client's; what is sent, the other way round.
struct LinkMailboxes {
  // Received.
  TripleBuffer<HapticState> states;
  PressLatch presses;  ///< Hears each state that is written to `states`.
  TripleBuffer<ServerStatistics> statistics;
  // To be sent.
  TripleBuffer<ConstraintSet> sets;
  TripleBuffer<HapticControl> controls;
  TripleBuffer<HandTarget> targets;

  /// Reader of `inbox` only: its newest value, if there is one since the last call.
  template <typename T>
  static std::optional<T> newest(TripleBuffer<T>& inbox) {
    return inbox.update() ? std::optional<T>(inbox.value()) : std::nullopt;
  }

  /// The network thread, at the begin of a connection: what an earlier one left unsent is not for this one.
  void beginConnection() {
    sets.update();
    controls.update();
    targets.update();
    presses.forget();
  }
};

}  // namespace hapticell::haptic
