// SPDX-License-Identifier: Apache-2.0
// Commands on entities of every kind.
#include <algorithm>
#include <variant>

#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"
#include "workcell/entity/named_poses.h"

namespace hapticell::workcell {

namespace {

/// What its body must have and has not; empty: nothing.
Text missingOf(const Entity& entity) {
  switch (entity.kind()) {
    case EntityKind::kSolid:
      return entity.mesh() ? Text() : Text("a mesh");
    case EntityKind::kRobot:
    case EntityKind::kMechanism:
    case EntityKind::kMannequin:
      return entity.robot() ? Text() : Text("a robot");
    case EntityKind::kAssembly:
    case EntityKind::kFrame:
      break;
  }
  return {};
}

Expected<void> checkNew(const Entity& entity, const DocumentState& state) {
  if (auto checked = checkName(Text("the entity's name"), entity.name); !checked) return checked;
  if (const Text missing = missingOf(entity); !missing.empty() && !entity.unloaded)
    return makeError({.place = quotedName(entity.name), .found = "it is empty", .expected = missing});
  if (auto checked = checkPose(quotedName(entity.name), entity.X_WE); !checked) return checked;
  if (!entity.joints().empty()) {
    if (auto checked = checkJoints(entity, entity.joints()); !checked) return checked;
  }
  if (auto checked = checkTools(entity); !checked) return checked;
  if (auto checked = checkNamedPoses(entity); !checked) return checked;
  if (auto checked = checkAttachment(entity, state); !checked) return checked;
  if (auto checked = checkFrames(entity); !checked) return checked;
  return checkProperties(entity);
}

/// What an entity's own properties are, and an assembly's mean for those below it.
void setShared(const SetProperties& command, Entity& target) {
  if (command.color) target.color = *command.color;
  if (command.visible) target.visible = *command.visible;
  if (command.locked) target.locked = *command.locked;
  if (command.checked) target.checked = *command.checked;
  if (command.on_contact) target.contact.on_contact = *command.on_contact;
  if (command.force_class) target.contact.force_class = *command.force_class;
  if (command.material) target.contact.material = *command.material;
}

/// The positions of `before` for another model, by the joints' names, within its limits; others at rest.
std::vector<double> jointsFor(const kinematics::RobotModel& model, const Entity& before) {
  std::vector<double> q = kinematics::restPositions(model);
  for (std::size_t i = 0; i < model.moving.size(); ++i) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    for (std::size_t k = 0; before.robot() && k < before.joints().size(); ++k) {
      const int old = before.robot()->moving[k];
      if (before.robot()->joints[static_cast<std::size_t>(old)].name == joint.name) {
        q[i] = std::clamp(before.joints()[k], joint.lower, joint.upper);
      }
    }
  }
  return q;
}

/// Puts the shape of another entity of the same kind into a body. The tool and the poses stay where they fit.
struct ShapeTaker {
  const Entity& fresh;
  const Entity& before;

  void operator()(Solid& solid) const { solid = Solid{fresh.mesh()}; }
  void operator()(Robot& robot) const { takeModel(robot); }
  void operator()(Mannequin& mannequin) const {
    mannequin.figure = fresh.figure();
    takeModel(mannequin);
  }
  void operator()(Mechanism&) const {}  // Made from its definition.
  void operator()(Assembly&) const {}
  void operator()(CellFrame&) const {}

  void takeModel(Jointed& jointed) const {
    const kinematics::RobotModel& model = *fresh.robot();
    jointed.model = fresh.robot();
    jointed.joints = jointsFor(model, before);
    jointed.named_poses = posesFor(model, before);
    if (model.findLink(jointed.tip_link) < 0) jointed.tip_link = fresh.jointed().tip_link;
    std::erase_if(jointed.tools, [&](const ToolFrame& tool) { return model.findLink(tool.tip_link) < 0; });
  }
};

}  // namespace

Expected<EntityId> perform(const AddEntity& command, StateEdit& edit) {
  if (edit.state().findByName(command.entity.name)) return makeError(taken(command.entity.name));
  return addNewlyNamed(command.entity, edit);
}

Expected<EntityId> addNewlyNamed(const Entity& added, StateEdit& edit) {
  auto entity = std::make_shared<Entity>(added);
  entity->id = edit.newId();
  HAPTICELL_TRY(checkNew(*entity, edit.state()));
  if (entity->robot() && entity->joints().empty()) entity->setJoints(kinematics::restPositions(*entity->robot()));
  edit.state().entities.push_back(std::move(entity));
  return edit.newId();
}

