// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/queries/proximity_query.h"
#include "collision/queries/motion_check.h"
#include "planning/planned_motion.h"

namespace hapticell::planning {

using OwnPair = manipulation::Manipulator::OwnPair;

/// A piece of a motion, from 0 to 1.
struct MotionPiece {
  double from = 0.0, to = 1.0;
};

/// Leads an own pair along a piece of a motion, the one part as seen from the other, until they touch. `way`: bound (m)
/// of their paths by the joints between them, together, on the whole motion.
collision::MotionStop leadOwnPair(collision::ProximityQuery& query, const OwnPair& pair, PlannedMotion& motion,
                                  double way, const MotionPiece& piece = {});

/// Lower bound (m) of the distance of the two by the spheres around them.
double spheresApart(const collision::ProximityQuery& query, const Pose& X_WA, const Pose& X_WB);

/// Whether an own pair touches on a motion; `way` as above. What is apart by more than half a piece's way in its middle
/// is so on the whole piece, which takes a tenth of a distance to tell.
bool ownPairTouches(collision::ProximityQuery& query, const OwnPair& pair, PlannedMotion& motion, double way);

}  // namespace hapticell::planning
