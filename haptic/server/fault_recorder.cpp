// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/fault_recorder.h"

#include <algorithm>

#include "geometry/system/assertion.h"

namespace hapticell::haptic {

const char* toString(FaultKind kind) {
  switch (kind) {
    case FaultKind::kDevice:
      return "device";
    case FaultKind::kMissedTicks:
      return "missed ticks";
    case FaultKind::kInput:
      return "input";
    case FaultKind::kSpeed:
      return "speed";
    case FaultKind::kNone:
      break;
  }
  return "none";
}

FaultRecorder::FaultRecorder(std::size_t kept, std::size_t after) : after_(after) {
  for (Ring& ring : rings_) ring.samples.resize(std::max<std::size_t>(1, kept + after));
}

void FaultRecorder::add(const FaultSample& sample) noexcept {
  Ring& ring = rings_[active_];
  ring.samples[ring.written++ % ring.samples.size()] = sample;
  if (ring.kind == FaultKind::kNone || left_-- > 0) return;
  handed_.store(static_cast<int>(active_), std::memory_order_release);
  active_ = 1 - active_;
  rings_[active_].written = 0;
  rings_[active_].kind = FaultKind::kNone;
}

void FaultRecorder::trigger(FaultKind kind) noexcept {
  faults_.fetch_add(1, std::memory_order_relaxed);
  Ring& ring = rings_[active_];
  if (ring.kind != FaultKind::kNone || pending()) return;
  ring.kind = kind;
  ring.tick = ring.written > 0 ? ring.samples[(ring.written - 1) % ring.samples.size()].tick + 1 : 0;
  left_ = after_;
}

FaultRecord FaultRecorder::copy() const {
  const int handed = handed_.load(std::memory_order_acquire);
  HAPTICELL_DEMAND(handed >= 0);
  const Ring& ring = rings_[static_cast<std::size_t>(handed)];
  FaultRecord record{ring.kind, ring.tick, {}};
  const std::size_t size = ring.samples.size();
  const std::uint64_t count = std::min<std::uint64_t>(ring.written, size);
  for (std::uint64_t i = ring.written - count; i < ring.written; ++i) record.samples.push_back(ring.samples[i % size]);
  return record;
}

}  // namespace hapticell::haptic
