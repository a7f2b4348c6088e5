// SPDX-License-Identifier: Apache-2.0
// Commands on tools of robots and on what hangs on something.
#include <algorithm>

#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"

namespace hapticell::workcell {

namespace {

void takeChosenTool(Jointed& robot) {
  const auto chosen = std::find_if(robot.tools.begin(), robot.tools.end(),
                                   [&](const ToolFrame& tool) { return tool.name == robot.tool; });
  if (chosen == robot.tools.end()) {
    robot.tool.clear();
    return;
  }
  robot.tip_link = chosen->tip_link;
  robot.X_LT = chosen->X_LT;
}

}  // namespace

std::string tipOf(const Entity& robot) {
  if (!robot.jointed().tip_link.empty()) return robot.jointed().tip_link;
  const int tip = robot.robot()->defaultTip();
  return tip < 0 ? std::string{} : robot.robot()->links[static_cast<std::size_t>(tip)].name;
}

Expected<void> checkAttachment(const Entity& entity, const DocumentState& state) {
  if (entity.attachment.to.empty()) return {};
  const Entity* carrier = state.findByName(entity.attachment.to);
  const Text place("'%1', attached", entity.name);
  if (!carrier)
    return makeError({.place = place,
                      .found = Text("no entity is named '%1'", entity.attachment.to),
                      .expected = "one that exists in the document"});
  if (!entity.attachment.link.empty() &&
      (!carrier->robot() || carrier->robot()->findLink(entity.attachment.link) < 0)) {
    return makeError({.place = place,
                      .found = Text("no link is named '%1'", entity.attachment.link),
                      .expected = Text("a link of '%1'", carrier->name)});
  }
  return checkPose(place, entity.attachment.X_LE);
}

Expected<EntityId> perform(const SetTool& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  if (!changed.robot())
    return makeError(
        {.place = quotedName(changed.name), .found = "a solid", .expected = "a robot, which can have a tool"});
  changed.editJointed().tip_link = command.tip_link;
  changed.editJointed().X_LT = command.X_LT;
  changed.editJointed().tool.clear();
  HAPTICELL_TRY(checkTool(changed));
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const SetTools& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  if (!changed.robot())
    return makeError(
        {.place = quotedName(changed.name), .found = "a solid", .expected = "a robot, which can have tools"});
  changed.editJointed().tools = command.tools;
  takeChosenTool(changed.editJointed());
  HAPTICELL_TRY(checkTools(changed));
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const SetNamedPoses& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  if (!changed.robot() && !command.poses.empty())
    return makeError(
        {.place = quotedName(changed.name), .found = "a solid", .expected = "a robot, which can have named poses"});
  if (changed.robot()) changed.editJointed().named_poses = command.poses;
  HAPTICELL_TRY(checkNamedPoses(changed));
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const ChooseTool& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  Entity changed = **entity;
  if (changed.robot()) {
    changed.editJointed().tool = command.name;
    takeChosenTool(changed.editJointed());
  }
  if (changed.jointed().tool != command.name) {
    return makeError({.place = quotedName(changed.name),
                      .found = Text("no tool is named '%1'", command.name),
                      .expected = "the name of one of its tools"});
  }
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const Attach& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id), carrier = edit.existing(command.to);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(carrier);
  for (const Entity* at = *carrier; at; at = edit.state().findByName(at->attachment.to)) {
    if (at->id != command.id) continue;
    return makeError({.place = quotedName((*entity)->name),
                      .found = Text("'%1' is this entity or is attached to it", (*carrier)->name),
                      .expected = "another entity to attach it to"});
  }
  Attachment attachment{(*carrier)->name, command.link, {}};
  if ((*carrier)->robot() && attachment.link.empty()) attachment.link = tipOf(**carrier);
  Entity changed = **entity;
  changed.attachment = std::move(attachment);
  HAPTICELL_TRY(checkAttachment(changed, edit.state()));
  changed.attachment.X_LE = carrierPose(**carrier, changed.attachment.link).inverse() * changed.X_WE;
  return edit.change(command.id, [&](Entity& target) { target = changed; });
}

Expected<EntityId> perform(const Detach& command, StateEdit& edit) {
  const auto entity = edit.existing(command.id);
  HAPTICELL_TRY(entity);
  return edit.change(command.id, [](Entity& changed) { changed.attachment = {}; });
}

}  // namespace hapticell::workcell
