// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "exchange/recordings/recording.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// Reads a written MCAP file and compares it with what was to be written: every number equal to the bit, times within
/// half a nanosecond. Error: what differs, and where.
Expected<void> checkRecording(const Recording& wanted, const std::filesystem::path& written);

}  // namespace hapticell::exchange
