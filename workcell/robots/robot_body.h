// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "kinematics/closures/arm_builder.h"
#include "kinematics/closures/delta.h"
#include "kinematics/closures/hexapod.h"
#include "kinematics/model/robot_model.h"
#include "workcell/robots/solid_kit.h"

namespace hapticell::workcell {

/// Colours and proportions of a generated body; the project contains no meshes of robot makers.
struct RobotLook {
  PaintColor main{0.85f, 0.85f, 0.84f, 1.0f};
  PaintColor second{0.20f, 0.22f, 0.25f, 1.0f};
  double bulk = 1.0;           ///< Above 1: thicker than usual; below 1: slimmer.
  bool balanced = false;       ///< With a counterbalance next to the upper arm.
  bool round = false;          ///< Closed round housings instead of ribbed castings and external motors.
  std::vector<double> side;    ///< For cobots: sideways offset of each link along its own axis, m.
  std::vector<double> radius;  ///< For cobots: radius of each joint's housing, m; empty: by size.
};

/// Each adds shapes to the links of a model of that kind: castings, arms, wrists, motors, rods. Collision shapes are
/// coarser. The links' frames are those of the builders in kinematics/.
void addArmBody(kinematics::RobotModel& model, const kinematics::OpwParameters& parameters, const RobotLook& look);
/// Any serial chain, as joint housings with tubes between them.
void addCobotBody(kinematics::RobotModel& model, const RobotLook& look);
/// R-R-P-R or R-R-R-P with vertical axes: column, two arms, quill.
void addScaraBody(kinematics::RobotModel& model, const RobotLook& look);
/// With prismatic axes first: beams and carriages, then housings.
void addGantryBody(kinematics::RobotModel& model, const RobotLook& look);
void addDeltaBody(kinematics::RobotModel& model, const kinematics::DeltaGeometry& geometry, double tool_length,
                  const RobotLook& look);
void addHexapodBody(kinematics::RobotModel& model, const kinematics::HexapodGeometry& geometry, double tool_length,
                    const RobotLook& look);

}  // namespace hapticell::workcell
