// SPDX-License-Identifier: Apache-2.0
#include "workcell/command.h"

#include <algorithm>
#include <cmath>

#include "workcell/mechanism.h"

namespace hapticell::workcell {

namespace {

Error refusal(std::string place, std::string found, std::string expected, std::string fix = {}) {
  return {"", std::move(place), std::move(found), std::move(expected), std::move(fix)};
}

std::string inQuotes(const std::string& name) {
  return "'" + name + "'";
}

/// What a name may be: shown in one line of the tree.
bool isName(const std::string& name) {
  constexpr std::size_t kLongest = 200;
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  return !name.empty() && name.size() <= kLongest && printable && name.front() != ' ' && name.back() != ' ';
}

Expected<void> checkName(const std::string& what, const std::string& name) {
  if (isName(name)) return {};
  return makeError(refusal(what, inQuotes(name), "a printable name of 1 to 200 letters"));
}

Expected<void> checkPose(const std::string& what, const Pose& pose) {
  if (pose.isValid()) return {};
  return makeError(refusal(what, "a pose that is not one", "finite numbers and a quaternion of length 1"));
}

/// Applies commands to one state; each function leaves it untouched where it gives an error.
class Applier {
 public:
  Applier(DocumentState& state, EntityId new_id) : state_(state), new_id_(new_id) {}

  Expected<EntityId> operator()(const AddEntity& command) {
    auto entity = std::make_shared<Entity>(command.entity);
    entity->id = new_id_;
    if (auto checked = checkNew(*entity); !checked) return makeError(checked.error());
    if (entity->robot && entity->joints.empty()) entity->joints = kinematics::restPositions(*entity->robot);
    state_.entities.push_back(std::move(entity));
    return new_id_;
  }

  Expected<EntityId> operator()(const RemoveEntity& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    const std::vector<EntityId> family = familyOf(state_, command.id);
    for (EntityId id : family) {
      if (auto free = movable(id); !free) return makeError(free.error());
    }
    for (EntityId id : family) {
      const std::string name = state_.find(id)->name;
      dropFromPairSets(name);
      releaseAllFrom(name);
      std::erase_if(state_.guides, [&](const Guide& g) { return g.entity == name || g.surface == name; });
    }
    std::erase_if(state_.entities, [&](const auto& other) {
      return std::find(family.begin(), family.end(), other->id) != family.end();
    });
    return command.id;
  }

  Expected<EntityId> operator()(const RenameEntity& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    if (auto checked = checkName("the entity's name", command.name); !checked) return makeError(checked.error());
    const Entity* other = state_.findByName(command.name);
    if (other && other->id != command.id) return makeError(taken(command.name));
    for (PairSet& set : state_.pair_sets) {
      std::replace(set.first.begin(), set.first.end(), (*entity)->name, command.name);
      std::replace(set.second.begin(), set.second.end(), (*entity)->name, command.name);
    }
    const std::string before = (*entity)->name;
    for (Guide& guide : state_.guides) {
      if (guide.entity == before) guide.entity = command.name;
      if (guide.surface == before) guide.surface = command.name;
    }
    for (const auto& near : std::vector(state_.entities)) {
      if (near->parent == before) change(near->id, [&](Entity& changed) { changed.parent = command.name; });
      if (near->attachment.to != before) continue;
      change(near->id, [&](Entity& changed) { changed.attachment.to = command.name; });
    }
    return change(command.id, [&](Entity& changed) { changed.name = command.name; });
  }

  Expected<EntityId> operator()(const SetPlacement& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    if (auto checked = checkPose(inQuotes((*entity)->name), command.X_WE); !checked) return makeError(checked.error());
    return moveFamily(**entity, [&](Entity& changed) { changed.X_WE = command.X_WE; });
  }

  Expected<EntityId> operator()(const SetJoints& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    if (auto checked = checkJoints(**entity, command.joints); !checked) return makeError(checked.error());
    return move(command.id, [&](Entity& changed) { changed.joints = command.joints; });
  }

