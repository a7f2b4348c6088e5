// SPDX-License-Identifier: Apache-2.0
#include "app/console/state_commands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "app/host/document_model.h"
#include "workcell/format/document_format.h"
#include "workcell/format/entity_format.h"
#include "workcell/format/guide_format.h"

namespace hapticell::app {

using workcell::DocumentState;
using workcell::Entity;
using workcell::EntityId;
using workcell::Json;

namespace {

constexpr const char* kFolder = "/";
/// m, rad and all else: what rounding leaves after some products of poses. Half and twice: as well.
constexpr double kSameNumber = 1e-9;

bool sameJson(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    return x == y || std::abs(x - y) <= kSameNumber * std::max(1.0, std::abs(x));
  }
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (a.is_array()) return std::equal(a.begin(), a.end(), b.begin(), sameJson);
  if (!a.is_object()) return a == b;
  return std::all_of(a.items().begin(), a.items().end(), [&b](const auto& item) {
    const auto found = b.find(item.key());
    return found != b.end() && sameJson(item.value(), *found);
  });
}

bool same(const Json& a, const Json& b, const char* key) {
  const auto x = a.find(key), y = b.find(key);
  if (x == a.end() || y == b.end()) return x == a.end() && y == b.end();
  return sameJson(*x, *y);
}

/// Of how many others it hangs: carriers move what they carry, so they go first.
std::size_t carriersAbove(const DocumentState& state, const Entity& entity) {
  std::size_t count = 0;
  for (const Entity* at = state.findByName(entity.attachment.to); at != nullptr && count < state.entities.size(); ++count)
    at = state.findByName(at->attachment.to);
  return count;
}

bool sameShape(const Entity& a, const Entity& b) {
  return a.kind() == b.kind() && a.mesh() == b.mesh() && a.robot() == b.robot() && (a.mesh() || a.robot());
}

/// Gathers commands; each is tried on a copy at once.
class Finder {
 public:
  Finder(const DocumentState& now, const DocumentState& wanted) : now_(now), wanted_(wanted), state_(now) {
    for (const auto& entity : now.entities) next_id_ = std::max(next_id_, entity->id + 1);
  }

  Expected<std::vector<workcell::Command>> run() {
    HAPTICELL_TRY(rename());
    HAPTICELL_TRY(unlock());
    HAPTICELL_TRY(remove());
    for (const auto& entity : wanted_.entities) HAPTICELL_TRY(addOrReshape(*entity));
    std::vector<const Entity*> changed;
    for (const auto& entity : wanted_.entities)
      if (differs(*entity)) changed.push_back(entity.get());
    std::stable_sort(changed.begin(), changed.end(), [this](const Entity* a, const Entity* b) {
      return carriersAbove(wanted_, *a) < carriersAbove(wanted_, *b);
    });
    for (const Entity* entity : changed) HAPTICELL_TRY(changeInside(*entity));
    for (const Entity* entity : changed) HAPTICELL_TRY(place(*entity));
    HAPTICELL_TRY(changeLists());
    for (const Entity* entity : changed) HAPTICELL_TRY(changeProperties(*entity));
    if (sameJson(workcell::jsonFromState(state_, kFolder), workcell::jsonFromState(wanted_, kFolder)))
      return std::move(commands_);
    return makeError({.place = "the cell",
                      .found = "a change that no commands of the window make",
                      .expected = "changes by the methods of the cell"});
  }

 private:
  Expected<void> add(workcell::Command command) {
    HAPTICELL_TRY(workcell::apply(command, state_, next_id_));
    if (std::holds_alternative<workcell::AddEntity>(command)) ++next_id_;
    commands_.push_back(std::move(command));
    return {};
  }
  EntityId idOf(const std::string& name) const { return state_.findByName(name)->id; }
  static Json textOf(const Entity& entity) { return workcell::jsonFromEntity(entity, kFolder); }
  bool differs(const Entity& wanted) const {
    const Entity* const own = state_.findByName(wanted.name);
    return own == nullptr || (own != &wanted && !sameJson(textOf(*own), textOf(wanted)));
  }

  Expected<void> rename() {
    std::vector<const Entity*> gone, fresh;
    for (const auto& entity : now_.entities)
      if (wanted_.findByName(entity->name) == nullptr) gone.push_back(entity.get());
    for (const auto& entity : wanted_.entities)
      if (now_.findByName(entity->name) == nullptr) fresh.push_back(entity.get());
    for (const Entity* old : gone) {
      const auto is_it = [old](const Entity* one) { return sameShape(*old, *one); };
      if (std::count_if(fresh.begin(), fresh.end(), is_it) != 1 || std::count_if(gone.begin(), gone.end(), is_it) != 1)
        continue;
      HAPTICELL_TRY(add(workcell::RenameEntity{old->id, (*std::find_if(fresh.begin(), fresh.end(), is_it))->name}));
    }
    return {};
  }

