// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "haptic/protocol/device_condition.h"

namespace hapticell::haptic {

/// Passes a device's condition and the user's calibration steps between the thread that drives the device and the user
/// interface. Any thread; the force loop calls nothing here.
class DeviceCare {
 public:
  /// Counts up at each change of the condition.
  std::uint64_t changes() const { return changes_.load(std::memory_order_acquire); }
  DeviceCondition condition() const {
    const std::scoped_lock lock(mutex_);
    return condition_;
  }
  /// Driver's side: sets the condition; an equal one changes nothing.
  void tell(const DeviceCondition& condition) {
    const std::scoped_lock lock(mutex_);
    if (condition == condition_) return;
    condition_ = condition;
    changes_.fetch_add(1, std::memory_order_release);
  }

  /// The user has done step `step` of DeviceCondition::calibration.
  void calibrate(std::uint32_t step) { asked_.store(static_cast<std::int64_t>(step), std::memory_order_release); }
  /// Driver's side: the step that was requested since the last call.
  std::optional<std::uint32_t> takeCalibration() {
    if (asked_.load(std::memory_order_acquire) < 0) return std::nullopt;
    const std::int64_t step = asked_.exchange(-1);
    return step < 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(step));
  }

 private:
  mutable std::mutex mutex_;
  DeviceCondition condition_;
  std::atomic<std::uint64_t> changes_{0};
  std::atomic<std::int64_t> asked_{-1};
};

}  // namespace hapticell::haptic
