// SPDX-License-Identifier: Apache-2.0
// Commands on mechanisms.
#include <algorithm>
#include <variant>

#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"
#include "workcell/entity/named_poses.h"

namespace hapticell::workcell {

namespace {

/// The model of a mechanism from its definition; joints at rest, the tool in the middle of the tip.
Expected<void> rebuild(Entity& entity) {
  auto model = buildMechanism(entity.name, *entity.mechanism());
  if (!model) return makeError({.place = quotedName(entity.name), .found = model.error().text()});
  Jointed& body = entity.editJointed();
  body.model = std::make_shared<const kinematics::RobotModel>(std::move(*model));
  body.joints = kinematics::restPositions(*body.model);
  const int tip = body.model->defaultTip();
  const kinematics::Link& link = body.model->links[static_cast<std::size_t>(std::max(0, tip))];
  body.tip_link = link.name;
  body.X_LT = {};
  if (!link.visuals.empty()) body.X_LT = Pose::translation(link.visuals.front().mesh->bounds().center());
  return {};
}

void keepJoints(const Entity& before, Entity& after) {
  for (std::size_t k = 0; k < after.robot()->moving.size(); ++k) {
    const kinematics::Joint& joint = after.robot()->joints[static_cast<std::size_t>(after.robot()->moving[k])];
    const int old = before.robot()->findJoint(joint.name);
    const int variable = old < 0 ? -1 : before.robot()->joints[static_cast<std::size_t>(old)].variable;
    if (variable < 0 || static_cast<std::size_t>(variable) >= before.joints().size()) continue;
    after.editJointed().joints[k] =
        std::clamp(before.joints()[static_cast<std::size_t>(variable)], joint.lower, joint.upper);
  }
}

}  // namespace

Expected<EntityId> perform(const MakeMechanism& command, StateEdit& edit) {
  Entity made;
  auto definition = std::make_shared<MechanismDefinition>();
  for (const EntityId id : command.parts) {
    const auto part = edit.movable(id);
    HAPTICELL_TRY(part);
    if (!(*part)->mesh()) {
      return makeError({.place = quotedName((*part)->name),
                        .found = "it is not a solid",
                        .expected = "solids as parts of a mechanism"});
    }
    if (made.id == 0) made = **part;
    const Pose X_MP = made.X_WE.inverse() * (*part)->X_WE;
    definition->parts.push_back(
        {(*part)->name, (*part)->source, (*part)->mesh(), X_MP, (*part)->color, (*part)->contact.material});
  }
  const Pose X_MW = made.X_WE.inverse();
  definition->joints = command.joints;
  for (MechanismJoint& joint : definition->joints) {
    joint.p_MJ = X_MW * joint.p_MJ;
    joint.axis_M = X_MW.rotate(joint.axis_M);
  }
  made.body = Mechanism{{}, definition};
  made.name = command.name;
  made.source = {};
  made.frames.clear();
  made.attachment = {};
  DocumentState trial = edit.state();
  StateEdit there(trial, edit.newId());
  HAPTICELL_TRY(rebuild(made));
  for (const EntityId id : command.parts) there.takeOut(id, command.name);
  auto added = perform(AddEntity{std::move(made)}, there);
  if (added) edit.state() = std::move(trial);
  return added;
}

Expected<EntityId> perform(const EditMechanism& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  if (!changed.mechanism())
    return makeError({.place = quotedName(changed.name), .found = "it is not a mechanism", .expected = "a mechanism"});
  auto definition = std::make_shared<MechanismDefinition>(*changed.mechanism());
  definition->joints = command.joints;
  std::get<Mechanism>(changed.body).definition = std::move(definition);
  const Entity before = changed;
  HAPTICELL_TRY(rebuild(changed));
  keepJoints(before, changed);
  changed.editJointed().named_poses = posesFor(*changed.robot(), before);
  return edit.move(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const DissolveMechanism& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  const Entity mechanism = **entity;
  if (!mechanism.mechanism())
    return makeError(
        {.place = quotedName(mechanism.name), .found = "it is not a mechanism", .expected = "a mechanism"});
  DocumentState trial = edit.state();
  StateEdit there(trial, edit.newId());
  there.dropFromPairSets(mechanism.name);
  there.releaseAllFrom(mechanism.name);
  std::erase_if(trial.entities, [&](const auto& other) { return other->id == mechanism.id; });
  EntityId id = edit.newId();
  for (const MechanismPart& part : mechanism.mechanism()->parts) {
    Entity solid;
    solid.name = part.name;
    for (int n = 2; trial.findByName(solid.name); ++n) solid.name = part.name + " " + std::to_string(n);
    solid.source = part.source;
    solid.body = Solid{part.mesh};
    solid.color = part.color;
    solid.contact.material = part.material;
    solid.parent = mechanism.parent;
    solid.X_WE = carrierPose(mechanism, part.name);
    StateEdit adding(trial, id++);
    if (auto added = perform(AddEntity{std::move(solid)}, adding); !added) return added;
  }
  edit.state() = std::move(trial);
  return edit.newId();
}

}  // namespace hapticell::workcell
