// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <exception>

namespace hapticell::feel {

/// The measurement of this thread was asked to end; runBenchmark() catches it.
struct MeasurementStopped : std::exception {
  const char* what() const noexcept override { return "stopped"; }
};

/// While it lives, sessions of this thread end by MeasurementStopped once `stop` is true (null: never). A measurement has
/// many sessions, deep in many functions, and none of them has anything to give back when it is stopped.
class StopOfThread {
 public:
  explicit StopOfThread(const std::atomic<bool>* stop);
  ~StopOfThread();
  StopOfThread(const StopOfThread&) = delete;
  StopOfThread& operator=(const StopOfThread&) = delete;

 private:
  const std::atomic<bool>* before_;
};

/// Called once a tick of virtual time; never in a force loop that renders for a device.
void endWhereStopped();

}  // namespace hapticell::feel
