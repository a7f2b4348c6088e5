// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace hapticell::haptic {

/// Steady clock for the force loop: the machine's, or one that a test advances.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Nanoseconds since some fixed moment; never goes back. Neither allocates nor locks; any thread.
  virtual std::int64_t now() const noexcept = 0;
};

/// CLOCK_MONOTONIC.
class RealClock final : public Clock {
 public:
  std::int64_t now() const noexcept override {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
};

/// Advances only by calls. One thread.
class VirtualClock final : public Clock {
 public:
  std::int64_t now() const noexcept override { return now_; }
  void advance(std::int64_t nanoseconds) { now_ += nanoseconds; }

 private:
  std::int64_t now_ = 1'000'000'000;  // Not zero, because zero means "never" in stamps.
};

inline constexpr double kSecondsPerNanosecond = 1e-9;

inline constexpr std::int64_t toNanoseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5));
}

}  // namespace hapticell::haptic
