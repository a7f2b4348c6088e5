// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// How hapticell-ros2 ended, with what it printed on standard output. Its sentences went to standard error.
struct BridgeAnswer {
  int status = 0;
  std::string output;
};

/// Starts hapticell-ros2 beside this program with one argument and waits for its end. Ctrl+C ends the process; this
/// one still gets its result. Errors: it is not installed, it cannot be started, it crashed.
Expected<BridgeAnswer> callBridge(const std::string& job);

}  // namespace hapticell::cli
