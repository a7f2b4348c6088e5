// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "exchange/recordings/recording.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// Reads the table that `hapticell-cli session --trace` writes, a row a tick (docs/user/formats.md). Errors name file
/// and line: a missing column, a quaternion of another length than 1, times that do not
/// rise.
Expected<std::vector<StylusSample>> readTraceTable(const std::filesystem::path& file);

/// True if the header line of a CSV file is that of a trace.
bool isTraceTable(const std::filesystem::path& file);

}  // namespace hapticell::exchange
