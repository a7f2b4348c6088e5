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

// Every change of a document, as a value. Each is undoable (Document::execute).

/// Adds an entity behind the others. Its id is given by the document; joints may be empty (all zero, moved into their
/// limits).
struct AddEntity {
  Entity entity;
};

/// Removes an entity and its name from the pair sets; a set that would lose its last name on one side goes with it.
struct RemoveEntity {
  EntityId id = 0;
};

/// Renames an entity, also in the pair sets.
struct RenameEntity {
  EntityId id = 0;
  std::string name;
};

/// Gives an entity the shape that its file holds now; name, placement, colour and flags stay. A solid gets the mesh of
/// `fresh`, a robot its model, with the positions of joints of the same name, a mannequin its figure (another size). A
/// collision proxy is made no more.
struct ReplaceShape {
  EntityId id = 0;
  Entity fresh;  ///< Of the same kind; its source becomes the entity's.
};

/// What a solid is checked by; kNone: by itself.
struct SetCollisionProxy {
  EntityId id = 0;
  CollisionProxy proxy;
};

struct SetPlacement {
  EntityId id = 0;
  Pose X_WE;
};

/// One value a variable of the robot, rad or m.
struct SetJoints {
  EntityId id = 0;
  std::vector<double> joints;
};

// Entities attached to an entity (Attach) move with it when a command moves it.

/// Placement and joints at once: what a hold of the manipulation loop ends with.
struct SetConfiguration {
  EntityId id = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< Empty for solids.
};

/// Changes what is given and leaves the rest.
struct SetProperties {
  EntityId id = 0;
  std::optional<std::array<float, 3>> color = {};  ///< 0 .. 1 each.
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

/// The tool centre point of a robot; none of its named tools is then the chosen one.
struct SetTool {
  EntityId id = 0;
  std::string tip_link;
  Pose X_LT;
};

/// The named tools of a robot. Where the chosen one is still among them its new values hold.
struct SetTools {
  EntityId id = 0;
  std::vector<ToolFrame> tools;
};

/// The user's named poses of a robot, "home" among them perhaps; see namedPosesOf() in named_poses.h.
struct SetNamedPoses {
  EntityId id = 0;
  std::vector<kinematics::NamedPose> poses;
};

/// Takes one of the named tools: tip link and tool centre point become its.
struct ChooseTool {
  EntityId id = 0;
  std::string name;
};

/// Attaches an entity to a link of another (a gripped part to the flange, a robot to a slide), at its present
/// placement. From then on it goes where the link goes. Refused: attaching it to itself or to an entity attached to it,
/// a link that does not exist.
struct Attach {
  EntityId id = 0;
  EntityId to = 0;
  std::string link;  ///< Empty: a robot's tip link; a solid itself.
};

/// Releases it where it is.
struct Detach {
  EntityId id = 0;
};

/// Makes a mechanism from solids of the cell, which become its parts. Its frame M is the first part's; points and axes
/// of the joints are given in the cell W, with the parts at their present placements, part names are the entities'
/// names.
struct MakeMechanism {
  std::string name;
  std::vector<EntityId> parts;
  std::vector<MechanismJoint> joints;  ///< p_MJ and axis_M hold p_WJ and axis_W.
};

/// Gives a mechanism other joints (in its own frame M, at all joints 0); positions are kept where the names are.
struct EditMechanism {
  EntityId id = 0;
  std::vector<MechanismJoint> joints;
};

/// Takes it apart: its parts become solids again at their present placements.
struct DissolveMechanism {
  EntityId id = 0;
};

struct AddPairSet {
  PairSet set;
};
struct EditPairSet {
  std::string name;  ///< The set as it is called now.
  PairSet set;       ///< What it shall be, with its new name.
};
struct RemovePairSet {
  std::string name;
};

/// Gives single pairs their own rules, in the place of those that they had; one that is checked and has no choice on
/// contact takes the pair's rule away. `text` names the step of undo; empty: derived from the rules.
struct SetPairRules {
  std::vector<PairRule> rules;
  std::string text = {};
};

struct AddGuide {
  Guide guide;
};
struct EditGuide {
  std::string name;  ///< The guide as it is called now.
  Guide guide;       ///< What it shall be, with its new name.
};
struct RemoveGuide {
  std::string name;
};

/// Adds a recording, or a copy that was made of one. Its file is written by who adds it.
struct AddTrajectory {
  TrajectoryReference trajectory;
};
/// Renames it; its file stays.
struct RenameTrajectory {
  std::string name, new_name;
};
/// Another motion in the place of `name`'s, an edited program: `trajectory.name` is its name from then on. Its file is
/// written by who sets it; the one before stays as it is.
struct SetTrajectory {
  std::string name;
  TrajectoryReference trajectory;
};
/// Takes it out of the cell; its file stays.
struct RemoveTrajectory {
  std::string name;
};

/// Adds a work task, or puts it in the place of the one called `before` (empty: of its own name).
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

/// Applies a command to a state; on error the state is as it was. `new_id` is what an added entity is given.
/// Refused: unknown ids and names, names that are taken, empty or not printable, values that are not finite or out of
/// range, moving a locked entity, removing a locked one. Gives the id of the entity it was about, 0 for others.
Expected<EntityId> apply(const Command& command, DocumentState& state, EntityId new_id);

/// Pose in W of the link that an attachment to `carrier` names (empty: of the carrier itself).
Pose carrierPose(const Entity& carrier, const std::string& link);

/// What the command does, for the menu: "Move Gripper G2". `state` is that before it.
std::string commandText(const Command& command, const DocumentState& state);

}  // namespace hapticell::workcell
