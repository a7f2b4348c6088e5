// SPDX-License-Identifier: Apache-2.0
// Any text as a URDF: refused in words, or a model whose indices are sound.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "workcell/robots/urdf_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  Diagnostics notes;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto model = workcell::readUrdfText(text, "/nowhere/fuzzed.urdf", notes);
  if (!model) {
    if (model.error().message().empty()) std::abort();
    return 0;
  }
  const auto links = static_cast<int>(model->links.size());
  for (const kinematics::Joint& joint : model->joints) {
    if (joint.parent_link < 0 || joint.parent_link >= links || joint.child_link <= 0 || joint.child_link >= links)
      std::abort();
  }
  return 0;
}
