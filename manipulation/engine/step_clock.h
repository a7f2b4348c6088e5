// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::manipulation {

/// The times of an engine's steps, by the caller's steady clock. A value.
class StepClock {
 public:
  /// A step begins.
  void tick(std::int64_t now_ns);

  /// ns by the caller's clock; 0 before the first step.
  std::int64_t now() const { return now_ns_; }
  /// Steps begun.
  std::uint64_t steps() const { return steps_; }
  /// s since the first step; 0 before it.
  double sinceStart() const;
  /// Time that the joints may use in this step, s; limited, so that after a delay they do not catch up at once.
  double stepTime() const;

 private:
  std::int64_t now_ns_ = 0;
  std::int64_t last_step_ns_ = 0;
  std::int64_t start_ns_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace hapticell::manipulation
