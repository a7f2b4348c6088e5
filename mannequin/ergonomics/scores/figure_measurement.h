// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/view_planes.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::ergonomics {

/// The angles that the methods ask for, measured on a posed figure, one side's arm. Degrees.
///
/// Each angle is of its own anatomical plane. Trunk: its line (trunkLine()) against the vertical, forward in the plane
/// that the pelvis faces, negative where it leans back; to the side out of that plane; twist: of the thorax in the
/// pelvis about its own long axis. Neck: the head in the thorax, flexion, then side bend, then twist. Upper arm: see
/// upperArmAngles(), against the trunk's line, forward out of the chest. Forearm: out of the sagittal plane. What
/// joints have of their own (wrist, pronation, girdle) is their angle. Weight on the heavier foot from the centre of
/// mass between the soles; a foot lifted by 4 cm carries nothing.
MeasuredPosture measure(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose, mannequin::Side side);

/// The trunk's line from mid-hip to the lowest neck joint in the world, m: the spine's segments end to end, each along
/// its own long axis. The joints lie behind that axis and before it; a turn would else move their line to a side.
dvec3 trunkLine(const mannequin::FigurePose& pose);
/// Level directions that the pelvis faces (forward, left, up).
ViewPlanes pelvisPlanes(const mannequin::FigurePose& pose);

/// The whole figure as OWAS sees it. Kneeling: a knee joint within 20 cm of the lowest point; walking and the load are
/// the caller's to say.
OwasPosture owasPosture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose);

}  // namespace hapticell::ergonomics
