// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::config {

/// How much a log file holds; each level includes those before it.
enum class LogLevel { kError, kWarning, kInfo, kDebug };

/// The level of the option --log-level: "error", "warning", "info" or "debug". Error: another word.
Expected<LogLevel> logLevelFrom(std::string_view word);

}  // namespace hapticell::config
