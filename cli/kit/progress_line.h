// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "workcell/scenes/import_monitor.h"

namespace hapticell::cli {

/// Shows on standard error how far a reading or writing is, four times a second, for as long as it lives: one line that
/// is written over on a terminal, else a line a tenth of the way.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  workcell::ImportMonitor& monitor() { return monitor_; }

 private:
  void run();
  void show();

  workcell::ImportMonitor monitor_;
  bool terminal_ = false, shown_ = false, stopping_ = false;
  int tenths_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;  // Last: it uses all the others.
};

}  // namespace hapticell::cli
