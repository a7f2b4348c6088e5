// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/cell_change.h"

#include <algorithm>
#include <cmath>

namespace hapticell::studies {

using workcell::DocumentState;
using workcell::Entity;

namespace {

/// m and rad, or m, of joints: what rounding leaves after some products of poses. Half and twice: as well.
constexpr double kSame = 1e-9;

bool samePose(const Pose& a, const Pose& b) {
  return glm::length(a.p - b.p) < kSame && std::abs(std::abs(glm::dot(a.q, b.q)) - 1.0) < kSame;
}

bool sameShape(const Entity& a, const Entity& b) {
  return a.source.path == b.source.path && a.mesh() == b.mesh() && a.robot() == b.robot() && a.figure() == b.figure();
}

bool sameJoints(const Entity& a, const Entity& b) {
  return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                    [](double one, double other) { return std::abs(one - other) < kSame; });
}

bool sameTool(const Entity& a, const Entity& b) {
  return a.jointed().tip_link == b.jointed().tip_link && a.jointed().tool == b.jointed().tool &&
         samePose(a.jointed().X_LT, b.jointed().X_LT);
}

bool sameAttachment(const Entity& a, const Entity& b) {
  return a.attachment.to == b.attachment.to && a.attachment.link == b.attachment.link;
}

bool isSame(const Entity& a, const Entity& b) {
  return sameShape(a, b) && samePose(a.X_WE, b.X_WE) && sameJoints(a, b) && sameTool(a, b) && sameAttachment(a, b);
}

/// Of how many others it hangs: carriers move what they carry, so they go first.
std::size_t carriersAbove(const DocumentState& state, const Entity& entity) {
  std::size_t count = 0;
  for (const Entity* at = &entity; at != nullptr && count <= state.entities.size(); ++count)
    at = state.findByName(!at->attachment.to.empty() ? at->attachment.to : at->parent);
  return count;
}

/// Commands gathered, each tried on a copy at once.
class Trial {
 public:
  explicit Trial(const DocumentState& present) : state_(present) {}

  const DocumentState& state() const { return state_; }
  const std::vector<workcell::Command>& commands() const { return commands_; }
  Expected<void> add(workcell::Command command) {
    HAPTICELL_TRY(workcell::apply(command, state_, 0));
    commands_.push_back(std::move(command));
    return {};
  }
  Expected<void> lock(workcell::EntityId id, bool locked) {
    workcell::SetProperties properties;
    properties.id = id;
    properties.locked = locked;
    return add(properties);
  }

 private:
  DocumentState state_;
  std::vector<workcell::Command> commands_;
};

Expected<void> changeShapeAndTool(const Entity& wanted, workcell::EntityId id, Trial& trial) {
  if (!sameShape(*trial.state().find(id), wanted)) {
    HAPTICELL_TRY(trial.add(workcell::ReplaceShape{id, wanted}));
  }
  const Entity& now = *trial.state().find(id);
  if (!sameJoints(now, wanted)) {
    HAPTICELL_TRY(trial.add(workcell::SetJoints{id, wanted.joints()}));
  }
  if (wanted.robot() == nullptr || wanted.figure() != nullptr || sameTool(*trial.state().find(id), wanted)) return {};
  const workcell::Jointed& tool = wanted.jointed();
  if (!tool.tool.empty()) return trial.add(workcell::ChooseTool{id, tool.tool});
  return trial.add(workcell::SetTool{id, tool.tip_link, tool.X_LT});
}

Expected<void> hang(const Entity& wanted, workcell::EntityId id, Trial& trial) {
  const Entity& now = *trial.state().find(id);
  if (sameAttachment(now, wanted)) return {};
  if (!now.attachment.to.empty()) {
    HAPTICELL_TRY(trial.add(workcell::Detach{id}));
  }
  const Entity* carrier = trial.state().findByName(wanted.attachment.to);
  if (carrier == nullptr) return {};
  return trial.add(workcell::Attach{id, carrier->id, wanted.attachment.link});
}

}  // namespace

std::vector<const Entity*> changedEntities(const workcell::Document& given, const workcell::Document& variant) {
  std::vector<const Entity*> changed;
  for (const auto& entity : variant.state().entities) {
    const Entity* before = given.findByName(entity->name);
    if (before == nullptr || (before != entity.get() && !isSame(*before, *entity))) changed.push_back(entity.get());
  }
  return changed;
}

Expected<std::vector<workcell::Command>> commandsFor(const workcell::Document& given, const workcell::Document& variant,
                                                     const DocumentState& present) {
  std::vector<const Entity*> changed = changedEntities(given, variant);
  std::stable_sort(changed.begin(), changed.end(), [&](const Entity* a, const Entity* b) {
    return carriersAbove(variant.state(), *a) < carriersAbove(variant.state(), *b);
  });
  Trial trial(present);
  std::vector<workcell::EntityId> locked;
  for (const Entity* wanted : changed) {
    const Entity* own = present.findByName(wanted->name);
    if (own == nullptr || own->kind() != wanted->kind())
      return makeError({.place = Text("entity '%1'", wanted->name),
                        .found = own == nullptr ? Text("it is not in this cell") : Text("it is of another kind"),
                        .expected = "the cell of the study",
                        .fix = "Open the study's cell."});
    if (!own->locked) continue;
    locked.push_back(own->id);
    HAPTICELL_TRY(trial.lock(own->id, false));
  }
  const auto idOf = [&](const Entity* wanted) { return present.findByName(wanted->name)->id; };
  for (const Entity* wanted : changed) {
    HAPTICELL_TRY(changeShapeAndTool(*wanted, idOf(wanted), trial));
  }
  for (const Entity* wanted : changed) {
    const workcell::EntityId id = idOf(wanted);
    if (!samePose(trial.state().find(id)->X_WE, wanted->X_WE)) {
      HAPTICELL_TRY(trial.add(workcell::SetPlacement{id, wanted->X_WE}));
    }
    HAPTICELL_TRY(hang(*wanted, id, trial));
  }
  for (const workcell::EntityId id : locked) {
    HAPTICELL_TRY(trial.lock(id, true));
  }
  for (const Entity* wanted : changed) {
    if (isSame(*trial.state().find(idOf(wanted)), *wanted)) continue;
    return makeError({.place = Text("entity '%1'", wanted->name),
                      .found = "it would not be as in the variant",
                      .expected = "the variant's shape, place, joints and tool",
                      .fix = "Open the study's cell."});
  }
  return trial.commands();
}

}  // namespace hapticell::studies
