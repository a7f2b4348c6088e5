// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "workcell/document/document_state.h"

namespace hapticell::workcell {

// What commands check before they change anything. Each error is one sentence that names the entity or set.

/// The name as messages show it: 'Gripper'.
std::string quotedName(const std::string& name);

/// That two things of a kind cannot have one name.
Error taken(const std::string& name);

/// Refused: empty names, more than 200 letters, control characters, spaces at the ends. `what` names the thing.
Expected<void> checkName(const Text& what, const std::string& name);

/// Refused: numbers that are not finite, a quaternion that is not of length 1.
Expected<void> checkPose(const Text& what, const Pose& pose);

/// How far from the origin parts may lie, m: pictures are drawn in single precision, which is a tenth of a millimetre
/// there. Half: large plants are refused; twice: 0.2 mm, edges flicker.
inline constexpr double kFarthest = 2000.0;

/// Refused: a place beyond kFarthest from the origin of the cell.
Expected<void> checkReach(const std::string& name, const dvec3& p_WE);

/// Refused: also where its mesh reaches farther, in the cell or in its own frame.
Expected<void> checkReach(const Entity& entity);

/// Refused: another number of values than the robot's variables, values that are not finite.
Expected<void> checkJoints(const Entity& entity, const std::vector<double>& joints);

/// Refused: a tip link that the robot does not have, a tool centre point that is no pose.
Expected<void> checkTool(const Entity& entity);

/// Errors: tools on a link that does not exist, duplicate names, or an invalid pose.
Expected<void> checkTools(const Entity& entity);

/// Refused: poses with one name twice, or without a finite number for each joint.
Expected<void> checkNamedPoses(const Entity& entity);

/// Errors: frames with duplicate names or an invalid pose.
Expected<void> checkFrames(const Entity& entity);

/// Refused: a colour out of 0 to 1, a mass not above 0.
Expected<void> checkProperties(const Entity& entity);

/// Errors: an invalid name, distances outside 0 to 1 m.
Expected<void> checkPairSet(const PairSet& set);
Expected<void> checkPairRule(const PairRule& rule, const DocumentState& state);

}  // namespace hapticell::workcell
