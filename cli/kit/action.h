// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "cli/kit/result_writer.h"

namespace hapticell::cli {

/// Result of a command: the process's exit status (docs/user/command-line.md).
enum class ExitStatus {
  kDone = 0,
  kCheckFound = 1,  ///< A requested check found something.
  kBadInput = 2,    ///< Bad usage or bad input; a sentence went to standard error.
};

/// Run for the chosen command once the command line was read: writes one result and returns the exit status.
///
/// Each command has its own file and adds itself as a sub-command: its options and, by a callback that is called when
/// the user chose it, the action. Nothing expensive runs while options are read.
using Action = std::function<ExitStatus(ResultWriter&)>;

}  // namespace hapticell::cli
