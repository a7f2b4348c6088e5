// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/shell/crash_report.h"

namespace hapticell::app {

/// Saves what can be saved when the program breaks: a broken contract, an uncaught error, an invalid memory access
/// (SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL), on any thread. While the thread that broke waits, a thread that was made
/// for it beforehand calls `keep`; then what broke is noted in a file and a report is written, and the program ends as
/// it would have. Nobody waits longer than kPatience, so a lock that the broken thread holds costs the copy and not the
/// end. Does nothing where there are no such signals. One at a time; any thread makes it.
class CrashGuard {
 public:
  /// s; writing a copy of ten thousand parts takes a tenth of that. Half: slow disks lose theirs; twice: a crash
  /// without copy takes 10 s.
  static constexpr double kPatience = 5.0;

  /// `keep` writes what is not saved, without a thread of the window's; false: it could not. `note`: the file to write
  /// what broke and in which thread, as one line, in a folder that is there. `report`: writes the rest; none: only the
  /// note is written.
  CrashGuard(std::function<bool()> keep, const std::filesystem::path& note, std::optional<CrashReport> report = {});
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  bool is_mine_ = false;  ///< False where another one stood already.
};

}  // namespace hapticell::app
