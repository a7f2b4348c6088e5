// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

namespace hapticell::fuzz {

/// Ends the process, which a fuzzer takes as a finding, unless `condition` holds.
inline void check(bool condition) {
  if (!condition) std::abort();
}

/// Hands `bytes` to `take(span)` in pieces of `piece` bytes (at least 1), as a stream brings them.
template <typename Take>
void inPieces(std::span<const std::uint8_t> bytes, std::size_t piece, Take&& take) {
  for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
    take(bytes.subspan(begin, std::min(piece, bytes.size() - begin)));
  }
}

}  // namespace hapticell::fuzz
