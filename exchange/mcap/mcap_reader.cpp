// SPDX-License-Identifier: Apache-2.0
#include "exchange/mcap/mcap_reader.h"

#include <algorithm>
#include <optional>

#include "exchange/mcap/byte_order.h"
#include "exchange/mcap/mcap_compression.h"

namespace hapticell::exchange {

namespace {

struct RawRecord {
  std::uint8_t opcode = 0;
  std::string_view content;
  std::uint64_t offset = 0, length = 0;  ///< Of the whole record in the file (or the chunk).
};

McapMap mapOf(ByteReader& reader) {
  ByteReader pairs(reader.text());
  McapMap map;
  while (!pairs.isEmpty() && pairs.isGood()) {
    std::string key(pairs.text());
    map[std::move(key)] = std::string(pairs.text());
  }
  if (!pairs.isGood()) reader.take(~std::uint64_t{0});
  return map;
}

/// Where things were found, for the comparison with the summary.
struct FoundPlaces {
  std::map<std::uint64_t, std::uint64_t> chunks, attachments, metadata;  ///< Offset: length.
  std::uint64_t first_time = ~std::uint64_t{0}, last_time = 0;
  std::map<std::uint16_t, std::uint64_t> counts;
};

class McapReading {
 public:
  McapReading(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Expected<McapContent> read() {
    if (!bytes_.starts_with(kMcapMagic)) {
      return problem(0, Text("other first bytes"), "an MCAP file");
    }
    std::uint64_t at = kMcapMagic.size();
    bool is_first = true;
    for (;;) {
      const auto record = next(bytes_, at);
      HAPTICELL_TRY(record);
      if (is_first && record->opcode != static_cast<std::uint8_t>(McapOpcode::kHeader))
        return problem(at, Text("a record of kind %1", record->opcode + 0), "the header");
      is_first = false;
      at += record->length;
      HAPTICELL_TRY(take(*record, false));
      if (record->opcode == static_cast<std::uint8_t>(McapOpcode::kDataEnd)) break;
    }
    HAPTICELL_TRY(readEnd(at));
    return std::move(content_);
  }

 private:
  tl::unexpected<Error> problem(std::uint64_t at, Text found, Text expected, Text fix = {}) const {
    return makeError({name_, Text("byte %1", at), std::move(found), std::move(expected), std::move(fix)});
  }
  tl::unexpected<Error> malformed(const RawRecord& record) const {
    return problem(record.offset, Text("a malformed record of kind %1", record.opcode + 0), "a record of MCAP");
  }

  Expected<RawRecord> next(std::string_view all, std::uint64_t at) const {
    ByteReader reader(all.substr(std::min<std::uint64_t>(at, all.size())));
    RawRecord record;
    record.offset = at;
    record.opcode = reader.number<std::uint8_t>();
    const auto size = reader.number<std::uint64_t>();
    record.content = reader.take(size);
    if (!reader.isGood()) {
      return problem(at, "the end of the file within a record", "more records and a footer",
                     "The recording was cut short. Recover what is whole with 'mcap recover'.");
    }
    record.length = 9 + size;
    return record;
  }

  Expected<void> take(const RawRecord& record, bool in_chunk) {
    switch (static_cast<McapOpcode>(record.opcode)) {
      case McapOpcode::kHeader: return takeHeader(record);
      case McapOpcode::kSchema: return takeSchema(record);
      case McapOpcode::kChannel: return takeChannel(record);
      case McapOpcode::kMessage: return takeMessage(record);
      case McapOpcode::kChunk:
        if (in_chunk) return malformed(record);
        return takeChunk(record);
      case McapOpcode::kAttachment:
        if (in_chunk) return malformed(record);
        return takeAttachment(record);
      case McapOpcode::kMetadata:
        if (in_chunk) return malformed(record);
        return takeMetadata(record);
      case McapOpcode::kDataEnd: return takeDataEnd(record);
      default: return {};  // Indexes are compared with the summary's; unknown kinds are passed over.
    }
  }

  Expected<void> takeHeader(const RawRecord& record) {
    ByteReader reader(record.content);
    content_.profile = reader.text();
    content_.library = reader.text();
    if (!reader.isGood()) return malformed(record);
    return {};
  }

  Expected<void> takeSchema(const RawRecord& record) {
    ByteReader reader(record.content);
    const auto id = reader.number<std::uint16_t>();
    McapSchema schema;
    schema.name = reader.text();
    schema.encoding = reader.text();
    schema.data = reader.text();
    if (!reader.isGood() || id == 0) return malformed(record);
    const auto added = content_.schemas.try_emplace(id, schema);
    if (!added.second && added.first->second != schema)
      return problem(record.offset, Text("schema %1 twice, with different content", id + 0), "one content for each id");
    return {};
  }

  Expected<void> takeChannel(const RawRecord& record) {
    ByteReader reader(record.content);
    const auto id = reader.number<std::uint16_t>();
    McapChannel channel;
    channel.schema = reader.number<std::uint16_t>();
    channel.topic = reader.text();
    channel.message_encoding = reader.text();
    channel.metadata = mapOf(reader);
    if (!reader.isGood()) return malformed(record);
    if (channel.schema != 0 && !content_.schemas.contains(channel.schema))
      return problem(record.offset, Text("a channel of schema %1, which is not declared", channel.schema + 0),
                     "the schema before its channels");
    const auto added = content_.channels.try_emplace(id, channel);
    if (!added.second && added.first->second != channel)
      return problem(record.offset, Text("channel %1 twice, with different content", id + 0), "one content for each id");
    return {};
  }

  Expected<void> takeMessage(const RawRecord& record) {
    ByteReader reader(record.content);
    McapMessage message;
    message.channel = reader.number<std::uint16_t>();
    message.sequence = reader.number<std::uint32_t>();
    message.log_time = reader.number<std::uint64_t>();
    message.publish_time = reader.number<std::uint64_t>();
    message.data = reader.rest();
    if (!reader.isGood()) return malformed(record);
    if (!content_.channels.contains(message.channel))
      return problem(record.offset, Text("a message of channel %1, which is not declared", message.channel + 0),
                     "the channel before its messages");
    found_.first_time = std::min(found_.first_time, message.log_time);
    found_.last_time = std::max(found_.last_time, message.log_time);
    ++found_.counts[message.channel];
    content_.messages.push_back(std::move(message));
    return {};
  }

  Expected<void> takeChunk(const RawRecord& record) {
    ByteReader reader(record.content);
    reader.number<std::uint64_t>();
    reader.number<std::uint64_t>();
    const auto size = reader.number<std::uint64_t>();
    const auto crc = reader.number<std::uint32_t>();
    const std::string_view compression = reader.text();
    const std::string_view small = reader.take(reader.number<std::uint64_t>());
    if (!reader.isGood()) return malformed(record);
    unpacked_ += size;
    if (unpacked_ > kLargestContent)
      return problem(record.offset, Text("more than %1 MB of messages", kLargestContent / 1'000'000),
                     "a recording that fits into memory", "Cut it with 'mcap filter' first.");
    auto records = unpacked(compression, small, size);
    if (!records) {
      records.error().file = name_;
      records.error().place = Text("byte %1", record.offset);
      return tl::unexpected(records.error());
    }
    if (crc != 0 && crc != crc32(*records))
      return problem(record.offset, "a chunk whose checksum is wrong", "the bytes that were written",
                     "The file is damaged. Copy it again, or recover it with 'mcap recover'.");
    for (std::uint64_t at = 0; at < records->size();) {
      auto inner = next(*records, at);
      if (!inner) return problem(record.offset, "a chunk that ends within a record", "whole records");
      at += inner->length;
      inner->offset = record.offset;
      const auto kind = static_cast<McapOpcode>(inner->opcode);
      if (kind == McapOpcode::kHeader || kind == McapOpcode::kDataEnd) return malformed(*inner);
      HAPTICELL_TRY(take(*inner, true));
    }
    ++content_.chunks;
    found_.chunks[record.offset] = record.length;
    return {};
  }

  Expected<void> takeAttachment(const RawRecord& record) {
    ByteReader reader(record.content);
    McapAttachment attachment;
    attachment.log_time = reader.number<std::uint64_t>();
    attachment.create_time = reader.number<std::uint64_t>();
    attachment.name = reader.text();
    attachment.media_type = reader.text();
    attachment.data = reader.take(reader.number<std::uint64_t>());
    const std::size_t before_crc = record.content.size() - reader.rest().size();
    const auto crc = reader.number<std::uint32_t>();
    if (!reader.isGood()) return malformed(record);
    if (crc != 0 && crc != crc32(record.content.substr(0, before_crc)))
      return problem(record.offset, "an attachment whose checksum is wrong", "the bytes that were written");
    content_.attachments.push_back(std::move(attachment));
    found_.attachments[record.offset] = record.length;
    return {};
  }

  Expected<void> takeMetadata(const RawRecord& record) {
    ByteReader reader(record.content);
    McapMetadata metadata;
    metadata.name = reader.text();
    metadata.values = mapOf(reader);
    if (!reader.isGood()) return malformed(record);
    content_.metadata.push_back(std::move(metadata));
    found_.metadata[record.offset] = record.length;
    return {};
  }

  Expected<void> takeDataEnd(const RawRecord& record) const {
    ByteReader reader(record.content);
    const auto crc = reader.number<std::uint32_t>();
    if (!reader.isGood()) return malformed(record);
    if (crc != 0 && crc != crc32(bytes_.substr(0, static_cast<std::size_t>(record.offset))))
      return problem(record.offset, "messages whose checksum is wrong", "the bytes that were written");
    return {};
  }

  /// Summary, footer and closing magic.
  Expected<void> readEnd(std::uint64_t start) {
    constexpr std::size_t kFooterSize = 9 + 20;
    const std::size_t tail = kFooterSize + kMcapMagic.size();
    if (bytes_.size() < start + tail || !bytes_.ends_with(kMcapMagic))
      return problem(bytes_.size(), "the end of the file without a footer", "a footer and the closing bytes",
                     "The recording was cut short. Recover what is whole with 'mcap recover'.");
    const std::uint64_t footer_at = bytes_.size() - tail;
    for (std::uint64_t at = start; at < footer_at;) {
      const auto record = next(bytes_.substr(0, static_cast<std::size_t>(footer_at)), at);
      HAPTICELL_TRY(record);
      HAPTICELL_TRY(compare(*record));
      at += record->length;
    }
    const auto footer = next(bytes_, footer_at);
    HAPTICELL_TRY(footer);
    if (footer->opcode != static_cast<std::uint8_t>(McapOpcode::kFooter) || footer->content.size() != 20)
      return malformed(*footer);
    ByteReader reader(footer->content);
    const auto summary_start = reader.number<std::uint64_t>();
    reader.number<std::uint64_t>();
    const auto crc = reader.number<std::uint32_t>();
    content_.has_summary = summary_start != 0;
    if (summary_start != 0 && summary_start != start)
      return problem(footer_at, Text("a summary at byte %1", summary_start), Text("one at byte %1", start));
    if (crc != 0 &&
        crc != crc32(bytes_.substr(static_cast<std::size_t>(start), static_cast<std::size_t>(footer_at - start) + 25)))
      return problem(footer_at, "a summary whose checksum is wrong", "the bytes that were written");
    return {};
  }

  /// A record of the summary with what was read before.
  Expected<void> compare(const RawRecord& record) {
    switch (static_cast<McapOpcode>(record.opcode)) {
      case McapOpcode::kSchema: return takeSchema(record);
      case McapOpcode::kChannel: return takeChannel(record);
      case McapOpcode::kStatistics: return compareStatistics(record);
      case McapOpcode::kChunkIndex: {
        ByteReader reader(record.content);
        reader.take(16);
        return comparePlace(record, reader, found_.chunks);
      }
      case McapOpcode::kAttachmentIndex: {
        ByteReader reader(record.content);
        return comparePlace(record, reader, found_.attachments);
      }
      case McapOpcode::kMetadataIndex: {
        ByteReader reader(record.content);
        return comparePlace(record, reader, found_.metadata);
      }
      default: return {};
    }
  }

  Expected<void> comparePlace(const RawRecord& record, ByteReader& reader,
                              const std::map<std::uint64_t, std::uint64_t>& places) const {
    const auto offset = reader.number<std::uint64_t>();
    const auto length = reader.number<std::uint64_t>();
    if (!reader.isGood()) return malformed(record);
    const auto place = places.find(offset);
    if (place != places.end() && place->second == length) return {};
    return problem(record.offset, Text("an index entry for byte %1, where no such record is", offset),
                   "an index that fits the file");
  }

  Expected<void> compareStatistics(const RawRecord& record) const {
    ByteReader reader(record.content);
    const auto messages = reader.number<std::uint64_t>();
    reader.take(2 + 4 + 4 + 4);
    const auto chunks = reader.number<std::uint32_t>();
    const auto first = reader.number<std::uint64_t>();
    const auto last = reader.number<std::uint64_t>();
    if (!reader.isGood()) return malformed(record);
    if (messages != content_.messages.size() || chunks != content_.chunks || !countsAgree(reader))
      return problem(record.offset, Text("a summary of %1 messages in %2 chunks", messages, chunks + 0),
                     Text("%1 messages in %2 chunks, as the file has", content_.messages.size(), content_.chunks));
    if (messages > 0 && (first != found_.first_time || last != found_.last_time))
      return problem(record.offset, "a summary with other times", "the first and last time of the messages");
    return {};
  }

  /// Messages of each channel, as the statistics have them.
  bool countsAgree(ByteReader& reader) const {
    ByteReader counts(reader.text());
    while (!counts.isEmpty() && counts.isGood()) {
      const auto channel = counts.number<std::uint16_t>();
      const auto count = counts.number<std::uint64_t>();
      const auto found = found_.counts.find(channel);
      if (count != (found == found_.counts.end() ? 0 : found->second)) return false;
    }
    return reader.isGood() && counts.isGood();
  }

  std::string_view bytes_;
  const std::string& name_;
  McapContent content_;
  FoundPlaces found_;
  std::uint64_t unpacked_ = 0;
};

}  // namespace

Expected<McapContent> readMcap(std::string_view bytes, const std::string& name) {
  return McapReading(bytes, name).read();
}

}  // namespace hapticell::exchange
