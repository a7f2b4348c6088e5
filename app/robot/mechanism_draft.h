// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/viewport/scene/scene_curve.h"
#include "app/viewport/tools/picked_feature.h"
#include "workcell/document/command.h"

namespace hapticell::app {

/// A mechanism while its joints are laid: a value, everything in the cell W. No Qt.
struct MechanismDraft {
  workcell::EntityId edited = 0;  ///< 0: a new one of solids that stand in the cell.
  std::string name;
  std::vector<workcell::MechanismJoint> joints;  ///< p_MJ and axis_M hold p_WJ and axis_W.
};

/// The draft that changes a mechanism of the document: its joints as they stand in the cell while all are at 0.
MechanismDraft draftOf(const workcell::Entity& mechanism);

/// Names of the parts of the draft, the one that stands still first: it carries others and is carried by none.
std::vector<std::string> partsOf(const MechanismDraft& draft);

/// The command that makes (or changes) it. Errors, each a sentence: no joint, a joint without part, a part that is not
/// there, is no solid or is locked.
Expected<workcell::Command> commandOf(const MechanismDraft& draft, const workcell::DocumentState& state);

/// What is still wrong with it, by doing the command on a copy of the state; empty: nothing.
std::optional<Error> faultOf(const MechanismDraft& draft, const workcell::DocumentState& state);

/// Lays the joint's axis along what was picked: the axis of a cylinder, cone or circle, a straight edge, the normal of
/// a plane.
void layAxis(workcell::MechanismJoint& joint, const PickedFeature& feature);

/// The other way round: limits and offset change sides.
void flipAxis(workcell::MechanismJoint& joint);

/// A new joint with the limits that suit its kind and a name that is not taken.
workcell::MechanismJoint newJoint(const MechanismDraft& draft, workcell::MechanismJointType type);
/// Limits and pitch as they suit the joint's kind; for a joint whose kind was changed.
void suitLimits(workcell::MechanismJoint& joint);

/// The axis as it is drawn: a dash-dot line of `length` (m) both ways, the arrow of the positive side, and for a hinge
/// with limits its arc.
std::vector<SceneCurve> axisCurves(const workcell::MechanismJoint& joint, double length);

/// In the order in which the panel offers them.
inline constexpr workcell::MechanismJointType kJointKinds[]{
    workcell::MechanismJointType::kRevolute, workcell::MechanismJointType::kPrismatic,
    workcell::MechanismJointType::kScrew, workcell::MechanismJointType::kFixed};

/// One unit of the numbers shown for a joint, mm or degree, in m or rad.
double shownUnit(const workcell::MechanismJoint& joint);

}  // namespace hapticell::app
