// SPDX-License-Identifier: Apache-2.0
#include "exchange/mcap/mcap_writer.h"

#include <algorithm>

#include "exchange/mcap/byte_order.h"
#include "exchange/mcap/mcap_compression.h"
#include "geometry/system/assertion.h"

namespace hapticell::exchange {

namespace {

std::string recordOf(McapOpcode opcode, std::string_view content) {
  std::string record(1, static_cast<char>(opcode));
  appendNumber(record, static_cast<std::uint64_t>(content.size()));
  record += content;
  return record;
}

void appendMap(std::string& bytes, const McapMap& map) {
  std::string pairs;
  for (const auto& [key, value] : map) {
    appendText(pairs, key);
    appendText(pairs, value);
  }
  appendText(bytes, pairs);
}

std::string schemaContent(std::uint16_t id, const McapSchema& schema) {
  std::string content;
  appendNumber(content, id);
  appendText(content, schema.name);
  appendText(content, schema.encoding);
  appendText(content, schema.data);
  return content;
}

std::string channelContent(std::uint16_t id, const McapChannel& channel) {
  std::string content;
  appendNumber(content, id);
  appendNumber(content, channel.schema);
  appendText(content, channel.topic);
  appendText(content, channel.message_encoding);
  appendMap(content, channel.metadata);
  return content;
}

std::uint16_t idOf(std::size_t index) {
  return static_cast<std::uint16_t>(index + 1);
}

}  // namespace

McapWriter::McapWriter(ByteSink sink, McapWriterOptions options)
    : sink_(std::move(sink)), options_(std::move(options)) {
  put(kMcapMagic);
  std::string header;
  appendText(header, options_.profile);
  appendText(header, options_.library);
  putRecord(McapOpcode::kHeader, header);
}

std::uint16_t McapWriter::addSchema(McapSchema schema) {
  HAPTICELL_DEMAND(schemas_.size() < 0xffff);
  schemas_.push_back(std::move(schema));
  return idOf(schemas_.size() - 1);
}

std::uint16_t McapWriter::addChannel(McapChannel channel) {
  HAPTICELL_DEMAND(channels_.size() < 0xffff && channel.schema <= schemas_.size());
  channels_.push_back(std::move(channel));
  return idOf(channels_.size() - 1);
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, std::string_view data) {
  HAPTICELL_DEMAND(channel > 0 && channel <= channels_.size());
  declare(channel);
  auto& indexed = chunk_.messages[channel];
  if (chunk_.is_empty) {
    chunk_.first_time = chunk_.last_time = time;
    chunk_.is_empty = false;
  }
  chunk_.first_time = std::min(chunk_.first_time, time);
  chunk_.last_time = std::max(chunk_.last_time, time);
  statistics_.first_time = statistics_.messages == 0 ? time : std::min(statistics_.first_time, time);
  statistics_.last_time = std::max(statistics_.last_time, time);
  ++statistics_.messages;
  std::string content;
  content.reserve(22 + data.size());
  appendNumber(content, channel);
  appendNumber(content, static_cast<std::uint32_t>(statistics_.of_channel[channel]++));
  appendNumber(content, time);
  appendNumber(content, time);
  content += data;
  indexed.emplace_back(time, chunk_.records.size());
  chunk_.records += recordOf(McapOpcode::kMessage, content);
  if (chunk_.records.size() >= options_.chunk_size) closeChunk();
}

void McapWriter::addMetadata(const McapMetadata& metadata) {
  closeChunk();
  std::string content;
  appendText(content, metadata.name);
  appendMap(content, metadata.values);
  const std::uint64_t offset = written_;
  putRecord(McapOpcode::kMetadata, content);
  std::string index;
  appendNumber(index, offset);
  appendNumber(index, written_ - offset);
  appendText(index, metadata.name);
  metadata_indexes_.push_back(recordOf(McapOpcode::kMetadataIndex, index));
}

void McapWriter::addAttachment(const McapAttachment& attachment) {
  closeChunk();
  std::string content;
  appendNumber(content, attachment.log_time);
  appendNumber(content, attachment.create_time);
  appendText(content, attachment.name);
  appendText(content, attachment.media_type);
  appendNumber(content, static_cast<std::uint64_t>(attachment.data.size()));
  content += attachment.data;
  appendNumber(content, crc32(content));
  const std::uint64_t offset = written_;
  putRecord(McapOpcode::kAttachment, content);
  std::string index;
  appendNumber(index, offset);
  appendNumber(index, written_ - offset);
  appendNumber(index, attachment.log_time);
  appendNumber(index, attachment.create_time);
  appendNumber(index, static_cast<std::uint64_t>(attachment.data.size()));
  appendText(index, attachment.name);
  appendText(index, attachment.media_type);
  attachment_indexes_.push_back(recordOf(McapOpcode::kAttachmentIndex, index));
}

Expected<void> McapWriter::finish() {
  closeChunk();
  std::string data_end;
  appendNumber(data_end, static_cast<std::uint32_t>(crc_.checksum()));
  putRecord(McapOpcode::kDataEnd, data_end);
  const std::uint64_t start = written_;
  std::string offsets;
  std::string end = summary(offsets);
  const std::uint64_t offsets_start = start + end.size();
  end += offsets;
  end += static_cast<char>(McapOpcode::kFooter);
  appendNumber(end, std::uint64_t{20});
  appendNumber(end, start);
  appendNumber(end, offsets_start);
  appendNumber(end, crc32(end));  // Of the summary, up to here.
  put(end);
  put(kMcapMagic);
  return state_;
}

void McapWriter::put(std::string_view bytes) {
  crc_.process_bytes(bytes.data(), bytes.size());
  written_ += bytes.size();
  if (state_) state_ = sink_(bytes);
}

void McapWriter::putRecord(McapOpcode opcode, std::string_view content) {
  put(recordOf(opcode, content));
}

/// A chunk has the schema and the channel of each of its messages, so that it can be read by itself.
void McapWriter::declare(std::uint16_t channel) {
  if (chunk_.messages.contains(channel)) return;
  const McapChannel& declared = channels_[channel - 1u];
  const std::uint16_t schema = declared.schema;
  const bool is_known = std::any_of(chunk_.messages.begin(), chunk_.messages.end(), [&](const auto& other) {
    return channels_[other.first - 1u].schema == schema;
  });
  if (schema > 0 && !is_known)
    chunk_.records += recordOf(McapOpcode::kSchema, schemaContent(schema, schemas_[schema - 1u]));
  chunk_.records += recordOf(McapOpcode::kChannel, channelContent(channel, declared));
}

void McapWriter::closeChunk() {
  if (chunk_.records.empty()) return;
  const std::string small = packed(options_.compression, chunk_.records);
  std::string content;
  appendNumber(content, chunk_.first_time);
  appendNumber(content, chunk_.last_time);
  appendNumber(content, static_cast<std::uint64_t>(chunk_.records.size()));
  appendNumber(content, crc32(chunk_.records));
  appendText(content, nameOf(options_.compression));
  appendNumber(content, static_cast<std::uint64_t>(small.size()));
  content += small;
  ChunkIndex index{chunk_.first_time, chunk_.last_time, written_, 0, {}, 0, small.size(), chunk_.records.size()};
  putRecord(McapOpcode::kChunk, content);
  index.length = written_ - index.offset;
  const std::uint64_t indexes_start = written_;
  for (auto& [channel, messages] : chunk_.messages) {
    std::sort(messages.begin(), messages.end());
    std::string entries, record;
    for (const auto& [time, offset] : messages) {
      appendNumber(entries, time);
      appendNumber(entries, offset);
    }
    appendNumber(record, channel);
    appendText(record, entries);
    index.message_indexes[channel] = written_;
    putRecord(McapOpcode::kMessageIndex, record);
  }
  index.message_indexes_length = written_ - indexes_start;
  chunk_indexes_.push_back(std::move(index));
  chunk_ = OpenChunk{};
}

std::string McapWriter::statisticsContent() const {
  std::string content;
  appendNumber(content, statistics_.messages);
  appendNumber(content, static_cast<std::uint16_t>(schemas_.size()));
  appendNumber(content, static_cast<std::uint32_t>(channels_.size()));
  appendNumber(content, static_cast<std::uint32_t>(attachment_indexes_.size()));
  appendNumber(content, static_cast<std::uint32_t>(metadata_indexes_.size()));
  appendNumber(content, static_cast<std::uint32_t>(chunk_indexes_.size()));
  appendNumber(content, statistics_.first_time);
  appendNumber(content, statistics_.last_time);
  std::string counts;
  for (const auto& [channel, count] : statistics_.of_channel) {
    appendNumber(counts, channel);
    appendNumber(counts, count);
  }
  appendText(content, counts);
  return content;
}

std::string McapWriter::chunkIndexContent(const ChunkIndex& index) const {
  std::string content, places;
  appendNumber(content, index.first_time);
  appendNumber(content, index.last_time);
  appendNumber(content, index.offset);
  appendNumber(content, index.length);
  for (const auto& [channel, place] : index.message_indexes) {
    appendNumber(places, channel);
    appendNumber(places, place);
  }
  appendText(content, places);
  appendNumber(content, index.message_indexes_length);
  appendText(content, nameOf(options_.compression));
  appendNumber(content, index.packed_size);
  appendNumber(content, index.size);
  return content;
}

/// The records of the summary by kind; `offsets` gets where each kind begins.
std::string McapWriter::summary(std::string& offsets) const {
  const std::uint64_t start = written_;
  std::string records;
  const auto close = [&](McapOpcode opcode, std::size_t from) {
    if (from == records.size()) return;
    std::string content(1, static_cast<char>(opcode));
    appendNumber(content, start + from);
    appendNumber(content, static_cast<std::uint64_t>(records.size() - from));
    offsets += recordOf(McapOpcode::kSummaryOffset, content);
  };
  for (std::size_t i = 0; i < schemas_.size(); ++i)
    records += recordOf(McapOpcode::kSchema, schemaContent(idOf(i), schemas_[i]));
  close(McapOpcode::kSchema, 0);
  std::size_t from = records.size();
  for (std::size_t i = 0; i < channels_.size(); ++i)
    records += recordOf(McapOpcode::kChannel, channelContent(idOf(i), channels_[i]));
  close(McapOpcode::kChannel, from);
  from = records.size();
  records += recordOf(McapOpcode::kStatistics, statisticsContent());
  close(McapOpcode::kStatistics, from);
  from = records.size();
  for (const ChunkIndex& index : chunk_indexes_)
    records += recordOf(McapOpcode::kChunkIndex, chunkIndexContent(index));
  close(McapOpcode::kChunkIndex, from);
  from = records.size();
  for (const std::string& index : attachment_indexes_) records += index;
  close(McapOpcode::kAttachmentIndex, from);
  from = records.size();
  for (const std::string& index : metadata_indexes_) records += index;
  close(McapOpcode::kMetadataIndex, from);
  return records;
}

}  // namespace hapticell::exchange
