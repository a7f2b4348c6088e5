// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "haptic/protocol/messages.h"
#include "haptic/rendering/proxy_rows.h"
#include "haptic/rendering/triple_buffer.h"

namespace hapticell::haptic {

/// Passes data from the controlling client to the force loop: its session, its signs of life and the newest message of
/// each kind. The link thread writes, the force thread reads; neither ever waits, allocates or throws.
///
/// Messages have their session's number, so a late message of an earlier client is ignored.
class ClientInbox {
 public:
  // Link thread. `now`: the loop's clock, ns.
  void open(std::int64_t now) noexcept;
  void close() noexcept { session_.store(0, std::memory_order_release); }
  void heard(std::int64_t now) noexcept { last_heard_.store(now, std::memory_order_relaxed); }
  /// Sets how long this client may be silent, s; 0: as in the loop's options.
  void expectWithin(double seconds) noexcept { silence_limit_.store(seconds, std::memory_order_relaxed); }
  /// Checks and prepares the set here, so that the force thread need not.
  void submit(const ConstraintSet& set) noexcept;
  void submit(const HapticControl& control) noexcept { put(controls_, control); }
  void submit(const HandTarget& target) noexcept { put(targets_, target); }

  // Force thread.
  bool isOpen() const noexcept { return session_.load(std::memory_order_acquire) != 0; }
  /// True if a new session is open; its messages are used from now on.
  bool beginSession() noexcept;
  double silence(std::int64_t now) const noexcept;  ///< s since the client's last sign of life.
  double silenceLimit() const noexcept { return silence_limit_.load(std::memory_order_relaxed); }
  /// The newest message of the current session, once; null if there is no new one.
  const GroupedSet* takeSet() noexcept { return take(sets_); }
  const HapticControl* takeControl() noexcept { return take(controls_); }
  const HandTarget* takeHandTarget() noexcept { return take(targets_); }

 private:
  template <typename T>
  struct Incoming {
    std::uint64_t session = 0;
    T value;
  };
  template <typename T>
  struct Slot {
    TripleBuffer<Incoming<T>> buffer;
    bool waiting = false;  // Force thread only: the newest value is not used yet.
  };

  template <typename T>
  void put(Slot<T>& slot, const T& value) noexcept {
    Incoming<T>& incoming = slot.buffer.writeSlot();
    incoming.session = last_session_;
    incoming.value = value;
    slot.buffer.publish();
  }
  template <typename T>
  const T* take(Slot<T>& slot) noexcept {
    if (slot.buffer.update()) slot.waiting = true;
    // A message of a session that the loop has not begun yet waits for the next tick.
    if (!slot.waiting || slot.buffer.value().session != begun_) return nullptr;
    slot.waiting = false;
    return &slot.buffer.value().value;
  }

  std::atomic<std::uint64_t> session_{0};  // 0: closed; else counts the sessions.
  std::atomic<std::int64_t> last_heard_{0};
  std::atomic<double> silence_limit_{0.0};
  std::uint64_t last_session_ = 0;  // Link thread only.
  std::uint64_t begun_ = 0;         // Force thread only: the session whose messages it uses.
  Slot<GroupedSet> sets_;
  Slot<HapticControl> controls_;
  Slot<HandTarget> targets_;
};

}  // namespace hapticell::haptic
