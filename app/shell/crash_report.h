// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/shell/action_trail.h"
#include "geometry/system/error.h"

namespace hapticell::app {

/// What a signal handler knows of a crash.
struct Crash {
  const char* cause = "";   ///< What went wrong.
  const char* thread = "";  ///< The name of the thread that crashed.
  bool kept = false;        ///< The unsaved state is in the recovery copy.
};

/// Writes the report of a crash: a text file with time, cause, version, the last actions and the call stack. It stays
/// on this computer; nothing sends it. Everything that it needs is prepared beforehand.
class CrashReport {
 public:
  static constexpr std::size_t kKept = 10;  ///< Reports in the folder; older ones are removed.

  /// $XDG_STATE_HOME/hapticell/crashes, made if it is missing, with room for one more report. Error: it cannot be made,
  /// or others may write to it.
  static Expected<std::filesystem::path> makeFolder();
  /// The reports in a folder, oldest first.
  static std::vector<std::filesystem::path> reportsIn(const std::filesystem::path& folder);

  /// `program`: its version, commit, compiler and libraries, in lines. `actions` must outlive this object.
  CrashReport(const std::filesystem::path& folder, std::string program, const ActionTrail& actions);
  /// Writes crash-DATE-TIME-PROCESS.txt (UTC) into the folder, this thread's call stack last. For a signal handler:
  /// neither allocates nor locks, if backtrace() was called once before.
  void write(const Crash& crash) const;

 private:
  std::string beginning_;  ///< Start of the report's path, up to the date.
  std::string program_;
  const ActionTrail* actions_;
};

}  // namespace hapticell::app
