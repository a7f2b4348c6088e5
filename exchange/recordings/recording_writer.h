// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "exchange/recordings/recording.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// The bytes of an MCAP file (https://mcap.dev/spec) of a recording, packed by zstd: ROS 2 messages (CDR, `ros2msg`)
/// for poses, joints, forces and buttons, JSON messages with a schema for contacts, points and scores, by time. Topics
/// and frames: docs/user/recordings-mcap.md. The same recording gives the same bytes.
///
/// Times are nanoseconds, so a time of more than nine decimals is rounded. Where a motion begins before 0, whole seconds
/// are added to all times and noted in the metadata. Errors: nothing to write, times beyond 1e9 s, two frames of one
/// motion within the same nanosecond.
Expected<std::string> mcapBytes(const Recording& recording);

/// Writes it, reads what was written, and compares every number of it with the recording before the file gets its
/// name. Errors: as above, and what differs.
Expected<void> writeMcapRecording(const Recording& recording, const std::filesystem::path& file);

}  // namespace hapticell::exchange
