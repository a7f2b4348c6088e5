// SPDX-License-Identifier: Apache-2.0
#include "app/panels/tree/tree_edits.h"

#include <QObject>
#include <algorithm>
#include <functional>
#include <unordered_set>

#include "workcell/import/imported_entities.h"

namespace hapticell::app {
namespace {

using workcell::DocumentState;
using workcell::Entity;
using workcell::EntityId;
using workcell::SetProperties;

QString nameOf(const DocumentState& state, const Entities& ids) {
  const Entity* first = ids.empty() ? nullptr : state.find(ids.front());
  if (!first) return {};
  const QString name = QString::fromStdString(first->name);
  return ids.size() == 1 ? name : QObject::tr("%1 and %2 more").arg(name).arg(ids.size() - 1);
}

/// Those that do not stand below another of them.
Entities topmost(const DocumentState& state, const Entities& ids) {
  std::unordered_set<EntityId> below;
  for (const EntityId id : ids) {
    const auto family = workcell::familyOf(state, id);
    for (const EntityId member : family)
      if (member != id) below.insert(member);
  }
  Entities top;
  for (const EntityId id : ids)
    if (state.find(id) && !below.contains(id)) top.push_back(id);
  return top;
}

/// Sets properties of all below; an assembly hands them down itself.
bool setAll(DocumentModel& document, const QString& verb, const Entities& ids, const SetProperties& change) {
  const DocumentState& state = document.document().state();
  std::vector<workcell::Command> commands;
  std::unordered_set<EntityId> done;
  for (const EntityId id : withBelow(state, ids)) {
    if (done.contains(id)) continue;
    SetProperties one = change;
    one.id = id;
    commands.emplace_back(one);
    if (state.find(id)->kind() != workcell::EntityKind::kAssembly) continue;
    for (const EntityId member : workcell::familyOf(state, id)) done.insert(member);
  }
  if (commands.empty()) return false;
  return document.executeAll(verb.arg(nameOf(state, topmost(state, ids))), commands);
}

/// Shows exactly those for which `wanted` says so.
bool showExactly(DocumentModel& document, const QString& text, const std::function<bool(const Entity&)>& wanted) {
  const DocumentState& state = document.document().state();
  Entities all;
  for (const auto& entity : state.entities) all.push_back(entity->id);
  std::vector<workcell::Command> commands;
  const bool any = std::any_of(state.entities.begin(), state.entities.end(),
                               [&](const auto& entity) { return entity->visible != wanted(*entity); });
  if (!any) return false;
  for (const EntityId id : withBelow(state, all)) {  // Parents first: an assembly's word is followed by its parts' own.
    SetProperties one;
    one.id = id;
    one.visible = wanted(*state.find(id));
    commands.emplace_back(one);
  }
  return document.executeAll(text, commands);
}

Entities addCopies(DocumentModel& document, const QString& text, std::vector<Entity> copies,
                   const std::optional<dvec3>& p_W) {
  if (copies.empty()) return {};
  geometry::Bounds bounds_W;
  for (const Entity& copy : copies)
    if (copy.mesh()) bounds_W.add(geometry::transformed(copy.X_WE, copy.mesh()->bounds()));
  // m that a copy without shape is put beside; robots are about as wide. Half: it overlaps; twice: it is out of sight.
  constexpr double kOtherwise = 0.5;
  dvec3 by{bounds_W.isEmpty() ? kOtherwise : 1.1 * bounds_W.size().x, 0.0, 0.0};
  if (p_W) {
    const dvec3 now = bounds_W.isEmpty() ? copies.front().X_WE.p : bounds_W.center();
    by = {p_W->x - now.x, p_W->y - now.y, 0.0};
  }
  document.beginStep(text);
  const auto added = document.addImported(std::move(copies), Pose::translation(by));
  document.endStep();
  return added ? *added : Entities{};
}

}  // namespace

Entities withBelow(const DocumentState& state, const Entities& ids) {
  Entities result;
  std::unordered_set<EntityId> known;
  for (const EntityId id : topmost(state, ids))
    for (const EntityId member : workcell::familyOf(state, id))
      if (known.insert(member).second) result.push_back(member);
  return result;
}

bool showEntities(DocumentModel& document, const Entities& ids, bool shown) {
  SetProperties change;
  change.visible = shown;
  return setAll(document, shown ? QObject::tr("Show %1") : QObject::tr("Hide %1"), ids, change);
}

bool lockEntities(DocumentModel& document, const Entities& ids, bool locked) {
  SetProperties change;
  change.locked = locked;
  return setAll(document, locked ? QObject::tr("Lock %1") : QObject::tr("Unlock %1"), ids, change);
}

bool checkEntities(DocumentModel& document, const Entities& ids, bool checked) {
  SetProperties change;
  change.checked = checked;
  return setAll(document,
                checked ? QObject::tr("Check %1 for collision") : QObject::tr("Do not check %1 for collision"), ids,
                change);
}

bool colorEntities(DocumentModel& document, const Entities& ids, const std::array<float, 3>& color) {
  SetProperties change;
  change.color = color;
  return setAll(document, QObject::tr("Colour %1"), ids, change);
}

bool isolateEntities(DocumentModel& document, const Entities& ids) {
  const DocumentState& state = document.document().state();
  const Entities family = withBelow(state, ids);
  std::unordered_set<EntityId> shown(family.begin(), family.end());
  for (const EntityId id : ids) {  // What they stand below is not drawn itself, but its eye should be open.
    const Entity* at = state.find(id);
    while (at && (at = state.findByName(at->parent)) && at->kind() == workcell::EntityKind::kAssembly)
      if (!shown.insert(at->id).second) break;
  }
  return showExactly(document, QObject::tr("Isolate %1").arg(nameOf(state, ids)),
                     [&](const Entity& entity) { return shown.contains(entity.id); });
}

bool showAll(DocumentModel& document) {
  return showExactly(document, QObject::tr("Show all"), [](const Entity&) { return true; });
}

bool removeEntities(DocumentModel& document, const Entities& ids) {
  const DocumentState& state = document.document().state();
  const Entities top = topmost(state, ids);
  std::vector<workcell::Command> commands;
  for (const EntityId id : top) commands.emplace_back(workcell::RemoveEntity{id});
  return !commands.empty() && document.executeAll(QObject::tr("Remove %1").arg(nameOf(state, top)), commands);
}

std::vector<Entity> copiesOf(const DocumentState& state, const Entities& ids) {
  std::vector<Entity> copies;
  for (const EntityId id : withBelow(state, ids)) {
    copies.push_back(*state.find(id));
    copies.back().attachment = {};
  }
  return copies;
}

Entities pasteEntities(DocumentModel& document, std::vector<Entity> copies, const std::optional<dvec3>& p_W) {
  if (copies.empty()) return {};
  const QString text = QObject::tr("Paste %1").arg(QString::fromStdString(copies.front().name));
  return addCopies(document, text, std::move(copies), p_W);
}

Entities duplicateEntities(DocumentModel& document, const Entities& ids) {
  const DocumentState& state = document.document().state();
  const QString text = QObject::tr("Duplicate %1").arg(nameOf(state, topmost(state, ids)));
  return addCopies(document, text, copiesOf(state, ids), std::nullopt);
}

bool attachEntities(DocumentModel& document, const Entities& ids, EntityId to) {
  const DocumentState& state = document.document().state();
  const Entity* carrier = state.find(to);
  if (!carrier) return false;
  std::vector<workcell::Command> commands;
  for (const EntityId id : topmost(state, ids))
    if (id != to) commands.emplace_back(workcell::Attach{id, to, {}});
  const QString text =
      QObject::tr("Attach %1 to %2").arg(nameOf(state, topmost(state, ids)), QString::fromStdString(carrier->name));
  return !commands.empty() && document.executeAll(text, commands);
}

bool detachEntities(DocumentModel& document, const Entities& ids) {
  const DocumentState& state = document.document().state();
  std::vector<workcell::Command> commands;
  for (const EntityId id : ids)
    if (const Entity* entity = state.find(id); entity && !entity->attachment.to.empty())
      commands.emplace_back(workcell::Detach{id});
  return !commands.empty() && document.executeAll(QObject::tr("Detach %1").arg(nameOf(state, ids)), commands);
}

bool renameOwnFrame(DocumentModel& document, EntityId entity, const QString& frame, const QString& name) {
  const Entity* now = document.document().find(entity);
  if (!now) return false;
  workcell::SetFrames change{entity, now->frames};
  for (workcell::Frame& one : change.frames)
    if (one.name == frame.toStdString()) one.name = name.toStdString();
  return document.execute(change);
}

bool removeOwnFrame(DocumentModel& document, EntityId entity, const QString& frame) {
  const Entity* now = document.document().find(entity);
  if (!now) return false;
  workcell::SetFrames change{entity, now->frames};
  std::erase_if(change.frames, [&](const workcell::Frame& one) { return one.name == frame.toStdString(); });
  return document.execute(change);
}

bool moveBelow(DocumentModel& document, const Entities& ids, const QString& parent) {
  const DocumentState& state = document.document().state();
  std::vector<workcell::Command> commands;
  for (const EntityId id : topmost(state, ids)) {
    if (state.find(id)->parent == parent.toStdString()) continue;
    SetProperties change;
    change.id = id;
    change.parent = parent.toStdString();
    commands.emplace_back(change);
  }
  if (commands.empty()) return false;
  const QString where = parent.isEmpty() ? QObject::tr("the top level") : parent;
  return document.executeAll(QObject::tr("Move %1 below %2").arg(nameOf(state, ids), where), commands);
}

}  // namespace hapticell::app
