// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"
#include "mannequin/motion/glove_mapping.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// Variables of a free hand: spread, rotation, middle and outer joint of the thumb; spread and three joints of each
/// finger, index to little finger. rad; bending and spreading outwards are positive.
inline constexpr std::size_t kFreeHandJoints = 20;

/// A hand of the figure by itself, as a tree of links and joints that draws and checks like a robot: for a glove where
/// there is no mannequin. The root is the hand ("r_hand"), every joint of every finger is a variable of its own; links
/// bear the names and shapes that they have in figureModel(). Its own parts that touch by nature are not checked.
std::shared_ptr<const kinematics::RobotModel> freeHandModel(const Figure& figure, Side side);

/// True for a model that freeHandModel() made.
bool isFreeHand(const kinematics::RobotModel& model);
/// Which hand it is (contract: isFreeHand()).
Side sideOf(const kinematics::RobotModel& model);

/// The variables of a free hand for a glove's joint angles, within its limits. What is not finite counts as 0.
std::vector<double> freeHandFromGlove(const GloveReadings& angles, const kinematics::RobotModel& model);

}  // namespace hapticell::mannequin
