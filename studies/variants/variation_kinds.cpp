// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/variation_kinds.h"

#include <algorithm>

#include "geometry/system/listed.h"
#include "studies/document/study_section.h"

namespace hapticell::studies {

std::span<const VariationKind> variationKinds() {
  static constexpr VariationKind kKinds[] = {
      {"position", makePosition},    {"rotation", makeRotation},   {"size", makePartSize},
      {"robot", makeRobotChoice},    {"joint", makeJointPosition}, {"tool", makeToolChoice},
      {"tool_offset", makeToolOffset}, {"body", makeBodyChoice},     {"stance", makeStanceChoice},
      {"motion", makeMotionChoice},
  };
  return kKinds;
}

Expected<std::unique_ptr<Variation>> makeVariation(const StudySection& section, StudyInputs& inputs) {
  const auto kinds = variationKinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const VariationKind& one) { return section.kind == one.name; });
  if (kind == kinds.end()) {
    const std::string known = listed(kinds, [](const VariationKind& one) { return std::string(one.name); });
    return makeError(section.fault(Text("what = \"%1\"", section.kind), Text("one of %1", known)));
  }
  return kind->make(section, inputs);
}

}  // namespace hapticell::studies
