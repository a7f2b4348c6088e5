// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace hapticell::haptic {

/// Keeps a press of a stylus's button until somebody looks: states come a thousand times a second, a client's loop may
/// look ten times, and a short press between two looks is meant as well. One thread hears, one takes; neither waits.
class PressLatch {
 public:
  /// Buttons of the newest state (bit i: button i), each state once, in order.
  void hear(std::uint32_t buttons) {
    pressed_.fetch_or(buttons & ~before_, std::memory_order_relaxed);
    before_ = buttons;
  }
  /// `buttons` of the state that is looked at, and what was newly pressed since the last look.
  std::uint32_t take(std::uint32_t buttons) { return buttons | pressed_.exchange(0, std::memory_order_relaxed); }
  /// Another connection: what was pressed before it is not meant. By the thread that hears.
  void forget() {
    pressed_.store(0, std::memory_order_relaxed);
    before_ = 0;
  }

 private:
  std::atomic<std::uint32_t> pressed_{0};
  std::uint32_t before_ = 0;
};

}  // namespace hapticell::haptic
