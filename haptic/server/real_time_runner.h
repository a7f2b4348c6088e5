// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "geometry/system/text.h"

namespace hapticell::haptic {

class ForceLoop;

/// What the force thread requests from the system.
struct RealTimeOptions {
  bool fifo = true;         ///< SCHED_FIFO with `priority`.
  int priority = 80;        ///< Above the machine's ordinary threads, below its watchdogs.
  bool lock_memory = true;  ///< mlockall(), so that no page fault occurs within a tick.
};

/// Runs a force loop in its own thread, one tick at each absolute deadline.
///
/// If the system does not grant a request, the runner works without it and warnings() lists it. Missed ticks are
/// skipped and counted, never replayed. The loop must use a RealClock.
class RealTimeRunner {
 public:
  explicit RealTimeRunner(ForceLoop& loop, const RealTimeOptions& options = {});
  ~RealTimeRunner();  ///< Stops.
  RealTimeRunner(const RealTimeRunner&) = delete;
  RealTimeRunner& operator=(const RealTimeRunner&) = delete;

  /// Starts the thread; returns when the system has granted or refused its requests.
  void start();
  /// Ends the thread: force zero, motors off. May be called more than once.
  void stop();

  /// A sentence with the fix for each request that was not granted; valid after start().
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  void run();

  ForceLoop& loop_;
  RealTimeOptions options_;
  std::vector<Text> warnings_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace hapticell::haptic