  /// What will be changed; its lock is among the properties that are set at the end.
  Expected<void> unlock() {
    const DocumentState before = state_;
    for (const auto& entity : before.entities) {
      const Entity* const wanted = wanted_.findByName(entity->name);
      if (!entity->locked || (wanted != nullptr && !differs(*wanted))) continue;
      workcell::SetProperties properties;
      properties.id = entity->id;
      properties.locked = false;
      HAPTICELL_TRY(add(properties));
    }
    return {};
  }

  Expected<void> remove() {
    const DocumentState before = state_;
    for (const auto& entity : before.entities) {
      // Removing takes those below along.
      if (wanted_.findByName(entity->name) != nullptr || state_.find(entity->id) == nullptr) continue;
      HAPTICELL_TRY(add(workcell::RemoveEntity{entity->id}));
    }
    return {};
  }

  Expected<void> addOrReshape(const Entity& wanted) {
    const Entity* const own = state_.findByName(wanted.name);
    if (own == nullptr) {
      Entity fresh = wanted;
      fresh.attachment = {};
      fresh.locked = false;
      return add(workcell::AddEntity{std::move(fresh)});
    }
    const Json a = textOf(*own), b = textOf(wanted);
    if (same(a, b, "source") && same(a, b, "mechanism")) return {};
    return add(workcell::ReplaceShape{own->id, wanted});
  }

  /// Joints, tool, frames and what it is checked by.
  Expected<void> changeInside(const Entity& wanted) {
    const EntityId id = idOf(wanted.name);
    const Json a = textOf(*state_.find(id)), b = textOf(wanted);
    if (!same(a, b, "frames")) HAPTICELL_TRY(add(workcell::SetFrames{id, wanted.frames}));
    if (!same(a, b, "proxy")) HAPTICELL_TRY(add(workcell::SetCollisionProxy{id, wanted.proxy()}));
    if (!wanted.robot()) return {};
    const workcell::Jointed& jointed = wanted.jointed();
    if (!same(a, b, "tools")) HAPTICELL_TRY(add(workcell::SetTools{id, jointed.tools}));
    if (!same(a, b, "poses")) HAPTICELL_TRY(add(workcell::SetNamedPoses{id, jointed.named_poses}));
    const Json now = textOf(*state_.find(id));
    if (!same(now, b, "chosen_tool") && !jointed.tool.empty()) {
      HAPTICELL_TRY(add(workcell::ChooseTool{id, jointed.tool}));
    } else if (!same(now, b, "tip_link") || !same(now, b, "tool") || !same(now, b, "chosen_tool")) {
      HAPTICELL_TRY(add(workcell::SetTool{id, jointed.tip_link, jointed.X_LT}));
    }
    if (same(a, b, "joints")) return {};
    return add(workcell::SetJoints{id, wanted.joints()});
  }

  /// Placement and what it hangs on; carriers were placed before.
  Expected<void> place(const Entity& wanted) {
    const EntityId id = idOf(wanted.name);
    const Json b = textOf(wanted);
    if (!same(textOf(*state_.find(id)), b, "placement")) HAPTICELL_TRY(add(workcell::SetPlacement{id, wanted.X_WE}));
    if (same(textOf(*state_.find(id)), b, "attached")) return {};
    if (!state_.find(id)->attachment.to.empty()) HAPTICELL_TRY(add(workcell::Detach{id}));
    const Entity* const carrier = state_.findByName(wanted.attachment.to);
    if (carrier == nullptr) return {};
    return add(workcell::Attach{id, carrier->id, wanted.attachment.link});
  }

  Expected<void> changeProperties(const Entity& wanted) {
    const EntityId id = idOf(wanted.name);
    const Json a = textOf(*state_.find(id)), b = textOf(wanted);
    workcell::SetProperties properties;
    properties.id = id;
    bool any = false;
    const auto set = [&](const char* key, auto& to, const auto& value) {
      if (same(a, b, key)) return;
      to = value;
      any = true;
    };
    set("color", properties.color, wanted.color);
    set("visible", properties.visible, wanted.visible);
    set("checked", properties.checked, wanted.checked);
    set("on_contact", properties.on_contact, wanted.contact.on_contact);
    set("force_class", properties.force_class, wanted.contact.force_class);
    set("material", properties.material, wanted.contact.material);
    set("mass", properties.mass, wanted.contact.mass);
    set("parent", properties.parent, wanted.parent);
    set("locked", properties.locked, wanted.locked);
    return any ? add(properties) : Expected<void>{};
  }

  /// Removes what is gone, changes what differs, adds what is new.
  template <class List, class Remove, class Edit, class Add, class Same>
  Expected<void> match(const List& now, const List& wanted, const Remove& remove, const Edit& edit, const Add& add_one,
                       const Same& is_same) {
    const auto named = [](const List& list, const std::string& name) {
      return std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
    };
    for (const auto& one : List(now))
      if (named(wanted, one.name) == wanted.end()) HAPTICELL_TRY(add(remove(one.name)));
    for (const auto& one : wanted) {
      const auto own = named(now, one.name);
      if (own == now.end()) {
        HAPTICELL_TRY(add(add_one(one)));
      } else if (!is_same(*own, one)) {
        HAPTICELL_TRY(add(edit(one)));
      }
    }
    return {};
  }

