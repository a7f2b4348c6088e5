// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/document/command.h"
#include "workcell/document/state_edit.h"

namespace hapticell::workcell {

// One function a command, in a file by kind (entity, robot, mechanism, set). Each gives what apply() gives and leaves
// the state untouched where it gives an error. A new command needs: its struct and place in `Command`, a line here with
// its function, and a line in command_text.cpp.

Expected<EntityId> perform(const AddEntity& command, StateEdit& edit);
Expected<EntityId> perform(const RemoveEntity& command, StateEdit& edit);
Expected<EntityId> perform(const RenameEntity& command, StateEdit& edit);
Expected<EntityId> perform(const ReplaceShape& command, StateEdit& edit);
Expected<EntityId> perform(const SetCollisionProxy& command, StateEdit& edit);
Expected<EntityId> perform(const SetPlacement& command, StateEdit& edit);
Expected<EntityId> perform(const SetJoints& command, StateEdit& edit);
Expected<EntityId> perform(const SetConfiguration& command, StateEdit& edit);
Expected<EntityId> perform(const SetProperties& command, StateEdit& edit);
Expected<EntityId> perform(const SetFrames& command, StateEdit& edit);
Expected<EntityId> perform(const SetTool& command, StateEdit& edit);
Expected<EntityId> perform(const SetTools& command, StateEdit& edit);
Expected<EntityId> perform(const SetNamedPoses& command, StateEdit& edit);
Expected<EntityId> perform(const ChooseTool& command, StateEdit& edit);
Expected<EntityId> perform(const Attach& command, StateEdit& edit);
Expected<EntityId> perform(const Detach& command, StateEdit& edit);
Expected<EntityId> perform(const MakeMechanism& command, StateEdit& edit);
Expected<EntityId> perform(const EditMechanism& command, StateEdit& edit);
Expected<EntityId> perform(const DissolveMechanism& command, StateEdit& edit);
Expected<EntityId> perform(const AddPairSet& command, StateEdit& edit);
Expected<EntityId> perform(const EditPairSet& command, StateEdit& edit);
Expected<EntityId> perform(const RemovePairSet& command, StateEdit& edit);
Expected<EntityId> perform(const SetPairRules& command, StateEdit& edit);
Expected<EntityId> perform(const AddGuide& command, StateEdit& edit);
Expected<EntityId> perform(const EditGuide& command, StateEdit& edit);
Expected<EntityId> perform(const RemoveGuide& command, StateEdit& edit);
Expected<EntityId> perform(const AddTrajectory& command, StateEdit& edit);
Expected<EntityId> perform(const RenameTrajectory& command, StateEdit& edit);
Expected<EntityId> perform(const SetTrajectory& command, StateEdit& edit);
Expected<EntityId> perform(const RemoveTrajectory& command, StateEdit& edit);
Expected<EntityId> perform(const SetWorkTask& command, StateEdit& edit);
Expected<EntityId> perform(const RemoveWorkTask& command, StateEdit& edit);
Expected<EntityId> perform(const SetView& command, StateEdit& edit);

/// As AddEntity, where the caller knows that no entity has its name: none is looked for.
Expected<EntityId> addNewlyNamed(const Entity& added, StateEdit& edit);

/// Whether the entity to which `entity` is attached exists, with the link that it names.
Expected<void> checkAttachment(const Entity& entity, const DocumentState& state);

/// The link that carries a robot's tool: the chosen tip, else the model's last link.
std::string tipOf(const Entity& robot);

}  // namespace hapticell::workcell
