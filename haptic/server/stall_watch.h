// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "haptic/devices/device.h"

namespace hapticell::haptic {

/// If kStall ticks are missed at once (a stalled machine), switches the motors of a hardware device off until the
/// client disables and enables forces again. For a simulated device it only counts.
///
/// Force thread; never allocates, locks or throws.
class StallWatch {
 public:
  /// Ticks: 20 ms as kFreshFor, and as libfranka stops a robot (Reliability). Half: a busy desktop trips more often;
  /// twice: an old force acts 40 ms.
  static constexpr std::uint32_t kStall = 20;

  /// `device` must outlive this.
  explicit StallWatch(Device& device) : device_(device), simulated_(device.simulated() != nullptr) {}

  /// `skipped` ticks were missed before this one. True if the motors go off now.
  bool note(std::uint32_t skipped, bool forces_enabled) noexcept {
    const bool stalled = skipped >= kStall;
    if (stalled) ++stalls_;
    const bool goes_off = stalled && !simulated_ && !motors_off_;
    if (goes_off) switchMotors(false);
    // The client has disabled forces.
    if (motors_off_ && !forces_enabled) switchMotors(true);
    return goes_off;
  }

  bool motorsOff() const { return motors_off_; }
  std::uint64_t stalls() const { return stalls_; }

 private:
  void switchMotors(bool on) noexcept {
    motors_off_ = !on;
    device_.setMotors(on);
  }

  Device& device_;
  const bool simulated_;
  bool motors_off_ = false;
  std::uint64_t stalls_ = 0;
};

}  // namespace hapticell::haptic