Expected<EntityId> perform(const RemoveEntity& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  const std::vector<EntityId> family = familyOf(edit.state(), command.id);
  for (EntityId id : family) {
    HAPTICELL_TRY(edit.movable(id));
  }
  for (EntityId id : family) {
    const std::string name = edit.state().find(id)->name;
    edit.dropFromPairSets(name);
    std::erase_if(edit.state().pair_rules, [&](const PairRule& r) { return r.first == name || r.second == name; });
    edit.releaseAllFrom(name);
    std::erase_if(edit.state().guides, [&](const Guide& g) { return g.entity == name || g.surface == name; });
    std::erase_if(edit.state().work_tasks, [&](const auto& task) { return task.mannequin == name; });
  }
  std::erase_if(edit.state().entities,
                [&](const auto& other) { return std::find(family.begin(), family.end(), other->id) != family.end(); });
  return command.id;
}

Expected<EntityId> perform(const RenameEntity& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(checkName(Text("the entity's name"), command.name));
  const Entity* other = edit.state().findByName(command.name);
  if (other && other->id != command.id) return makeError(taken(command.name));
  for (PairSet& set : edit.state().pair_sets) {
    std::replace(set.first.begin(), set.first.end(), (*entity)->name, command.name);
    std::replace(set.second.begin(), set.second.end(), (*entity)->name, command.name);
  }
  const std::string before = (*entity)->name;
  for (PairRule& rule : edit.state().pair_rules) {
    if (rule.first == before) rule.first = command.name;
    if (rule.second == before) rule.second = command.name;
  }
  for (Guide& guide : edit.state().guides) {
    if (guide.entity == before) guide.entity = command.name;
    if (guide.surface == before) guide.surface = command.name;
  }
  for (auto& task : edit.state().work_tasks) {
    if (task.mannequin == before) task.mannequin = command.name;
  }
  for (const auto& near : std::vector(edit.state().entities)) {
    if (near->parent == before) edit.change(near->id, [&](Entity& changed) { changed.parent = command.name; });
    if (near->attachment.to != before) continue;
    edit.change(near->id, [&](Entity& changed) { changed.attachment.to = command.name; });
  }
  return edit.change(command.id, [&](Entity& changed) { changed.name = command.name; });
}

Expected<EntityId> perform(const ReplaceShape& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  const Entity& before = **entity;
  const bool fits =
      before.kind() == command.fresh.kind() && (command.fresh.mesh() || command.fresh.robot()) && !before.mechanism();
  if (!fits)
    return makeError({.place = quotedName(before.name),
                      .found = "another kind of entity",
                      .expected = "the same kind of entity as before"});
  Entity changed = before;
  changed.source = command.fresh.source;
  changed.unloaded.reset();
  if (command.fresh.figure()) changed.contact.mass = command.fresh.contact.mass;
  std::visit(ShapeTaker{command.fresh, before}, changed.body);
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const SetCollisionProxy& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  if (!(*entity)->mesh())
    return makeError({.place = quotedName((*entity)->name), .found = "the mesh is missing", .expected = "a solid"});
  const bool wanted = command.proxy.kind != CollisionProxy::Kind::kNone;
  if (wanted && (!command.proxy.mesh || command.proxy.mesh->triangles.empty())) {
    return makeError(
        {.place = quotedName((*entity)->name), .found = "no mesh for the collision check", .expected = "a mesh"});
  }
  return edit.change(command.id,
                     [&](Entity& target) { target.editSolid().proxy = wanted ? command.proxy : CollisionProxy{}; });
}

Expected<EntityId> perform(const SetPlacement& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(checkPose(quotedName((*entity)->name), command.X_WE));
  return edit.moveFamily(**entity, [&](Entity& changed) { changed.X_WE = command.X_WE; });
}

Expected<EntityId> perform(const SetJoints& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(checkJoints(**entity, command.joints));
  return edit.move(command.id, [&](Entity& changed) { changed.setJoints(command.joints); });
}

Expected<EntityId> perform(const SetConfiguration& command, StateEdit& edit) {
  const auto entity = edit.movable(command.id);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(checkPose(quotedName((*entity)->name), command.X_WE));
  HAPTICELL_TRY(checkJoints(**entity, command.joints));
  return edit.moveFamily(**entity, [&](Entity& changed) {
    changed.X_WE = command.X_WE;
    changed.setJoints(command.joints);
  });
}

Expected<EntityId> perform(const SetProperties& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  setShared(command, changed);
  if (command.mass) changed.contact.mass = *command.mass;
  if (command.parent) changed.parent = *command.parent;
  HAPTICELL_TRY(checkProperties(changed));
  const std::vector<EntityId> family = familyOf(edit.state(), command.id);
  if (command.parent) {
    const Entity* parent = edit.state().findByName(changed.parent);
    if (parent && std::find(family.begin(), family.end(), parent->id) != family.end()) {
      return makeError(
          {.place = quotedName(changed.name), .found = "an assembly inside itself", .expected = "another assembly"});
    }
  }
  if (changed.kind() == EntityKind::kAssembly) {
    for (EntityId id : family) edit.change(id, [&](Entity& target) { setShared(command, target); });
  }
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const SetFrames& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  changed.frames = command.frames;
  HAPTICELL_TRY(checkFrames(changed));
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

}  // namespace hapticell::workcell
