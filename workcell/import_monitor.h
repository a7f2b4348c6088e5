// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <string>

namespace hapticell::workcell {

struct ImportProgress {
  std::string stage;   ///< "reading", "meshing", "checking" ...: one word or two, English.
  double share = 0.0;  ///< Of the whole import, 0 to 1, never falling.
};

/// Between the one who imports and the one who waits: progress one way, the wish to stop the other. Any thread.
class ImportMonitor {
 public:
  void report(const std::string& stage, double share) {
    const std::lock_guard lock(mutex_);
    progress_.stage = stage;
    if (share > progress_.share) progress_.share = share < 1.0 ? share : 1.0;
  }
  ImportProgress progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
  }
  void cancel() { cancelled_ = true; }
  bool isCancelled() const { return cancelled_; }

 private:
  mutable std::mutex mutex_;
  ImportProgress progress_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace hapticell::workcell
