// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/question_kinds.h"

#include <algorithm>

#include "geometry/system/listed.h"
#include "studies/document/study_section.h"

namespace hapticell::studies {

std::span<const QuestionKind> questionKinds() {
  static constexpr QuestionKind kKinds[] = {
      {"reach", makeReach},
      {"configuration", makeConfiguration},
      {"clearance", makeClearance},
      {"joint_margin", makeJointMargin},
      {"manipulability", makeManipulability},
      {"cycle_time", makeCycleTime},
      {"motion", makeMotion},
      {"posture", makePosture},
      {"sight", makeSight},
  };
  return kKinds;
}

Expected<std::unique_ptr<Question>> makeQuestion(const StudySection& section, StudyInputs& inputs) {
  const auto kinds = questionKinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const QuestionKind& one) { return section.kind == one.name; });
  if (kind == kinds.end()) {
    const std::string known = listed(kinds, [](const QuestionKind& one) { return std::string(one.name); });
    return makeError(section.fault(Text("what = \"%1\"", section.kind), Text("one of %1", known)));
  }
  return kind->make(section, inputs);
}

}  // namespace hapticell::studies
