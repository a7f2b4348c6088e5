// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "config/log_level.h"
#include "geometry/system/error.h"

namespace spdlog::sinks {
class sink;
}

namespace hapticell::config {

/// How much disk space the log of a program takes.
struct LogLimits {
  std::size_t bytes = std::size_t{1} << 20;  ///< Of a file; when it is full the next one begins.
  std::size_t files = 3;                     ///< PROGRAM.log and the older PROGRAM.1.log, PROGRAM.2.log.
};

/// The log file of one program: PROGRAM.log in $XDG_STATE_HOME/hapticell/logs. A second process of the same program
/// writes PROGRAM-2.log, and so on up to 9, so that none renames the file of another. It stays on this computer. Any
/// thread but the force loop's.
class ProgramLog {
 public:
  /// Makes the folder if it is missing. Error: the folder or the file cannot be written, others may write to the
  /// folder, or 9 processes have a log already; the program does without one then.
  static Expected<std::unique_ptr<ProgramLog>> open(const std::string& program, LogLevel level, LogLimits limits = {});
  ~ProgramLog();
  ProgramLog(const ProgramLog&) = delete;
  ProgramLog& operator=(const ProgramLog&) = delete;

  /// One line with date, time and level; control characters become blanks (plainText()). If the file cannot be written
  /// any more, one message goes to standard error.
  void write(LogLevel level, std::string_view sentence);
  const std::filesystem::path& file() const;
  /// For a logger of spdlog that writes to other places too.
  std::shared_ptr<spdlog::sinks::sink> sink() const;

 private:
  struct Parts;
  explicit ProgramLog(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace hapticell::config
