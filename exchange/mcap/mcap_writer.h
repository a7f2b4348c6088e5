// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/mcap/mcap_records.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// Takes the next bytes of a file.
using ByteSink = std::function<Expected<void>(std::string_view bytes)>;

struct McapWriterOptions {
  std::string profile;  ///< "ros2": channels have the metadata that ROS 2 tools look for.
  std::string library = "HaptiCell";
  McapCompression compression = McapCompression::kZstd;
  /// Bytes of a chunk before it is packed. Half: a tenth larger files; twice: players read twice as much for a jump.
  std::size_t chunk_size = 1'000'000;
};

/// Writes an MCAP file from front to end: header, chunks with an index of each channel's messages, metadata,
/// attachments, and a summary with schemas, channels, statistics, indexes and their offsets. Every part that may have a
/// CRC has one. One thread.
///
/// The first error of the sink ends the writing; finish() returns it.
class McapWriter {
 public:
  /// Writes the header.
  explicit McapWriter(ByteSink sink, McapWriterOptions options = {});

  std::uint16_t addSchema(McapSchema schema);
  /// @pre the schema was added, or is 0
  std::uint16_t addChannel(McapChannel channel);
  /// Both times are `time`, nanoseconds. @pre the channel was added
  void write(std::uint16_t channel, std::uint64_t time, std::string_view data);
  void addMetadata(const McapMetadata& metadata);
  void addAttachment(const McapAttachment& attachment);
  /// Writes the last chunk and the summary. Nothing may be added afterwards. Error: that of the sink.
  Expected<void> finish();
  /// Messages so far.
  std::uint64_t count() const { return statistics_.messages; }

 private:
  struct ChunkIndex {
    std::uint64_t first_time, last_time, offset, length;
    std::map<std::uint16_t, std::uint64_t> message_indexes;
    std::uint64_t message_indexes_length, packed_size, size;
  };
  struct OpenChunk {
    std::string records;
    std::uint64_t first_time = 0, last_time = 0;
    std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> messages;  ///< Time and offset.
    bool is_empty = true;  ///< Of messages.
  };
  struct Statistics {
    std::uint64_t messages = 0, first_time = 0, last_time = 0;
    std::map<std::uint16_t, std::uint64_t> of_channel;
  };

  void put(std::string_view bytes);
  void putRecord(McapOpcode opcode, std::string_view content);
  void declare(std::uint16_t channel);
  void closeChunk();
  std::string statisticsContent() const;
  std::string chunkIndexContent(const ChunkIndex& index) const;
  std::string summary(std::string& offsets) const;

  ByteSink sink_;
  McapWriterOptions options_;
  std::vector<McapSchema> schemas_;    // Of id index + 1.
  std::vector<McapChannel> channels_;  // Of id index + 1.
  OpenChunk chunk_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<std::string> attachment_indexes_, metadata_indexes_;  // Whole records.
  Statistics statistics_;
  std::uint64_t written_ = 0;
  boost::crc_32_type crc_;  // Of all that was written.
  Expected<void> state_;
};

}  // namespace hapticell::exchange
