// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "cli/kit/result_writer.h"

namespace hapticell::cli {

/// How a command ends: the process's exit status (docs/user/command-line.md).
enum class ExitStatus {
  kDone = 0,
  kCheckFound = 1,  ///< A check that was asked for found something.
  kBadInput = 2,    ///< Bad usage or bad input; a sentence went to standard error.
};

/// What a chosen command runs once the command line was read: it writes one result and tells how it ended.
///
/// Each command lives in a file of its own and adds itself as a sub-command: its options, and (by a callback that is
/// called when the user chose it) the action. Nothing heavy happens while options are read.
using Action = std::function<ExitStatus(ResultWriter&)>;

}  // namespace hapticell::cli
