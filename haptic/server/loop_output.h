// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "haptic/protocol/messages.h"
#include "haptic/rendering/triple_buffer.h"
#include "haptic/server/loop_statistics.h"

namespace hapticell::haptic {

/// Passes data from the force loop to other threads: its state with every tick, its figures ten times a second. The
/// newest wins; no thread waits.
class LoopOutput {
 public:
  explicit LoopOutput(double rate_hz) : statistics_(rate_hz) {}

  // Force thread; never allocates, locks or throws.
  LoopStatistics& statistics() noexcept { return statistics_; }
  void publish(const HapticState& state, std::int64_t late_ns, std::uint32_t skipped) noexcept {
    states_.write(state);
    statistics_.addTick(state.server_stamp_ns, late_ns, skipped);
    if (statistics_.due()) publishFigures(state.server_stamp_ns);
  }
  void publishFigures(std::int64_t now) noexcept {
    LoopFigures& figures = figures_.writeSlot();
    statistics_.collect(now, figures);
    report_.write(figures);
    figures_.publish();
  }

  // One thread for each.
  TripleBuffer<HapticState>& states() noexcept { return states_; }
  const TripleBuffer<HapticState>& states() const noexcept { return states_; }
  TripleBuffer<LoopFigures>& figures() noexcept { return figures_; }
  const TripleBuffer<LoopFigures>& figures() const noexcept { return figures_; }
  TripleBuffer<LoopFigures>& report() noexcept { return report_; }
  const TripleBuffer<LoopFigures>& report() const noexcept { return report_; }

 private:
  LoopStatistics statistics_;
  TripleBuffer<HapticState> states_;
  TripleBuffer<LoopFigures> figures_, report_;
};

}  // namespace hapticell::haptic
