// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hapticell::haptic {

/// Passes the newest value from one writer thread to one reader thread without a lock; neither ever waits.
///
/// Three slots, one owned by each side and one between them; an atomic word stores which slot is between and whether it
/// is fresh. T is copied, so it should not own heap memory if a real-time thread writes or reads it.
template <typename T>
class TripleBuffer {
 public:
  /// Writer only: the slot to fill in place; then publish().
  T& writeSlot() { return slots_[write_]; }

  /// Writer only: makes the filled slot the newest value.
  void publish() { write_ = middle_.exchange(static_cast<std::uint8_t>(write_ | kFresh)) & kIndex; }

  /// Writer only: copies and publishes.
  void write(const T& value) {
    writeSlot() = value;
    publish();
  }

  /// Reader only: takes the newest value and returns true if there is a new one since the last call.
  bool update() {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    read_ = middle_.exchange(read_) & kIndex;
    return true;
  }

  /// Reader only: the value taken last (a default-constructed one before the first).
  const T& value() const { return slots_[read_]; }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<T, 3> slots_{};
  std::uint8_t write_ = 0;
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t read_ = 2;
};

}  // namespace hapticell::haptic
