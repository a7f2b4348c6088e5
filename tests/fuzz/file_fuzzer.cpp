// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of a reader that takes only files: SDF cells and models, robot.toml. Built once an extension
// (HAPTICELL_FUZZ_EXTENSION); refused in words, or entities with sound meshes.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "workcell/import/entity_source.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hapticell-fuzz-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / ("fuzzed" HAPTICELL_FUZZ_EXTENSION);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  Diagnostics notes;
  const auto tree = workcell::EntityLoader(folder).loadTree(file.string(), {}, notes);
  if (!tree) {
    if (tree.error().message().empty()) std::abort();
    return 0;
  }
  for (const auto& entity : tree->entities) {
    if (!entity.mesh()) continue;
    for (const auto& triangle : entity.mesh()->triangles)
      for (const std::uint32_t index : triangle)
        if (index >= entity.mesh()->vertices.size()) std::abort();
  }
  return 0;
}
