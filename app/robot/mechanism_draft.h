// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/viewport/scene/scene_curve.h"
#include "app/viewport/tools/picked_feature.h"
#include "workcell/document/command.h"

namespace hapticell::app {

/// A mechanism while its joints are being defined: a value, everything in the frame W of the cell. No Qt.
struct MechanismDraft {
  workcell::EntityId edited = 0;  ///< 0: a new mechanism made of solids of the cell.
  std::string name;
  std::vector<workcell::MechanismJoint> joints;  ///< p_MJ and axis_M hold p_WJ and axis_W.
};

/// The draft for changing a mechanism of the document: its joints as placed in the cell while all are at 0.
MechanismDraft draftOf(const workcell::Entity& mechanism);

/// Names of the draft's parts, the fixed one first: it carries others, and no part carries it.
std::vector<std::string> partsOf(const MechanismDraft& draft);

/// The command that makes or changes the mechanism. Errors, each a sentence: no joint, a joint without part, a part
/// that does not exist, is not a solid or is locked.
Expected<workcell::Command> commandOf(const MechanismDraft& draft, const workcell::DocumentState& state);

/// What is still wrong with the draft, found by running the command on a copy of the state; empty: nothing.
std::optional<Error> faultOf(const MechanismDraft& draft, const workcell::DocumentState& state);

/// Sets the joint's axis from a picked feature: the axis of a cylinder, cone or circle, a straight edge, the normal of
/// a plane.
void layAxis(workcell::MechanismJoint& joint, const PickedFeature& feature);

/// Reverses the axis: swaps and negates the limits.
void flipAxis(workcell::MechanismJoint& joint);

/// A new joint with limits that suit its kind and an unused name.
workcell::MechanismJoint newJoint(const MechanismDraft& draft, workcell::MechanismJointType type);
/// Sets limits and pitch that suit the joint's kind; for a joint whose kind was changed.
void suitLimits(workcell::MechanismJoint& joint);

/// The curves of an axis: a dash-dot line of `length` (m) both ways, an arrow in the positive direction, and the arc of
/// a hinge with limits.
std::vector<SceneCurve> axisCurves(const workcell::MechanismJoint& joint, double length);

/// All kinds, in the order of the panel.
inline constexpr workcell::MechanismJointType kJointKinds[]{
    workcell::MechanismJointType::kRevolute, workcell::MechanismJointType::kPrismatic,
    workcell::MechanismJointType::kScrew, workcell::MechanismJointType::kFixed};

/// Size of one unit of a joint's shown numbers (mm or degree), in m or rad.
double shownUnit(const workcell::MechanismJoint& joint);

}  // namespace hapticell::app
