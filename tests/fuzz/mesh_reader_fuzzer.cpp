// SPDX-License-Identifier: Apache-2.0
// Any bytes as a mesh file. Built once a format: HAPTICELL_FUZZ_EXTENSION is the name's ending, which the probe falls
// back on.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "workcell/mesh_formats.h"
#include "workcell/mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  Diagnostics notes;
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  const auto raw = workcell::HAPTICELL_FUZZ_READER(content, notes);
  if (!raw && raw.error().message().empty()) std::abort();
  const auto file = workcell::parseMeshFile(content, "fuzzed" HAPTICELL_FUZZ_EXTENSION, {}, notes);
  if (!file) return 0;
  for (const auto& triangle : file->mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      if (index >= file->mesh.vertices.size()) std::abort();
    }
  }
  return 0;
}
