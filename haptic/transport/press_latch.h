// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace hapticell::haptic {

/// Keeps a press of a stylus's button until the client reads it: states arrive a thousand times a second, but a
/// client's loop may read only ten times, and short presses must not be lost. One thread writes, one reads; neither
/// waits.
class PressLatch {
 public:
  /// Buttons of the newest state (bit i: button i), each state once, in order.
  void hear(std::uint32_t buttons) {
    pressed_.fetch_or(buttons & ~before_, std::memory_order_relaxed);
    before_ = buttons;
  }
  /// Returns `buttons` of the state being read and those pressed since the last call.
  std::uint32_t take(std::uint32_t buttons) { return buttons | pressed_.exchange(0, std::memory_order_relaxed); }
  /// After a reconnection: forgets earlier presses. Called by the writing thread.
  void forget() {
    pressed_.store(0, std::memory_order_relaxed);
    before_ = 0;
  }

 private:
  std::atomic<std::uint32_t> pressed_{0};
  std::uint32_t before_ = 0;
};

}  // namespace hapticell::haptic
