// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studies/questions/question.h"

// The makers of questionKinds(), one a kind.
namespace hapticell::studies {

using MadeQuestion = Expected<std::unique_ptr<Question>>;

MadeQuestion makeReach(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeConfiguration(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeClearance(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeJointMargin(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeManipulability(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeCycleTime(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeMotion(const StudySection& section, StudyInputs& inputs);
MadeQuestion makePosture(const StudySection& section, StudyInputs& inputs);
MadeQuestion makeSight(const StudySection& section, StudyInputs& inputs);

}  // namespace hapticell::studies
