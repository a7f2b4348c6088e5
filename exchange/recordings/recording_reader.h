// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/recordings/recording.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// Reads an MCAP file.
///
/// One that this program wrote comes back as it was. Of another program's file, one motion is read: joints from a topic
/// of `sensor_msgs/msg/JointState` and poses from one of `geometry_msgs/msg/PoseStamped` (CDR), with times from the
/// first message on. `topic` chooses one topic; without it, "/joint_states" or the only one of its kind is taken. `notes`
/// says what was left out: topics, messages of other joints, times that do not rise.
///
/// Errors name the file: as readMcap(), a message that cannot be decoded, numbers that are not finite, a quaternion of
/// another length than 1, no such topic, several topics and no choice (the error lists them), nothing that can be read.
Expected<Recording> readMcapRecording(const std::filesystem::path& file, const std::string& topic = {});

/// The same from bytes; errors use `name` as the file.
Expected<Recording> parseMcapRecording(std::string_view bytes, const std::string& name, const std::string& topic = {});

/// The first motion of such a file; if it has no motion of an entity, that of the stylus.
Expected<trajectory::Trajectory> readMcapMotion(const std::filesystem::path& file, const std::string& topic = {},
                                                std::vector<Text>* notes = nullptr);

/// What of such a file can be shown as motions.
struct McapMotions {
  std::vector<trajectory::Trajectory> motions;  ///< All of the file, the first as readMcapMotion() gives it.
  bool is_stylus = false;                       ///< The only one is the stylus in the device's frame.
};

/// All motions of such a file. `notes` says what else it holds.
Expected<McapMotions> readMcapMotions(const std::filesystem::path& file, std::vector<Text>& notes);

/// True for names that end in .mcap, in any case.
bool isMcapFile(const std::filesystem::path& file);

}  // namespace hapticell::exchange
