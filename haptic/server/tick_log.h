// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// Record of one tick, for analysis after a fault and for tests.
struct TickRecord {
  std::uint64_t tick = 0;
  std::int64_t stamp_ns = 0;
  dvec3 force_D{0.0};  ///< To the device, N.
  bool link_open = false;
  double link_silence = 0.0;  ///< s.
  bool forces_on = false;
};

/// The last ticks, in a ring of fixed size. Written by the force loop's thread; read after that has stopped.
class TickLog {
 public:
  explicit TickLog(std::size_t capacity) : ring_(capacity > 0 ? capacity : 1) {}

  void add(const TickRecord& record) noexcept { ring_[written_++ % ring_.size()] = record; }

  std::size_t size() const { return written_ < ring_.size() ? written_ : ring_.size(); }

  /// The i-th oldest tick in the ring, i < size().
  const TickRecord& at(std::size_t i) const { return ring_[(written_ - size() + i) % ring_.size()]; }

 private:
  std::vector<TickRecord> ring_;
  std::size_t written_ = 0;
};

}  // namespace hapticell::haptic
