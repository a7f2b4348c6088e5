// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/mcap/mcap_records.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// All that an MCAP file holds.
struct McapContent {
  std::string profile, library;
  std::map<std::uint16_t, McapSchema> schemas;
  std::map<std::uint16_t, McapChannel> channels;
  std::vector<McapMessage> messages;  ///< In the order of the file.
  std::vector<McapAttachment> attachments;
  std::vector<McapMetadata> metadata;
  std::uint64_t chunks = 0;
  bool has_summary = false;
};

/// Reads a whole MCAP file front to end, as the specification allows, so that what is read does not depend on indexes.
/// Then every CRC that is there is compared (of chunks, attachments, the data section, the summary), and the summary
/// with what was read: counts, times, where chunks, metadata and attachments are.
///
/// Errors name `name` and the byte: no MCAP file, one that ends early (with how to recover it), damaged or unknown
/// compression, a message of an undeclared channel, an id declared twice with other content, a summary that disagrees,
/// content of more than kLargestContent bytes.
Expected<McapContent> readMcap(std::string_view bytes, const std::string& name);

/// Bytes of all unpacked chunks together: about an hour of 1 kHz with five topics. Half: half an hour; twice: a
/// stranger's file takes twice the memory.
inline constexpr std::uint64_t kLargestContent = 4'000'000'000;

}  // namespace hapticell::exchange
