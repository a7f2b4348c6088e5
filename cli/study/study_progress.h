// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "cli/kit/command_listener.h"
#include "studies/runner/study_run.h"

namespace hapticell::cli {

/// Shows on standard error how far a run is and how long it will take: one line that is written over on a terminal,
/// else a line a tenth of the way. Calls come one at a time.
class StudyProgress {
 public:
  StudyProgress();
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;
  void show(const studies::RunProgress& progress);

 private:
  CommandListener* const listener_ = commandListener();
  bool terminal_ = false, shown_ = false;
  std::size_t tenths_ = 0;
  std::chrono::steady_clock::time_point last_{};
};

/// "1 h 05 min", "12 s"
std::string durationWords(double seconds);

}  // namespace hapticell::cli
