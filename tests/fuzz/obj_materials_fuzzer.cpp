// SPDX-License-Identifier: Apache-2.0
// Any bytes as a material library of an OBJ file: colours of 0 to 1, whatever stands there.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "workcell/meshes/obj_materials.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  Diagnostics notes;
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  for (const auto& [name, color] : workcell::parseObjMaterials(content, notes)) {
    for (const float channel : color) {
      if (!(channel >= 0.0f && channel <= 1.0f)) std::abort();
    }
  }
  return 0;
}
