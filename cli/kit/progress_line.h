// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "cli/kit/command_listener.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::cli {

/// Shows the progress of reading or writing on standard error, four times a second, while it exists: one line that is
/// overwritten on a terminal, else one line per tenth of the work. A CommandListener hears it instead; if it asks to
/// stop, the work is cancelled.
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
  CommandListener* const listener_ = commandListener();
  bool terminal_ = false, shown_ = false, stopping_ = false;
  int tenths_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;  // Last: it uses all other members.
};

}  // namespace hapticell::cli
