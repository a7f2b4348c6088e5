// SPDX-License-Identifier: Apache-2.0
// Commands on pair sets, guides, trajectories and the view.
#include <algorithm>

#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"
#include "workcell/entity/pair_policy.h"

namespace hapticell::workcell {

namespace {

Error unknownSet(const std::string& name) {
  return {.found = Text("no pair set is named '%1'", name), .expected = "an existing name"};
}

Error unknownGuide(const std::string& name) {
  return {.found = Text("no guide is named '%1'", name), .expected = "an existing name"};
}

std::vector<PairSet>::iterator findSet(DocumentState& state, const std::string& name) {
  return std::find_if(state.pair_sets.begin(), state.pair_sets.end(),
                      [&](const PairSet& set) { return set.name == name; });
}

std::vector<Guide>::iterator findGuide(DocumentState& state, const std::string& name) {
  return std::find_if(state.guides.begin(), state.guides.end(), [&](const Guide& guide) { return guide.name == name; });
}

Error unknownTrajectory(const std::string& name) {
  return {.found = Text("no trajectory is named '%1'", name), .expected = "an existing name"};
}

std::vector<TrajectoryReference>::iterator findTrajectory(DocumentState& state, const std::string& name) {
  return std::find_if(state.trajectories.begin(), state.trajectories.end(),
                      [&](const TrajectoryReference& one) { return one.name == name; });
}

Expected<void> checkBound(const Guide& guide, const DocumentState& state) {
  if (auto checked = checkName(Text("the guide's name"), guide.name); !checked) return checked;
  if (auto checked = checkGuide(guide); !checked) return checked;
  for (const std::string* name : {&guide.entity, &guide.surface}) {
    if (name->empty() || state.findByName(*name)) continue;
    return makeError({.place = Text("guide '%1'", guide.name),
                      .found = Text("no entity is named '%1'", *name),
                      .expected = "an existing name"});
  }
  return {};
}

}  // namespace

Expected<EntityId> perform(const AddPairSet& command, StateEdit& edit) {
  HAPTICELL_TRY(checkPairSet(command.set));
  if (edit.state().findPairSet(command.set.name)) return makeError(taken(command.set.name));
  edit.state().pair_sets.push_back(command.set);
  return EntityId{0};
}

Expected<EntityId> perform(const EditPairSet& command, StateEdit& edit) {
  const auto found = findSet(edit.state(), command.name);
  if (found == edit.state().pair_sets.end()) return makeError(unknownSet(command.name));
  HAPTICELL_TRY(checkPairSet(command.set));
  const PairSet* other = edit.state().findPairSet(command.set.name);
  if (other && other != &*found) return makeError(taken(command.set.name));
  *found = command.set;
  return EntityId{0};
}

Expected<EntityId> perform(const RemovePairSet& command, StateEdit& edit) {
  const auto found = findSet(edit.state(), command.name);
  if (found == edit.state().pair_sets.end()) return makeError(unknownSet(command.name));
  edit.state().pair_sets.erase(found);
  return EntityId{0};
}

Expected<EntityId> perform(const SetPairRules& command, StateEdit& edit) {
  for (const PairRule& rule : command.rules) HAPTICELL_TRY(checkPairRule(rule, edit.state()));
  for (const PairRule& rule : command.rules) {
    std::vector<PairRule>& rules = edit.state().pair_rules;
    std::erase_if(rules, [&](const PairRule& other) { return samePair(other, rule); });
    if (!rule.checked || rule.on_contact) rules.push_back(rule);
  }
  return EntityId{0};
}

Expected<EntityId> perform(const AddGuide& command, StateEdit& edit) {
  HAPTICELL_TRY(checkBound(command.guide, edit.state()));
  if (edit.state().findGuide(command.guide.name)) return makeError(taken(command.guide.name));
  edit.state().guides.push_back(command.guide);
  return EntityId{0};
}

Expected<EntityId> perform(const EditGuide& command, StateEdit& edit) {
  const auto found = findGuide(edit.state(), command.name);
  if (found == edit.state().guides.end()) return makeError(unknownGuide(command.name));
  HAPTICELL_TRY(checkBound(command.guide, edit.state()));
  const Guide* other = edit.state().findGuide(command.guide.name);
  if (other && other != &*found) return makeError(taken(command.guide.name));
  *found = command.guide;
  return EntityId{0};
}

Expected<EntityId> perform(const RemoveGuide& command, StateEdit& edit) {
  const auto found = findGuide(edit.state(), command.name);
  if (found == edit.state().guides.end()) return makeError(unknownGuide(command.name));
  edit.state().guides.erase(found);
  return EntityId{0};
}

Expected<EntityId> perform(const AddTrajectory& command, StateEdit& edit) {
  if (auto checked = checkName(Text("the trajectory's name"), command.trajectory.name); !checked) {
    return makeError(checked.error());
  }
  if (edit.state().findTrajectory(command.trajectory.name)) return makeError(taken(command.trajectory.name));
  edit.state().trajectories.push_back(command.trajectory);
  return EntityId{0};
}

Expected<EntityId> perform(const RenameTrajectory& command, StateEdit& edit) {
  const auto found = findTrajectory(edit.state(), command.name);
  if (found == edit.state().trajectories.end()) return makeError(unknownTrajectory(command.name));
  HAPTICELL_TRY(checkName(Text("the trajectory's name"), command.new_name));
  const TrajectoryReference* other = edit.state().findTrajectory(command.new_name);
  if (other && other != &*found) return makeError(taken(command.new_name));
  found->name = command.new_name;
  return EntityId{0};
}

Expected<EntityId> perform(const SetTrajectory& command, StateEdit& edit) {
  const auto found = findTrajectory(edit.state(), command.name);
  if (found == edit.state().trajectories.end()) return makeError(unknownTrajectory(command.name));
  const std::string& name = command.trajectory.name;
  HAPTICELL_TRY(checkName(Text("the trajectory's name"), name));
  const TrajectoryReference* other = edit.state().findTrajectory(name);
  if (other && other != &*found) return makeError(taken(name));
  *found = command.trajectory;
  return EntityId{0};
}

Expected<EntityId> perform(const RemoveTrajectory& command, StateEdit& edit) {
  const auto found = findTrajectory(edit.state(), command.name);
  if (found == edit.state().trajectories.end()) return makeError(unknownTrajectory(command.name));
  edit.state().trajectories.erase(found);
  return EntityId{0};
}

Expected<EntityId> perform(const SetWorkTask& command, StateEdit& edit) {
  HAPTICELL_TRY(checkName(Text("the task's name"), command.task.name));
  const Text place("task '%1'", command.task.name);
  if (auto checked = ergonomics::checkWorkTask(command.task); !checked) {
    return makeError({.place = place,
                      .found = Text("%1 %2", checked.error().place, checked.error().found),
                      .expected = checked.error().expected});
  }
  if (!command.task.mannequin.empty()) {
    const Entity* entity = edit.state().findByName(command.task.mannequin);
    if (!entity || entity->kind() != EntityKind::kMannequin)
      return makeError({.place = place,
                        .found = Text("no mannequin is named '%1'", command.task.mannequin),
                        .expected = "an existing name"});
  }
  auto& tasks = edit.state().work_tasks;
  const std::string& before = command.before.empty() ? command.task.name : command.before;
  const auto called = [&](const std::string& name) {
    return std::find_if(tasks.begin(), tasks.end(), [&](const auto& task) { return task.name == name; });
  };
  const auto found = called(before);
  if (found == tasks.end() && !command.before.empty())
    return makeError({.found = Text("no task is named '%1'", before), .expected = "an existing name"});
  if (before != command.task.name && called(command.task.name) != tasks.end())
    return makeError(taken(command.task.name));
  if (found == tasks.end()) {
    tasks.push_back(command.task);
  } else {
    *found = command.task;
  }
  return EntityId{0};
}

Expected<EntityId> perform(const RemoveWorkTask& command, StateEdit& edit) {
  const auto removed =
      std::erase_if(edit.state().work_tasks, [&](const auto& task) { return task.name == command.name; });
  if (removed == 0)
    return makeError({.found = Text("no task is named '%1'", command.name), .expected = "an existing name"});
  return EntityId{0};
}

Expected<EntityId> perform(const SetView& command, StateEdit& edit) {
  edit.state().view = command.view;
  return EntityId{0};
}

}  // namespace hapticell::workcell
