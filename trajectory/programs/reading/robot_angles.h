// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::trajectory {

/// Orientations as controllers write them, degrees (UR: radians). At a middle angle of +-90 degrees the last angle is
/// 0.

/// KUKA A, B, C: R = Rz(A) Ry(B) Rx(C). Returned as (A, B, C).
dvec3 kukaAngles(const dquat& q);
dquat fromKukaAngles(const dvec3& abc);

/// FANUC W, P, R: R = Rz(R) Ry(P) Rx(W). Returned as (W, P, R).
dvec3 fanucAngles(const dquat& q);
dquat fromFanucAngles(const dvec3& wpr);

/// Stäubli rx, ry, rz: R = Rx(rx) Ry(ry) Rz(rz).
dvec3 staubliAngles(const dquat& q);
dquat fromStaubliAngles(const dvec3& angles);

}  // namespace hapticell::trajectory
