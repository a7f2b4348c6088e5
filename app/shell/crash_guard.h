// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/shell/crash_report.h"

namespace hapticell::app {

/// Saves what can be saved when the program crashes: a broken contract, an uncaught error, an invalid memory access
/// (SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL), on any thread. While the crashed thread waits, a thread made beforehand
/// calls `keep`; then the cause is noted in a file, a report is written, and the program ends as it would have without
/// the guard. The wait is limited to kPatience, so a lock that the crashed thread holds costs the copy but does not
/// prevent the end. Does nothing on systems without such signals. One at a time; made in any thread.
class CrashGuard {
 public:
  /// s; writing a copy of ten thousand parts takes a tenth of that. Half: no copy on slow disks; twice: a crash without
  /// copy takes 10 s.
  static constexpr double kPatience = 5.0;

  /// `keep` writes the unsaved state without the help of the window's thread; false: it could not. `note`: the file, in
  /// an existing folder, for one line with the cause and the thread. `report`: writes the rest; if empty, only the note
  /// is written.
  CrashGuard(std::function<bool()> keep, const std::filesystem::path& note, std::optional<CrashReport> report = {});
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  bool is_mine_ = false;  ///< False if another guard existed already.
};

}  // namespace hapticell::app
