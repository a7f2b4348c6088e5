// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// A part of a study: `chunk` of `chunks`, counted from 1.
struct ChunkOption {
  std::size_t chunk = 1, chunks = 1;
};

/// "3/16"; empty: all of it. Errors name --chunk.
Expected<ChunkOption> parseChunk(const std::string& text);

}  // namespace hapticell::cli
