// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <utility>

#include "geometry/system/text.h"

namespace hapticell::workcell {

struct ImportProgress {
  Text stage;          ///< "reading", "meshing part 3 of 8, bolt", "checking" ...
  double share = 0.0;  ///< Of the whole import, 0 to 1, never decreasing.
};

/// Connects an import with the code that waits for it: progress one way, the request to cancel the other. Any thread.
class ImportMonitor {
 public:
  void report(Text stage, double share) {
    const std::lock_guard lock(mutex_);
    progress_.stage = std::move(stage);
    share = from_ + share * (to_ - from_);
    if (share > progress_.share) progress_.share = share < 1.0 ? share : 1.0;
  }
  /// From now on, 0 to 1 of report() stands for this range of the whole: for one of several files.
  void setRange(double from, double to) {
    const std::lock_guard lock(mutex_);
    from_ = from;
    to_ = to;
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
  double from_ = 0.0, to_ = 1.0;
  std::atomic<bool> cancelled_{false};
};

}  // namespace hapticell::workcell
