// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "haptic/rendering/safety_chain.h"
#include "haptic/server/fault_recorder.h"
#include "haptic/server/tick_log.h"

namespace hapticell::haptic {

/// Records each tick: in the log, and for the ticks around a fault.
///
/// Force thread; never allocates, locks or throws. One other thread may use faults(), see FaultRecorder.
class TickRecorder {
 public:
  explicit TickRecorder(std::size_t log_ticks) : log_(log_ticks) {}

  void log(const TickRecord& record) noexcept { log_.add(record); }
  /// A fault found by the safety chain begins with the tick that finds it.
  void record(const SafetyResult& safety, const FaultSample& sample) noexcept {
    if (safety.input_fault && !input_fault_) faults_.trigger(FaultKind::kInput);
    if (safety.too_fast && !too_fast_) faults_.trigger(FaultKind::kSpeed);
    input_fault_ = safety.input_fault;
    too_fast_ = safety.too_fast;
    faults_.add(sample);
  }

  const TickLog& ticks() const { return log_; }
  FaultRecorder& faults() noexcept { return faults_; }

 private:
  TickLog log_;
  FaultRecorder faults_;
  bool input_fault_ = false, too_fast_ = false;  // Of the last tick.
};

}  // namespace hapticell::haptic
