// SPDX-License-Identifier: Apache-2.0
// Any bytes as what the importer's process hands over: refused, or a scene that writes the same bytes again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "workcell/scenes/scene_exchange.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto scene = workcell::sceneFromBytes(bytes);
  if (!scene) return 0;
  workcell::nodePoses(*scene);
  workcell::partPaths(*scene);
  const auto again = workcell::sceneFromBytes(workcell::sceneBytes(*scene));
  if (!again || again->nodes.size() != scene->nodes.size()) std::abort();
  return 0;
}
