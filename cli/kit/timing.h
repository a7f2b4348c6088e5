// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <vector>

namespace hapticell::cli {

/// Collects the durations of queries, on the steady clock.
class Timing {
 public:
  using Clock = std::chrono::steady_clock;

  void reserve(std::size_t count) { durations_us_.reserve(count); }
  void add(Clock::time_point begin) {
    durations_us_.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  void addMicroseconds(double duration) { durations_us_.push_back(duration); }
  /// `median_us`, `p99_us` (nearest rank), `max_us`; zeros where nothing was timed.
  nlohmann::ordered_json toJson() const;

 private:
  std::vector<double> durations_us_;
};

}  // namespace hapticell::cli
