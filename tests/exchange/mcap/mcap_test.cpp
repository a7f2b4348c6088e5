// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "exchange/mcap/byte_order.h"
#include "exchange/mcap/mcap_compression.h"
#include "exchange/mcap/mcap_reader.h"
#include "exchange/mcap/mcap_records.h"
#include "exchange/mcap/mcap_writer.h"

namespace hapticell::exchange {
namespace {

std::string sampleFile(McapCompression compression, int messages = 500) {
  std::string bytes;
  McapWriterOptions options;
  options.profile = "ros2";
  options.compression = compression;
  options.chunk_size = 4000;
  McapWriter writer(
      [&](std::string_view more) -> Expected<void> {
        bytes += more;
        return {};
      },
      options);
  const auto schema = writer.addSchema({"a/msg/B", "ros2msg", "float64 x"});
  const auto a = writer.addChannel({schema, "/a", "cdr", {{"key", "value"}}});
  const auto b = writer.addChannel({0, "/b", "json", {}});
  for (int i = 0; i < messages; ++i)
    writer.write(i % 3 == 0 ? b : a, 1000u + static_cast<std::uint64_t>(i), "payload " + std::to_string(i));
  writer.addMetadata({"about", {{"x", "1"}, {"y", ""}}});
  writer.addAttachment({5, 6, "a.json", "application/json", "{}"});
  EXPECT_TRUE(writer.finish().has_value());
  EXPECT_EQ(writer.count(), static_cast<std::uint64_t>(messages));
  return bytes;
}

TEST(Mcap, ComesBackAsItWasInEveryCompression) {
  for (const auto compression : {McapCompression::kNone, McapCompression::kLz4, McapCompression::kZstd}) {
    const std::string bytes = sampleFile(compression);
    const auto read = readMcap(bytes, "a.mcap");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->profile, "ros2");
    EXPECT_TRUE(read->has_summary);
    EXPECT_GT(read->chunks, 3u);
    ASSERT_EQ(read->messages.size(), 500u);
    for (std::size_t i = 0; i < 500; ++i) {
      EXPECT_EQ(read->messages[i].data, "payload " + std::to_string(i));
      EXPECT_EQ(read->messages[i].log_time, 1000 + i);
    }
    EXPECT_EQ(read->channels.at(1).topic, "/a");
    EXPECT_EQ(read->channels.at(1).metadata.at("key"), "value");
    EXPECT_EQ(read->schemas.at(1).data, "float64 x");
    ASSERT_EQ(read->metadata.size(), 1u);
    EXPECT_EQ(read->metadata[0].values.at("x"), "1");
    ASSERT_EQ(read->attachments.size(), 1u);
    EXPECT_EQ(read->attachments[0].data, "{}");
  }
}

TEST(Mcap, EmptyFileHasASummary) {
  const auto read = readMcap(sampleFile(McapCompression::kZstd, 0), "a.mcap");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->chunks, 0u);
}

/// Published check values: CRC-32 of "123456789" is cbf43926.
TEST(Mcap, ChecksumIsThatOfEthernet) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926u);
}

TEST(Mcap, BytesAreThoseOfTheSpecification) {
  const std::string bytes = sampleFile(McapCompression::kNone, 0);
  std::string expected("\x89MCAP0\r\n", 8);
  expected += '\x01';
  appendNumber(expected, std::uint64_t{4 + 4 + 4 + 9});
  appendText(expected, "ros2");
  appendText(expected, "HaptiCell");
  EXPECT_EQ(bytes.substr(0, expected.size()), expected);
  EXPECT_EQ(bytes.substr(bytes.size() - 8), expected.substr(0, 8));
  ByteReader footer(std::string_view(bytes).substr(bytes.size() - 8 - 29));
  EXPECT_EQ(footer.number<std::uint8_t>(), 0x02);
  EXPECT_EQ(footer.number<std::uint64_t>(), 20u);
  const auto summary = footer.number<std::uint64_t>();
  EXPECT_EQ(bytes[summary], '\x03');  // A schema comes first.
}

TEST(Mcap, CutFilesAreRefusedWithASentence) {
  const std::string bytes = sampleFile(McapCompression::kZstd);
  for (std::size_t size = 0; size < bytes.size(); size += 37) {
    const auto read = readMcap(std::string_view(bytes).substr(0, size), "cut.mcap");
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().file, "cut.mcap");
    EXPECT_FALSE(read.error().message().empty());
  }
}

TEST(Mcap, EveryChangedByteOfTheDataIsFound) {
  const std::string bytes = sampleFile(McapCompression::kLz4, 60);
  std::size_t unseen = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string bent = bytes;
    bent[at] = static_cast<char>(bent[at] ^ 0x10);
    if (readMcap(bent, "bent.mcap")) ++unseen;
  }
  // A checksum of zero means that there is none: no single flip makes one here.
  EXPECT_EQ(unseen, 0u);
}

TEST(Mcap, ChunkThatPromisesTooMuchIsRefused) {
  EXPECT_FALSE(unpacked("zstd", "xx", kLargestChunk + 1));
  EXPECT_FALSE(unpacked("zstd", "xx", 100));
  EXPECT_FALSE(unpacked("lz4", "xx", 100));
  EXPECT_FALSE(unpacked("", "xx", 100));
  EXPECT_FALSE(unpacked("brotli", "xx", 2));
  for (const auto compression : {McapCompression::kLz4, McapCompression::kZstd}) {
    const std::string small = packed(compression, std::string(5000, 'a'));
    EXPECT_EQ(unpacked(nameOf(compression), small, 5000).value(), std::string(5000, 'a'));
    EXPECT_FALSE(unpacked(nameOf(compression), small, 4999));
    EXPECT_FALSE(unpacked(nameOf(compression), small, 5001));
  }
}

TEST(Mcap, ErrorOfTheSinkComesOutAtTheEnd) {
  McapWriter writer([](std::string_view) -> Expected<void> { return makeError({.found = "full"}); });
  writer.write(writer.addChannel({0, "/b", "json", {}}), 1, "{}");
  ASSERT_FALSE(writer.finish());
}

}  // namespace
}  // namespace hapticell::exchange
