// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/document/command.h"
#include "workcell/document/state_edit.h"

namespace hapticell::workcell {

// One function per command, in a file by kind (entity, robot, mechanism, set). Each returns what apply() returns and
// leaves the state unchanged on error. A new command needs: its struct and an entry in `Command`, a line here with its
// function, and a line in command_text.cpp.

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

/// Like AddEntity, for a caller that knows that the name is unused: does not search for it.
Expected<EntityId> addNewlyNamed(const Entity& added, StateEdit& edit);

/// Checks that the entity to which `entity` is attached exists and has the named link.
Expected<void> checkAttachment(const Entity& entity, const DocumentState& state);

/// The link that carries a robot's tool: the chosen tip link, else the model's last link.
std::string tipOf(const Entity& robot);

}  // namespace hapticell::workcell
