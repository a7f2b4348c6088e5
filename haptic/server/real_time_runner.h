// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace hapticell::haptic {

class ForceLoop;

/// What the force thread asks of the system.
struct RealTimeOptions {
  bool fifo = true;         ///< SCHED_FIFO with `priority`.
  int priority = 80;        ///< Above the machine's ordinary threads, below its watchdogs.
  bool lock_memory = true;  ///< mlockall(), so that no page has to be fetched within a tick.
};

/// Runs a force loop in a thread of its own, one tick at each absolute deadline.
///
/// What the system does not grant is done without and told by warnings(). Ticks that were missed are skipped and
/// counted, never replayed. The loop must have been made with a RealClock.
class RealTimeRunner {
 public:
  explicit RealTimeRunner(ForceLoop& loop, const RealTimeOptions& options = {});
  ~RealTimeRunner();  ///< Stops.
  RealTimeRunner(const RealTimeRunner&) = delete;
  RealTimeRunner& operator=(const RealTimeRunner&) = delete;

  /// Starts the thread; returns when it knows what it was granted.
  void start();
  /// Ends the thread: force zero, motors off. More than once is harmless.
  void stop();

  /// A sentence with the fix for each thing that was asked for and not granted; after start().
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void run();

  ForceLoop& loop_;
  RealTimeOptions options_;
  std::vector<std::string> warnings_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace hapticell::haptic
