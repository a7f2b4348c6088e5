// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/ergonomics/owas.h"
#include "mannequin/ergonomics/posture_angles.h"
#include "mannequin/figure.h"
#include "mannequin/forward_kinematics.h"
#include "mannequin/posture.h"

namespace hapticell::ergonomics {

/// The angles that the methods ask for, measured on a posed figure, one side's arm. Degrees.
///
/// Trunk: the line from mid-hip to the lowest neck joint against the vertical, negative where it leans back. Neck: the
/// head against the thorax. Upper arm: against the trunk's line, in the trunk's sagittal plane; beside it the angle
/// out of that plane. What joints have of their own (wrist, pronation, girdle) is their angle. Weight on the heavier
/// foot from the centre of mass between the soles; a foot lifted by 5 cm carries nothing.
MeasuredPosture measure(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose, mannequin::Side side);

/// The whole figure as OWAS sees it. Kneeling: a knee joint within 20 cm of the lowest point; walking and the load are
/// the caller's to say.
OwasPosture owasPosture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose);

}  // namespace hapticell::ergonomics
