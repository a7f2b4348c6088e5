// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body/figure.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/view_planes.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::ergonomics {

/// The angles for the methods, measured on a posed figure, for the arm of one side. Degrees.
///
/// Each angle is in its own anatomical plane. Trunk: its line (trunkLine()) against the vertical, forward in the plane
/// that the pelvis faces, negative if it leans back; to the side out of that plane; twist: of the thorax relative to
/// the pelvis about its own long axis. Neck: the head relative to the thorax, flexion, then side bend, then twist.
/// Upper arm: see upperArmAngles(), relative to the trunk's line, forward out of the chest. Forearm: out of the
/// sagittal plane. For wrist, pronation and girdle: the joint angle. Weight on the heavier foot from the centre of mass
/// between the soles; a foot lifted by 4 cm carries nothing.
MeasuredPosture measure(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose, mannequin::Side side);

/// The trunk's line from mid-hip to the lowest neck joint in the world, m: the segments of the spine end to end, each
/// along its own long axis. (The joints lie behind or in front of that axis; a twist would otherwise move their line to
/// a side.)
dvec3 trunkLine(const mannequin::FigurePose& pose);
/// Horizontal directions of the pelvis (forward, left, up).
ViewPlanes pelvisPlanes(const mannequin::FigurePose& pose);

/// The whole figure for OWAS. Kneeling: a knee joint within 20 cm of the lowest point; the caller states walking and
/// the load.
OwasPosture owasPosture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                        const mannequin::FigurePose& pose);

}  // namespace hapticell::ergonomics
