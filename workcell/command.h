// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/error.h"
#include "workcell/document_state.h"

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

struct SetPlacement {
  EntityId id = 0;
  Pose X_WE;
};

/// One value a variable of the robot, rad or m.
struct SetJoints {
  EntityId id = 0;
  std::vector<double> joints;
};

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

/// The tool centre point of a robot.
struct SetTool {
  EntityId id = 0;
  std::string tip_link;
  Pose X_LT;
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

struct SetView {
  std::optional<SavedView> view;
};

using Command = std::variant<AddEntity, RemoveEntity, RenameEntity, SetPlacement, SetJoints, SetConfiguration,
                             SetProperties, SetFrames, SetTool, AddPairSet, EditPairSet, RemovePairSet, SetView>;

/// Applies a command to a state; on error the state is as it was. `new_id` is what an added entity is given.
/// Refused: unknown ids and names, names that are taken, empty or not printable, values that are not finite or out of
/// range, moving a locked entity, removing a locked one. Gives the id of the entity it was about, 0 for others.
Expected<EntityId> apply(const Command& command, DocumentState& state, EntityId new_id);

/// What the command does, for the menu: "Move Gripper G2". `state` is that before it.
std::string commandText(const Command& command, const DocumentState& state);

}  // namespace hapticell::workcell
