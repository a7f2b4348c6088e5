// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

enum class FaultKind : std::uint8_t { kNone, kDevice, kMissedTicks, kInput, kSpeed };

/// "device", "missed ticks", "input", "speed".
const char* toString(FaultKind kind);

/// All data of one tick.
struct FaultSample {
  std::uint64_t tick = 0;
  std::int64_t stamp_ns = 0;
  Pose X_DS, X_DP;
  dvec3 wanted_D{0.0}, commanded_D{0.0};  ///< N.
  std::uint64_t adopted_set = 0;
  std::uint32_t rows = 0;     ///< Rows that hold the proxy.
  std::uint32_t skipped = 0;  ///< Ticks missed before this one.
  std::uint32_t buttons = 0;
  bool forces_on = false;
};

/// A fault with the ticks around it, oldest first.
struct FaultRecord {
  FaultKind kind = FaultKind::kNone;
  std::uint64_t tick = 0;  ///< Tick of the fault.
  std::vector<FaultSample> samples;
};

/// Keeps the last two seconds of the force loop. After a fault and 0.2 s more, it hands them over to be written to a
/// file. Two rings: while one is read, the other continues. The force thread calls add() and trigger() (no allocation,
/// no lock); one other thread calls pending(), copy() and release().
class FaultRecorder {
 public:
  explicit FaultRecorder(std::size_t kept = 2000, std::size_t after = 200);

  void add(const FaultSample& sample) noexcept;
  /// The first fault counts until it is handed over; further faults before it has been read are only counted.
  void trigger(FaultKind kind) noexcept;
  std::uint64_t faults() const noexcept { return faults_.load(std::memory_order_relaxed); }

  bool pending() const noexcept { return handed_.load(std::memory_order_acquire) >= 0; }
  /// The pending fault. Contract: pending() is true.
  FaultRecord copy() const;
  void release() noexcept { handed_.store(-1, std::memory_order_release); }

 private:
  struct Ring {
    std::vector<FaultSample> samples;
    std::uint64_t written = 0;
    FaultKind kind = FaultKind::kNone;
    std::uint64_t tick = 0;
  };
  std::array<Ring, 2> rings_;
  std::size_t active_ = 0;
  std::size_t after_;
  std::size_t left_ = 0;  // Ticks until the hand-over.
  std::atomic<int> handed_{-1};
  std::atomic<std::uint64_t> faults_{0};
};

}  // namespace hapticell::haptic
