// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// A figure on a seat.
struct Sitting {
  Posture posture;
  /// The higher sole above z = 0 if the legs are too short for the seat; otherwise 0.
  double feet_above_floor_m = 0.0;
};

/// Seats a figure upright with the underside of its pelvis on `p_WSeat`, facing `heading` (rad about W's z, 0 along x),
/// feet on the floor (z = 0) if the legs are long enough. `model` is the figure's own (figureModel()). Any thread.
Sitting sitOn(const Figure& figure, const kinematics::RobotModel& model, const dvec3& p_WSeat, double heading);

}  // namespace hapticell::mannequin
