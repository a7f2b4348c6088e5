// SPDX-License-Identifier: Apache-2.0
#include "config/log_level.h"

#include <string>

#include "geometry/system/plain_text.h"

namespace hapticell::config {

Expected<LogLevel> logLevelFrom(std::string_view word) {
  if (word == "error") return LogLevel::kError;
  if (word == "warning") return LogLevel::kWarning;
  if (word == "info") return LogLevel::kInfo;
  if (word == "debug") return LogLevel::kDebug;
  return makeError({.file = "command line",
                    .place = std::string("--log-level"),
                    .found = "'" + plainText(word) + "'",
                    .expected = "error, warning, info or debug"});
}

}  // namespace hapticell::config
