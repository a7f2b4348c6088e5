// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "exchange/mcap/mcap_records.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// The name that a chunk gives: "", "lz4", "zstd".
std::string_view nameOf(McapCompression compression);

/// Packs bytes as an lz4 or zstd frame, or leaves them. Fails only if memory runs out.
std::string packed(McapCompression compression, std::string_view bytes);

/// Unpacks what a chunk of that compression name holds, of exactly `size` bytes. Errors (without a file): an unknown
/// name, damaged bytes, another size, more than kLargestChunk.
Expected<std::string> unpacked(std::string_view name, std::string_view bytes, std::uint64_t size);

/// Bytes of an unpacked chunk that are read. Writers make chunks of 1 to 16 MB. Half: still above all known writers;
/// twice: a small file of a stranger takes 2 GB of memory.
inline constexpr std::uint64_t kLargestChunk = 1'000'000'000;

/// CRC-32 of IEEE 802.3, as MCAP uses it.
std::uint32_t crc32(std::string_view bytes);

}  // namespace hapticell::exchange
