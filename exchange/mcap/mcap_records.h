// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace hapticell::exchange {

/// The first and last eight bytes of every MCAP file (https://mcap.dev/spec, version 0).
inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// What a record is, by its first byte; others are passed over, as the specification asks.
enum class McapOpcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f
};

using McapMap = std::map<std::string, std::string>;

/// What messages of a channel look like: "sensor_msgs/msg/JointState", "ros2msg", the text of the definition.
struct McapSchema {
  std::string name, encoding, data;
  bool operator==(const McapSchema&) const = default;
};

/// A topic. `schema` 0: messages without one.
struct McapChannel {
  std::uint16_t schema = 0;
  std::string topic, message_encoding;  ///< "/joint_states"; "cdr", "json".
  McapMap metadata;
  bool operator==(const McapChannel&) const = default;
};

/// A message as it was logged. Times in nanoseconds since the epoch, or since the beginning of a session in virtual
/// time.
struct McapMessage {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;
  std::string data;
};

/// A file within the file.
struct McapAttachment {
  std::uint64_t log_time = 0, create_time = 0;
  std::string name, media_type, data;
};

/// Named words.
struct McapMetadata {
  std::string name;
  McapMap values;
};

/// How a chunk's records are packed.
enum class McapCompression { kNone, kLz4, kZstd };

}  // namespace hapticell::exchange