  Expected<void> changeLists() {
    using namespace workcell;  // NOLINT(google-build-using-namespace): one struct a kind of change.
    const auto equal = [](const auto& a, const auto& b) { return a == b; };
    HAPTICELL_TRY(match(
        state_.pair_sets, wanted_.pair_sets, [](const std::string& name) { return RemovePairSet{name}; },
        [](const PairSet& set) { return EditPairSet{set.name, set}; }, [](const PairSet& set) { return AddPairSet{set}; },
        equal));
    HAPTICELL_TRY(changeRules());
    HAPTICELL_TRY(match(
        state_.guides, wanted_.guides, [](const std::string& name) { return RemoveGuide{name}; },
        [](const Guide& guide) { return EditGuide{guide.name, guide}; }, [](const Guide& guide) { return AddGuide{guide}; },
        [](const Guide& a, const Guide& b) { return sameJson(jsonFromGuide(a), jsonFromGuide(b)); }));
    HAPTICELL_TRY(match(
        state_.work_tasks, wanted_.work_tasks, [](const std::string& name) { return RemoveWorkTask{name}; },
        [](const ergonomics::WorkTask& task) { return SetWorkTask{task}; },
        [](const ergonomics::WorkTask& task) { return SetWorkTask{task}; }, equal));
    return match(
        state_.trajectories, wanted_.trajectories, [](const std::string& name) { return RemoveTrajectory{name}; },
        [](const TrajectoryReference& one) {
          return SetTrajectory{one.name, one};
        },
        [](const TrajectoryReference& one) { return AddTrajectory{one}; },
        [](const TrajectoryReference& a, const TrajectoryReference& b) { return a.path == b.path; });
  }

  Expected<void> changeRules() {
    workcell::SetPairRules rules;
    for (const workcell::PairRule& rule : state_.pair_rules) {
      if (std::find(wanted_.pair_rules.begin(), wanted_.pair_rules.end(), rule) != wanted_.pair_rules.end()) continue;
      workcell::PairRule usual = rule;
      usual.checked = true;
      usual.on_contact.reset();
      rules.rules.push_back(usual);
    }
    for (const workcell::PairRule& rule : wanted_.pair_rules)
      if (std::find(state_.pair_rules.begin(), state_.pair_rules.end(), rule) == state_.pair_rules.end())
        rules.rules.push_back(rule);
    if (rules.rules.empty()) return {};
    return add(std::move(rules));
  }

  const DocumentState& now_;
  const DocumentState& wanted_;
  DocumentState state_;
  EntityId next_id_ = 1;
  std::vector<workcell::Command> commands_;
};

void renumber(workcell::Command& command, const std::map<EntityId, EntityId>& ids) {
  const auto change = [&ids](EntityId& id) {
    if (const auto found = ids.find(id); found != ids.end()) id = found->second;
  };
  std::visit(
      [&change](auto& kind) {
        if constexpr (requires { kind.id; }) change(kind.id);
        if constexpr (requires { kind.to; }) change(kind.to);
      },
      command);
}

}  // namespace

Expected<std::vector<workcell::Command>> commandsBetween(const DocumentState& now, const DocumentState& wanted) {
  return Finder(now, wanted).run();
}

Expected<void> executeCommands(DocumentModel& model, const QString& text, const std::vector<workcell::Command>& commands) {
  const auto is_add = [](const workcell::Command& one) { return std::holds_alternative<workcell::AddEntity>(one); };
  const auto last_add = std::find_if(commands.rbegin(), commands.rend(), is_add);
  const std::vector<workcell::Command> first(commands.begin(), last_add.base());
  std::vector<workcell::Command> rest(last_add.base(), commands.end());
  EntityId next = 1;
  for (const auto& entity : model.document().state().entities) next = std::max(next, entity->id + 1);
  model.endTrial();
  model.beginStep(text);
  bool done = first.empty() || model.executeWithin(first);
  std::map<EntityId, EntityId> ids;
  for (const workcell::Command& command : first) {
    if (!done || !is_add(command)) continue;
    const Entity* const added = model.document().findByName(std::get<workcell::AddEntity>(command).entity.name);
    ids[next++] = added == nullptr ? 0 : added->id;
  }
  for (workcell::Command& command : rest) renumber(command, ids);
  done = done && (rest.empty() || model.executeWithin(rest));
  if (done) {
    model.endStep();
    return {};
  }
  model.cancelStep();
  return makeError({.place = "the cell",
                    .found = "a change that no commands of the window make",
                    .expected = "changes by the methods of the cell"});
}

}  // namespace hapticell::app