  Expected<EntityId> operator()(const SetConfiguration& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    if (auto checked = checkPose(inQuotes((*entity)->name), command.X_WE); !checked) return makeError(checked.error());
    if (auto checked = checkJoints(**entity, command.joints); !checked) return makeError(checked.error());
    return moveFamily(**entity, [&](Entity& changed) {
      changed.X_WE = command.X_WE;
      changed.joints = command.joints;
    });
  }

  Expected<EntityId> operator()(const SetProperties& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    if (command.color) changed.color = *command.color;
    if (command.visible) changed.visible = *command.visible;
    if (command.locked) changed.locked = *command.locked;
    if (command.checked) changed.checked = *command.checked;
    if (command.on_contact) changed.on_contact = *command.on_contact;
    if (command.force_class) changed.force_class = *command.force_class;
    if (command.material) changed.material = *command.material;
    if (command.mass) changed.mass = *command.mass;
    if (command.parent) changed.parent = *command.parent;
    if (auto checked = checkProperties(changed); !checked) return makeError(checked.error());
    const std::vector<EntityId> family = familyOf(state_, command.id);
    if (command.parent) {
      const Entity* parent = state_.findByName(changed.parent);
      if (parent && std::find(family.begin(), family.end(), parent->id) != family.end()) {
        return makeError(refusal(inQuotes(changed.name), "a place below itself", "another assembly"));
      }
    }
    if (changed.kind == EntityKind::kAssembly) {
      for (EntityId id : family) change(id, [&](Entity& target) { handDown(command, target); });
    }
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const SetFrames& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    changed.frames = command.frames;
    if (auto checked = checkFrames(changed); !checked) return makeError(checked.error());
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const SetTool& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    changed.tip_link = command.tip_link;
    changed.X_LT = command.X_LT;
    changed.tool.clear();
    if (!changed.robot) return makeError(refusal(inQuotes(changed.name), "a solid", "a robot, which can have a tool"));
    if (auto checked = checkTool(changed); !checked) return makeError(checked.error());
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const SetTools& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    if (!changed.robot) return makeError(refusal(inQuotes(changed.name), "a solid", "a robot, which can have tools"));
    changed.tools = command.tools;
    takeChosenTool(changed);
    if (auto checked = checkTools(changed); !checked) return makeError(checked.error());
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const ChooseTool& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    changed.tool = command.name;
    takeChosenTool(changed);
    if (changed.tool != command.name) {
      return makeError(
          refusal(inQuotes(changed.name), "no tool " + inQuotes(command.name), "the name of one of its tools"));
    }
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const Attach& command) {
    const auto entity = existing(command.id), carrier = existing(command.to);
    if (!entity) return makeError(entity.error());
    if (!carrier) return makeError(carrier.error());
    for (const Entity* at = *carrier; at; at = state_.findByName(at->attachment.to)) {
      if (at->id != command.id) continue;
      return makeError(refusal(inQuotes((*entity)->name), inQuotes((*carrier)->name) + " is that entity or hangs on it",
                               "another entity to hang it on"));
    }
    Attachment attachment{(*carrier)->name, command.link, {}};
    if ((*carrier)->robot && attachment.link.empty()) attachment.link = tipOf(**carrier);
    Entity changed = **entity;
    changed.attachment = std::move(attachment);
    if (auto checked = checkAttachment(changed); !checked) return makeError(checked.error());
    changed.attachment.X_LE = carrierPose(**carrier, changed.attachment.link).inverse() * changed.X_WE;
    return change(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const Detach& command) {
    const auto entity = existing(command.id);
    if (!entity) return makeError(entity.error());
    return change(command.id, [](Entity& changed) { changed.attachment = {}; });
  }

  Expected<EntityId> operator()(const MakeMechanism& command) {
    Entity made;
    auto definition = std::make_shared<MechanismDefinition>();
    for (const EntityId id : command.parts) {
      const auto part = movable(id);
      if (!part) return makeError(part.error());
      if (!(*part)->mesh) {
        return makeError(refusal(inQuotes((*part)->name), "it is no solid", "solids as parts of a mechanism"));
      }
      if (made.id == 0) {
        made = **part;
        made.mesh.reset();
      }
      const Pose X_MP = made.X_WE.inverse() * (*part)->X_WE;
      definition->parts.push_back(
          {(*part)->name, (*part)->source, (*part)->mesh, X_MP, (*part)->color, (*part)->material});
    }
    const Pose X_MW = made.X_WE.inverse();
    definition->joints = command.joints;
    for (MechanismJoint& joint : definition->joints) {
      joint.p_MJ = X_MW * joint.p_MJ;
      joint.axis_M = X_MW.rotate(joint.axis_M);
    }
    made.kind = EntityKind::kMechanism;
    made.name = command.name;
    made.source = {};
    made.frames.clear();
    made.attachment = {};
    made.mechanism = definition;
    DocumentState trial = state_;
    Applier there(trial, new_id_);
    if (auto rebuilt = rebuild(made); !rebuilt) return makeError(rebuilt.error());
    for (const EntityId id : command.parts) there.takeOut(id, command.name);
    auto added = there(AddEntity{std::move(made)});
    if (added) state_ = std::move(trial);
    return added;
  }

  Expected<EntityId> operator()(const EditMechanism& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    Entity changed = **entity;
    if (!changed.mechanism) return makeError(refusal(inQuotes(changed.name), "it is no mechanism", "a mechanism"));
    auto definition = std::make_shared<MechanismDefinition>(*changed.mechanism);
    definition->joints = command.joints;
    changed.mechanism = std::move(definition);
    const Entity before = changed;
    if (auto rebuilt = rebuild(changed); !rebuilt) return makeError(rebuilt.error());
    keepJoints(before, changed);
    return move(command.id, [&](Entity& target) { target = changed; });
  }

  Expected<EntityId> operator()(const DissolveMechanism& command) {
    const auto entity = movable(command.id);
    if (!entity) return makeError(entity.error());
    const Entity mechanism = **entity;
    if (!mechanism.mechanism) return makeError(refusal(inQuotes(mechanism.name), "it is no mechanism", "a mechanism"));
    DocumentState trial = state_;
    Applier there(trial, new_id_);
    there.dropFromPairSets(mechanism.name);
    there.releaseAllFrom(mechanism.name);
    std::erase_if(trial.entities, [&](const auto& other) { return other->id == mechanism.id; });
    EntityId id = new_id_;
    for (const MechanismPart& part : mechanism.mechanism->parts) {
      Entity solid;
      solid.name = part.name;
      for (int n = 2; trial.findByName(solid.name); ++n) solid.name = part.name + " " + std::to_string(n);
      solid.source = part.source;
      solid.mesh = part.mesh;
      solid.color = part.color;
      solid.material = part.material;
      solid.parent = mechanism.parent;
      solid.X_WE = carrierPose(mechanism, part.name);
      Applier adding(trial, id++);
      if (auto added = adding(AddEntity{std::move(solid)}); !added) return added;
    }
    state_ = std::move(trial);
    return new_id_;
  }

  Expected<EntityId> operator()(const AddPairSet& command) {
    if (auto checked = checkPairSet(command.set); !checked) return makeError(checked.error());
    if (state_.findPairSet(command.set.name)) return makeError(taken(command.set.name));
    state_.pair_sets.push_back(command.set);
    return EntityId{0};
  }

  Expected<EntityId> operator()(const EditPairSet& command) {
    const auto found = findSet(command.name);
    if (found == state_.pair_sets.end()) return makeError(unknownSet(command.name));
    if (auto checked = checkPairSet(command.set); !checked) return makeError(checked.error());
    const PairSet* other = state_.findPairSet(command.set.name);
    if (other && other != &*found) return makeError(taken(command.set.name));
    *found = command.set;
    return EntityId{0};
  }

  Expected<EntityId> operator()(const RemovePairSet& command) {
    const auto found = findSet(command.name);
    if (found == state_.pair_sets.end()) return makeError(unknownSet(command.name));
    state_.pair_sets.erase(found);
    return EntityId{0};
  }

  Expected<EntityId> operator()(const AddGuide& command) {
    if (auto checked = checkBound(command.guide); !checked) return makeError(checked.error());
    if (state_.findGuide(command.guide.name)) return makeError(taken(command.guide.name));
    state_.guides.push_back(command.guide);
    return EntityId{0};
  }

  Expected<EntityId> operator()(const EditGuide& command) {
    const auto found = findGuide(command.name);
    if (found == state_.guides.end()) return makeError(unknownGuide(command.name));
    if (auto checked = checkBound(command.guide); !checked) return makeError(checked.error());
    const Guide* other = state_.findGuide(command.guide.name);
    if (other && other != &*found) return makeError(taken(command.guide.name));
    *found = command.guide;
    return EntityId{0};
  }

  Expected<EntityId> operator()(const RemoveGuide& command) {
    const auto found = findGuide(command.name);
    if (found == state_.guides.end()) return makeError(unknownGuide(command.name));
    state_.guides.erase(found);
    return EntityId{0};
  }

  Expected<EntityId> operator()(const SetView& command) {
    state_.view = command.view;
    return EntityId{0};
  }

 private:
  static Error taken(const std::string& name) {
    return refusal("", "the name " + inQuotes(name) + " is taken", "a name of its own");
  }
  static Error unknownSet(const std::string& name) {
    return refusal("", "no pair set " + inQuotes(name), "the name of one");
  }

  static Error unknownGuide(const std::string& name) {
    return refusal("", "no guide " + inQuotes(name), "the name of one");
  }
  std::vector<Guide>::iterator findGuide(const std::string& name) {
    return std::find_if(state_.guides.begin(), state_.guides.end(),
                        [&](const Guide& guide) { return guide.name == name; });
  }
  Expected<void> checkBound(const Guide& guide) const {
    if (auto checked = checkName("the guide's name", guide.name); !checked) return checked;
    if (auto checked = checkGuide(guide); !checked) return checked;
    for (const std::string* name : {&guide.entity, &guide.surface}) {
      if (name->empty() || state_.findByName(*name)) continue;
      return makeError(refusal("guide " + inQuotes(guide.name), "no entity " + inQuotes(*name), "the name of one"));
    }
    return {};
  }

  std::vector<PairSet>::iterator findSet(const std::string& name) {
    return std::find_if(state_.pair_sets.begin(), state_.pair_sets.end(),
                        [&](const PairSet& set) { return set.name == name; });
  }

  Expected<const Entity*> existing(EntityId id) const {
    const Entity* entity = state_.find(id);
    if (!entity) return makeError(refusal("", "no entity " + std::to_string(id), "one that is in the document"));
    return entity;
  }

  Expected<const Entity*> movable(EntityId id) const {
    const auto entity = existing(id);
    if (entity && (*entity)->locked) {
      return makeError(refusal(inQuotes((*entity)->name), "the entity is locked", "", "Unlock it first."));
    }
    return entity;
  }

  template <typename Edit>
  EntityId change(EntityId id, const Edit& edit) {
    for (auto& entity : state_.entities) {
      if (entity->id != id) continue;
      auto changed = std::make_shared<Entity>(*entity);
      edit(*changed);
      entity = std::move(changed);
    }
    return id;
  }

  /// A change of where an entity stands: what hangs on it goes with it, and where it hangs itself it keeps its place.
  template <typename Edit>
  EntityId move(EntityId id, const Edit& edit) {
    change(id, edit);
    const Entity& moved = *state_.find(id);
    if (const Entity* carrier = state_.findByName(moved.attachment.to)) {
      const Pose X_LE = carrierPose(*carrier, moved.attachment.link).inverse() * moved.X_WE;
      change(id, [&](Entity& changed) { changed.attachment.X_LE = X_LE; });
    }
    carryAll(id);
    return id;
  }

  void carryAll(EntityId id) {
    const std::shared_ptr<const Entity> carrier = *std::find_if(state_.entities.begin(), state_.entities.end(),
                                                                [&](const auto& entity) { return entity->id == id; });
    for (const auto& carried : std::vector(state_.entities)) {
      if (carried->attachment.to != carrier->name) continue;
      const Pose X_WE = carrierPose(*carrier, carried->attachment.link) * carried->attachment.X_LE;
      change(carried->id, [&](Entity& changed) { changed.X_WE = X_WE; });
      carryAll(carried->id);
    }
  }

  void releaseAllFrom(const std::string& name) {
    for (const auto& carried : std::vector(state_.entities)) {
      if (carried->attachment.to == name) change(carried->id, [](Entity& changed) { changed.attachment = {}; });
    }
  }

  /// Removes a solid that becomes part of `into`, which takes its place in the pair sets.
  void takeOut(EntityId id, const std::string& into) {
    const std::string name = state_.find(id)->name;
    for (PairSet& set : state_.pair_sets) {
      for (auto* side : {&set.first, &set.second}) {
        const bool there = std::find(side->begin(), side->end(), into) != side->end();
        if (there) std::erase(*side, name);
        std::replace(side->begin(), side->end(), name, into);
      }
    }
    releaseAllFrom(name);
    std::erase_if(state_.entities, [&](const auto& other) { return other->id == id; });
  }

  /// The model of a mechanism from its definition; joints at rest, the tool in the middle of the tip.
  static Expected<void> rebuild(Entity& entity) {
    auto model = buildMechanism(entity.name, *entity.mechanism);
    if (!model) return makeError({"", inQuotes(entity.name), model.error().message(), "", ""});
    entity.robot = std::make_shared<const kinematics::RobotModel>(std::move(*model));
    entity.joints = kinematics::restPositions(*entity.robot);
    const int tip = entity.robot->defaultTip();
    const kinematics::Link& link = entity.robot->links[static_cast<std::size_t>(std::max(0, tip))];
    entity.tip_link = link.name;
    entity.X_LT = {};
    if (!link.visuals.empty()) entity.X_LT = Pose::translation(link.visuals.front().mesh->bounds().center());
    return {};
  }

  static void keepJoints(const Entity& before, Entity& after) {
    for (std::size_t k = 0; k < after.robot->moving.size(); ++k) {
      const kinematics::Joint& joint = after.robot->joints[static_cast<std::size_t>(after.robot->moving[k])];
      const int old = before.robot->findJoint(joint.name);
      const int variable = old < 0 ? -1 : before.robot->joints[static_cast<std::size_t>(old)].variable;
      if (variable < 0 || static_cast<std::size_t>(variable) >= before.joints.size()) continue;
      after.joints[k] = std::clamp(before.joints[static_cast<std::size_t>(variable)], joint.lower, joint.upper);
    }
  }

  static std::string tipOf(const Entity& robot) {
    if (!robot.tip_link.empty()) return robot.tip_link;
    const int tip = robot.robot->defaultTip();
    return tip < 0 ? std::string{} : robot.robot->links[static_cast<std::size_t>(tip)].name;
  }

  Expected<void> checkAttachment(const Entity& entity) const {
    if (entity.attachment.to.empty()) return {};
    const Entity* carrier = state_.findByName(entity.attachment.to);
    const std::string place = inQuotes(entity.name) + ", attached";
    if (!carrier)
      return makeError(refusal(place, "no entity " + inQuotes(entity.attachment.to), "one of the document"));
    if (!entity.attachment.link.empty() && (!carrier->robot || carrier->robot->findLink(entity.attachment.link) < 0)) {
      return makeError(
          refusal(place, "no link " + inQuotes(entity.attachment.link), "a link of " + inQuotes(carrier->name)));
    }
    return checkPose(place, entity.attachment.X_LE);
  }

  static void takeChosenTool(Entity& robot) {
    const auto chosen = std::find_if(robot.tools.begin(), robot.tools.end(),
                                     [&](const ToolFrame& tool) { return tool.name == robot.tool; });
    if (chosen == robot.tools.end()) {
      robot.tool.clear();
      return;
    }
    robot.tip_link = chosen->tip_link;
    robot.X_LT = chosen->X_LT;
  }

  static Expected<void> checkTools(const Entity& entity) {
    std::vector<std::string> names;
    for (const ToolFrame& tool : entity.tools) {
      const std::string place = inQuotes(entity.name) + ", tool " + inQuotes(tool.name);
      if (auto checked = checkName("a tool of " + inQuotes(entity.name), tool.name); !checked) return checked;
      if (auto checked = checkPose(place, tool.X_LT); !checked) return checked;
      if (!entity.robot || entity.robot->findLink(tool.tip_link) < 0) {
        return makeError(refusal(place, "no link " + inQuotes(tool.tip_link), "a link of the robot"));
      }
      if (std::find(names.begin(), names.end(), tool.name) != names.end()) return makeError(taken(tool.name));
      names.push_back(tool.name);
    }
    return checkTool(entity);
  }

  /// Moves an entity, and with an assembly all that stands below it.
  template <typename Edit>
  EntityId moveFamily(const Entity& entity, const Edit& edit) {
    const EntityId id = entity.id;
    const Pose X_OldW = entity.X_WE.inverse();
    const bool assembly = entity.kind == EntityKind::kAssembly;
    move(id, edit);
    if (!assembly) return id;
    const Pose X_WNew_WOld = state_.find(id)->X_WE * X_OldW;
    for (EntityId below : familyOf(state_, id)) {
      if (below == id) continue;
      change(below, [&](Entity& changed) { changed.X_WE = X_WNew_WOld * changed.X_WE; });
      carryAll(below);
    }
    return id;
  }

  /// What an assembly's properties mean for those below it.
  static void handDown(const SetProperties& command, Entity& target) {
    if (command.color) target.color = *command.color;
    if (command.visible) target.visible = *command.visible;
    if (command.locked) target.locked = *command.locked;
    if (command.checked) target.checked = *command.checked;
    if (command.on_contact) target.on_contact = *command.on_contact;
    if (command.force_class) target.force_class = *command.force_class;
    if (command.material) target.material = *command.material;
  }

  /// A side that loses its last name would mean "everything": such a set is removed instead.
  void dropFromPairSets(const std::string& name) {
    std::erase_if(state_.pair_sets, [&](PairSet& set) {
      const bool emptied = (std::erase(set.first, name) > 0 && set.first.empty()) |
                           (std::erase(set.second, name) > 0 && set.second.empty());
      return emptied;
    });
  }

  Expected<void> checkNew(const Entity& entity) const {
    if (auto checked = checkName("the entity's name", entity.name); !checked) return checked;
    if (state_.findByName(entity.name)) return makeError(taken(entity.name));
    const bool solid = entity.kind == EntityKind::kSolid, assembly = entity.kind == EntityKind::kAssembly;
    if (!assembly && !entity.unloaded && (solid ? !entity.mesh : !entity.robot)) {
      return makeError(refusal(inQuotes(entity.name), "nothing in it", solid ? "a mesh" : "a robot"));
    }
    if (auto checked = checkPose(inQuotes(entity.name), entity.X_WE); !checked) return checked;
    if (!entity.joints.empty()) {
      if (auto checked = checkJoints(entity, entity.joints); !checked) return checked;
    }
    if (auto checked = checkTools(entity); !checked) return checked;
    if (auto checked = checkAttachment(entity); !checked) return checked;
    if (auto checked = checkFrames(entity); !checked) return checked;
    return checkProperties(entity);
  }

  static Expected<void> checkJoints(const Entity& entity, const std::vector<double>& joints) {
    const std::size_t wanted = entity.robot ? entity.robot->dof() : 0;
    if (joints.size() != wanted) {
      return makeError(refusal(inQuotes(entity.name), std::to_string(joints.size()) + " joint values",
                               std::to_string(wanted) + ", one a moving joint"));
    }
    for (double value : joints) {
      if (!std::isfinite(value)) {
        return makeError(refusal(inQuotes(entity.name), "a joint value that is not finite", "a number"));
      }
    }
    return {};
  }

  static Expected<void> checkTool(const Entity& entity) {
    if (entity.robot && !entity.tip_link.empty() && entity.robot->findLink(entity.tip_link) < 0) {
      return makeError(refusal(inQuotes(entity.name), "no link " + inQuotes(entity.tip_link),
                               "a link of robot " + inQuotes(entity.robot->name)));
    }
    return checkPose("the tool of " + inQuotes(entity.name), entity.X_LT);
  }

  static Expected<void> checkFrames(const Entity& entity) {
    std::vector<std::string> names;
    for (const Frame& frame : entity.frames) {
      const std::string place = inQuotes(entity.name) + ", frame " + inQuotes(frame.name);
      if (auto checked = checkName("a frame of " + inQuotes(entity.name), frame.name); !checked) return checked;
      if (auto checked = checkPose(place, frame.X_EF); !checked) return checked;
      if (std::find(names.begin(), names.end(), frame.name) != names.end()) return makeError(taken(frame.name));
      names.push_back(frame.name);
    }
    return {};
  }

  static Expected<void> checkProperties(const Entity& entity) {
    const bool color =
        std::all_of(entity.color.begin(), entity.color.end(), [](float part) { return part >= 0.0f && part <= 1.0f; });
    if (!color) return makeError(refusal(inQuotes(entity.name), "a colour out of range", "parts from 0 to 1"));
    if (!(entity.mass > 0.0) || !std::isfinite(entity.mass)) {
      return makeError(refusal(inQuotes(entity.name), "a mass that is none", "kilograms above 0"));
    }
    return {};
  }

  static Expected<void> checkPairSet(const PairSet& set) {
    if (auto checked = checkName("the pair set's name", set.name); !checked) return checked;
    constexpr double kFarthest = 1.0;
    for (double distance : {set.safety_distance, set.near_miss}) {
      if (!(distance >= 0.0 && distance <= kFarthest)) {
        return makeError(refusal("pair set " + inQuotes(set.name), "a distance out of range", "0 to 1 m"));
      }
    }
    return {};
  }

  DocumentState& state_;
  EntityId new_id_;
};

/// The verb of each command, and the entity or set it is about.
class Describer {
 public:
  explicit Describer(const DocumentState& state) : state_(state) {}

