// SPDX-License-Identifier: Apache-2.0
// Any bytes as a mesh file. Built once a format: HAPTICELL_FUZZ_EXTENSION is the name's ending, which the probe falls
// back on.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/mesh_parts.h"
#include "workcell/meshes/mesh_reader.h"

namespace {

/// No triangle is lost or names a corner that is not there, whatever a file says of names and colours.
void checkParts(hapticell::workcell::RawMesh raw) {
  using namespace hapticell;
  Diagnostics notes;
  const std::size_t triangles = raw.mesh.triangles.size();
  std::map<std::string, workcell::Color> materials;
  for (std::size_t k = 0; k < raw.labels.size(); ++k) {
    const float red = static_cast<float>(k % 5) / 4.0f;
    if (k % 3 != 0) materials[raw.labels[k].material] = {red, 0.0f, 1.0f};
  }
  std::size_t sum = 0;
  for (const workcell::MeshPart& part : workcell::partsOf(std::move(raw), materials, true, notes)) {
    sum += part.mesh.triangles.size();
    for (const auto& triangle : part.mesh.triangles) {
      for (const std::uint32_t index : triangle) {
        if (index >= part.mesh.vertices.size()) std::abort();
      }
    }
    if (part.color && !((*part.color)[0] >= 0.0f && (*part.color)[0] <= 1.0f)) std::abort();
  }
  if (sum != triangles) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  Diagnostics notes;
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  auto raw = workcell::HAPTICELL_FUZZ_READER(content, notes);
  if (!raw && raw.error().message().empty()) std::abort();
  if (raw) checkParts(std::move(*raw));
  const auto file = workcell::parseMeshFile(content, "fuzzed" HAPTICELL_FUZZ_EXTENSION, {}, notes);
  if (!file) return 0;
  for (const auto& triangle : file->mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      if (index >= file->mesh.vertices.size()) std::abort();
    }
  }
  return 0;
}
