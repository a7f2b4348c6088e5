// SPDX-License-Identifier: Apache-2.0
#include "exchange/mcap/mcap_compression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <boost/crc.hpp>
#include <memory>
#include <new>

#include "geometry/system/assertion.h"

namespace hapticell::exchange {

namespace {

// Level 1 packs 1 kHz of poses to a third at some 300 MB/s. Lower: no smaller; 3 (zstd's own default): 5 % smaller,
// half as fast.
constexpr int kZstdLevel = 1;

Expected<std::string> damagedChunk() {
  return makeError({.found = "a damaged chunk", .expected = "compressed records"});
}

Expected<std::string> unpackedZstd(std::string_view bytes, std::size_t size) {
  std::string into(size, '\0');
  const std::size_t got = ZSTD_decompress(into.data(), into.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0 || got != size) return damagedChunk();
  return into;
}

Expected<std::string> unpackedLz4(std::string_view bytes, std::size_t size) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> owner(context, LZ4F_freeDecompressionContext);
  std::string into(size, '\0');
  std::size_t filled = 0;
  while (!bytes.empty()) {
    std::size_t read = bytes.size(), made = into.size() - filled;
    const std::size_t left = LZ4F_decompress(context, into.data() + filled, &made, bytes.data(), &read, nullptr);
    if (LZ4F_isError(left) != 0 || (read == 0 && made == 0)) return damagedChunk();
    bytes.remove_prefix(read);
    filled += made;
    if (left == 0) break;  // The frame's end.
  }
  if (filled != size) return damagedChunk();
  return into;
}

}  // namespace

std::string_view nameOf(McapCompression compression) {
  switch (compression) {
    case McapCompression::kLz4: return "lz4";
    case McapCompression::kZstd: return "zstd";
    case McapCompression::kNone: break;
  }
  return "";
}

std::string packed(McapCompression compression, std::string_view bytes) {
  if (compression == McapCompression::kNone) return std::string(bytes);
  std::string into;
  if (compression == McapCompression::kZstd) {
    into.resize(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(into.data(), into.size(), bytes.data(), bytes.size(), kZstdLevel);
    HAPTICELL_DEMAND(ZSTD_isError(size) == 0);
    into.resize(size);
  } else {
    into.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
    const std::size_t size = LZ4F_compressFrame(into.data(), into.size(), bytes.data(), bytes.size(), nullptr);
    HAPTICELL_DEMAND(LZ4F_isError(size) == 0);
    into.resize(size);
  }
  return into;
}

Expected<std::string> unpacked(std::string_view name, std::string_view bytes, std::uint64_t size) {
  if (size > kLargestChunk) {
    return makeError({.found = Text("a chunk of %1 MB", size / 1'000'000),
                      .expected = Text("at most %1 MB", kLargestChunk / 1'000'000)});
  }
  if (name.empty()) {
    if (bytes.size() != size) return damagedChunk();
    return std::string(bytes);
  }
  if (name == "zstd") return unpackedZstd(bytes, static_cast<std::size_t>(size));
  if (name == "lz4") return unpackedLz4(bytes, static_cast<std::size_t>(size));
  return makeError({.found = Text("the compression '%1'", std::string(name.substr(0, 40))), .expected = "zstd, lz4 or none"});
}

std::uint32_t crc32(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

}  // namespace hapticell::exchange