  std::string operator()(const AddEntity& c) const { return "Add " + c.entity.name; }
  std::string operator()(const RemoveEntity& c) const { return "Remove " + name(c.id); }
  std::string operator()(const RenameEntity& c) const { return "Rename " + name(c.id); }
  std::string operator()(const SetPlacement& c) const { return "Move " + name(c.id); }
  std::string operator()(const SetJoints& c) const { return "Move joints of " + name(c.id); }
  std::string operator()(const SetConfiguration& c) const { return "Move " + name(c.id); }
  std::string operator()(const SetFrames& c) const { return "Change frames of " + name(c.id); }
  std::string operator()(const SetTool& c) const { return "Change tool of " + name(c.id); }
  std::string operator()(const SetTools& c) const { return "Change tools of " + name(c.id); }
  std::string operator()(const ChooseTool& c) const { return "Take tool " + c.name + " of " + name(c.id); }
  std::string operator()(const Attach& c) const { return "Attach " + name(c.id) + " to " + name(c.to); }
  std::string operator()(const Detach& c) const { return "Release " + name(c.id); }
  std::string operator()(const MakeMechanism& c) const { return "Make mechanism " + c.name; }
  std::string operator()(const EditMechanism& c) const { return "Change joints of " + name(c.id); }
  std::string operator()(const DissolveMechanism& c) const { return "Take apart " + name(c.id); }
  std::string operator()(const AddGuide& c) const { return "Add guide " + c.guide.name; }
  std::string operator()(const EditGuide& c) const { return "Change guide " + c.name; }
  std::string operator()(const RemoveGuide& c) const { return "Remove guide " + c.name; }
  std::string operator()(const AddPairSet& c) const { return "Add pair set " + c.set.name; }
  std::string operator()(const EditPairSet& c) const { return "Change pair set " + c.name; }
  std::string operator()(const RemovePairSet& c) const { return "Remove pair set " + c.name; }
  std::string operator()(const SetView&) const { return "Change view"; }
  std::string operator()(const SetProperties& c) const {
    if (c.visible) return (*c.visible ? "Show " : "Hide ") + name(c.id);
    if (c.locked) return (*c.locked ? "Lock " : "Unlock ") + name(c.id);
    return "Change " + name(c.id);
  }

