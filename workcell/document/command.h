// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/entity/mechanism.h"

namespace hapticell::workcell {

// Every change of a document, as a value. Each can be undone (Document::execute).

/// Adds an entity at the end. The document assigns its id; joints may be empty (all zero, moved into their
/// limits).
struct AddEntity {
  Entity entity;
};

/// Removes an entity and its name from the pair sets; also removes a set that would lose the last name of a side.
struct RemoveEntity {
  EntityId id = 0;
};

/// Renames an entity, also in the pair sets.
struct RenameEntity {
  EntityId id = 0;
  std::string name;
};

/// Gives an entity the shape that its file has now; name, placement, colour and flags do not change. A solid gets the
/// mesh of `fresh`; a robot its model, keeping the positions of joints with the same name; a mannequin its figure
/// (another size). Resets the collision shape.
struct ReplaceShape {
  EntityId id = 0;
  Entity fresh;  ///< Of the same kind; its source becomes the entity's.
};

/// Sets the collision shape of a solid; kNone: its own mesh.
struct SetCollisionProxy {
  EntityId id = 0;
  CollisionProxy proxy;
};

struct SetPlacement {
  EntityId id = 0;
  Pose X_WE;
};

/// One value per variable of the robot, rad or m.
struct SetJoints {
  EntityId id = 0;
  std::vector<double> joints;
};

// Entities attached to an entity (Attach) move with it when a command moves it.

/// Placement and joints at once: the result of a hold in the manipulation loop.
struct SetConfiguration {
  EntityId id = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< Empty for solids.
};

/// Changes the given properties and leaves the others.
struct SetProperties {
  EntityId id = 0;
  std::optional<std::array<float, 3>> color = {};  ///< 0 to 1 each.
  std::optional<bool> visible = {};
  std::optional<bool> locked = {};
  std::optional<bool> checked = {};
  std::optional<OnContact> on_contact = {};
  std::optional<ForceClass> force_class = {};
  std::optional<std::string> material = {};
  std::optional<double> mass = {};  ///< kg, above 0.
  std::optional<std::string> parent = {};
};

struct SetFrames {
  EntityId id = 0;
  std::vector<Frame> frames;
};

/// Sets the tool centre point of a robot; none of its named tools is chosen then.
struct SetTool {
  EntityId id = 0;
  std::string tip_link;
  Pose X_LT;
};

/// Sets the named tools of a robot. If the chosen one is still among them, its new values apply.
struct SetTools {
  EntityId id = 0;
  std::vector<ToolFrame> tools;
};

/// Sets the user's named poses of a robot, which may include "home"; see namedPosesOf() in named_poses.h.
struct SetNamedPoses {
  EntityId id = 0;
  std::vector<kinematics::NamedPose> poses;
};

/// Chooses one of the named tools: sets the robot's tip link and tool centre point to the tool's.
struct ChooseTool {
  EntityId id = 0;
  std::string name;
};

/// Attaches an entity to a link of another one (a gripped part to the flange, a robot to a slide), at its present
/// placement. From then on it moves with the link. Errors: attaching it to itself or to an entity attached to it, a
/// link that does not exist.
struct Attach {
  EntityId id = 0;
  EntityId to = 0;
  std::string link;  ///< Empty: a robot's tip link; for a solid, the solid itself.
};

/// Detaches an entity; it stays where it is.
struct Detach {
  EntityId id = 0;
};

/// Makes a mechanism from solids of the cell, which become its parts. Its frame M is that of the first part. Points and
/// axes of the joints are given in the cell W, with the parts at their present placements; part names are the entities'
/// names.
struct MakeMechanism {
  std::string name;
  std::vector<EntityId> parts;
  std::vector<MechanismJoint> joints;  ///< p_MJ and axis_M hold p_WJ and axis_W.
};

/// Replaces a mechanism's joints (in its own frame M, at all joints 0); joints of the same name keep their position.
struct EditMechanism {
  EntityId id = 0;
  std::vector<MechanismJoint> joints;
};

/// Dissolves a mechanism: its parts become solids again at their present placements.
struct DissolveMechanism {
  EntityId id = 0;
};

struct AddPairSet {
  PairSet set;
};
struct EditPairSet {
  std::string name;  ///< The present name of the set.
  PairSet set;       ///< The new set, with its new name.
};
struct RemovePairSet {
  std::string name;
};

/// Sets rules for single pairs, in place of earlier ones; a rule that is checked and has no contact mode of its own
/// removes the pair's rule. `text` names the undo step; empty: derived from the rules.
struct SetPairRules {
  std::vector<PairRule> rules;
  std::string text = {};
};

struct AddGuide {
  Guide guide;
};
struct EditGuide {
  std::string name;  ///< The present name of the guide.
  Guide guide;       ///< The new guide, with its new name.
};
struct RemoveGuide {
  std::string name;
};

/// Adds a recording, or an edited copy of one. The caller writes its file.
struct AddTrajectory {
  TrajectoryReference trajectory;
};
/// Renames a trajectory; its file does not change.
struct RenameTrajectory {
  std::string name, new_name;
};
/// Replaces the trajectory `name` by an edited program, whose name is `trajectory.name`. The caller writes its file;
/// the old file does not change.
struct SetTrajectory {
  std::string name;
  TrajectoryReference trajectory;
};
/// Removes a trajectory from the cell; its file stays.
struct RemoveTrajectory {
  std::string name;
};

/// Adds a work task, or replaces the one with the name `before` (empty: its own name).
struct SetWorkTask {
  ergonomics::WorkTask task;
  std::string before = {};
};
struct RemoveWorkTask {
  std::string name;
};

struct SetView {
  std::optional<SavedView> view;
};

using Command = std::variant<AddEntity, RemoveEntity, RenameEntity, ReplaceShape, SetCollisionProxy, SetPlacement,
                             SetJoints, SetConfiguration, SetProperties, SetFrames, SetTool, SetTools, SetNamedPoses,
                             ChooseTool, Attach, Detach, MakeMechanism, EditMechanism, DissolveMechanism, AddPairSet,
                             EditPairSet, RemovePairSet, SetPairRules, AddGuide, EditGuide, RemoveGuide, AddTrajectory,
                             RenameTrajectory, SetTrajectory, RemoveTrajectory, SetWorkTask, RemoveWorkTask, SetView>;

/// Applies a command to a state; on error the state does not change. `new_id` is the id for an added entity. Errors:
/// unknown ids and names; names that are taken, empty or not printable; values that are not finite or out of range;
/// moving or removing a locked entity. Returns the id of the entity concerned, 0 for commands without one.
Expected<EntityId> apply(const Command& command, DocumentState& state, EntityId new_id);

/// Pose in W of the link that an attachment to `carrier` names (empty: the pose of the carrier itself).
Pose carrierPose(const Entity& carrier, const std::string& link);

/// Text of the command for the menu: "Move Gripper G2". `state` is the one before the command.
std::string commandText(const Command& command, const DocumentState& state);

}  // namespace hapticell::workcell
