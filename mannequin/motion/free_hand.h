// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"
#include "mannequin/body/skeleton.h"
#include "mannequin/motion/glove_mapping.h"

namespace hapticell::mannequin {

/// Variables of a free hand: spread, rotation, middle and outer joint of the thumb; spread and three joints of each
/// finger, index to little finger. rad; bending and spreading outwards are positive.
inline constexpr std::size_t kFreeHandJoints = 20;

/// A hand of the figure alone, as a tree of links and joints that is drawn and checked like a robot: for a glove
/// without a mannequin. The root is the hand ("r_hand"), every joint of every finger is a separate variable; links have
/// the names and shapes of figureModel(). Parts of the hand that always touch are not checked.
std::shared_ptr<const kinematics::RobotModel> freeHandModel(const Figure& figure, Side side);

/// True for a model that freeHandModel() made.
bool isFreeHand(const kinematics::RobotModel& model);
/// Which hand it is (contract: isFreeHand()).
Side sideOf(const kinematics::RobotModel& model);

/// The variables of a free hand for the joint angles of a glove, within its limits. Values that are not finite count as
/// 0.
std::vector<double> freeHandFromGlove(const GloveReadings& angles, const kinematics::RobotModel& model);

}  // namespace hapticell::mannequin