 private:
  std::string name(EntityId id) const {
    const Entity* entity = state_.find(id);
    return entity ? entity->name : "entity";
  }

  const DocumentState& state_;
};

}  // namespace

Pose carrierPose(const Entity& carrier, const std::string& link) {
  const int index = carrier.robot && !link.empty() ? carrier.robot->findLink(link) : -1;
  if (index < 0) return carrier.X_WE;
  std::vector<Pose> X_EL;
  const bool known = carrier.joints.size() == carrier.robot->dof();
  kinematics::forwardKinematics(*carrier.robot, known ? carrier.joints : kinematics::restPositions(*carrier.robot),
                                X_EL);
  return carrier.X_WE * X_EL[static_cast<std::size_t>(index)];
}

Expected<EntityId> apply(const Command& command, DocumentState& state, EntityId new_id) {
  return std::visit(Applier(state, new_id), command);
}

std::string commandText(const Command& command, const DocumentState& state) {
  return std::visit(Describer(state), command);
}

std::vector<EntityId> familyOf(const DocumentState& state, EntityId id) {
  const Entity* root = state.find(id);
  std::vector<EntityId> family;
  if (!root) return family;
  std::vector<const Entity*> open{root};
  while (!open.empty()) {
    const Entity* parent = open.back();
    open.pop_back();
    family.push_back(parent->id);
    for (const auto& entity : state.entities) {
      const bool known = std::find(family.begin(), family.end(), entity->id) != family.end();
      if (entity->parent == parent->name && !known) open.push_back(entity.get());
    }
  }
  return family;
}

const Entity* DocumentState::find(EntityId id) const {
  for (const auto& entity : entities) {
    if (entity->id == id) return entity.get();
  }
  return nullptr;
}

const Entity* DocumentState::findByName(std::string_view name) const {
  for (const auto& entity : entities) {
    if (entity->name == name) return entity.get();
  }
  return nullptr;
}

const Guide* DocumentState::findGuide(std::string_view name) const {
  for (const Guide& guide : guides) {
    if (guide.name == name) return &guide;
  }
  return nullptr;
}

const PairSet* DocumentState::findPairSet(std::string_view name) const {
  for (const PairSet& set : pair_sets) {
    if (set.name == name) return &set;
  }
  return nullptr;
}

}  // namespace hapticell::workcell
