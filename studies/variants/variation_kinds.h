// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studies/variants/variation.h"

// The makers of variationKinds(), one a kind.
namespace hapticell::studies {

using MadeVariation = Expected<std::unique_ptr<Variation>>;

MadeVariation makePosition(const StudySection& section, StudyInputs& inputs);
MadeVariation makeRotation(const StudySection& section, StudyInputs& inputs);
MadeVariation makeRobotChoice(const StudySection& section, StudyInputs& inputs);
MadeVariation makeBodyChoice(const StudySection& section, StudyInputs& inputs);
MadeVariation makeStanceChoice(const StudySection& section, StudyInputs& inputs);
MadeVariation makePartSize(const StudySection& section, StudyInputs& inputs);
MadeVariation makeJointPosition(const StudySection& section, StudyInputs& inputs);
MadeVariation makeToolChoice(const StudySection& section, StudyInputs& inputs);
MadeVariation makeToolOffset(const StudySection& section, StudyInputs& inputs);
MadeVariation makeMotionChoice(const StudySection& section, StudyInputs& inputs);

}  // namespace hapticell::studies
