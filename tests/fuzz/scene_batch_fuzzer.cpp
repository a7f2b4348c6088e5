// SPDX-License-Identifier: Apache-2.0
// Any bytes as what the importer's process leaves for several files.
#include <cstdlib>

#include "workcell/scenes/scene_batch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell::workcell;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (std::size_t count : {1u, 2u, 3u}) {
    const auto entries = batchFromBytes(bytes, count);
    if (entries && batchBytes(*entries) != bytes) std::abort();
  }
  return 0;
}
