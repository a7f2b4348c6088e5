// SPDX-License-Identifier: Apache-2.0
#include "cli/study/chunk_option.h"

#include <charconv>

namespace hapticell::cli {

Expected<ChunkOption> parseChunk(const std::string& text) {
  if (text.empty()) return ChunkOption();
  constexpr std::size_t kMostChunks = 1'000'000;
  ChunkOption option;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, option.chunk);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, option.chunks) : first;
  const bool good = slash && second.ec == std::errc() && second.ptr == end && option.chunk >= 1 &&
                    option.chunk <= option.chunks && option.chunks <= kMostChunks;
  if (good) return option;
  return makeError({.place = "--chunk", .found = "'" + text + "'", .expected = "I/N with 1 <= I <= N, for example 3/16"});
}

}  // namespace hapticell::cli
