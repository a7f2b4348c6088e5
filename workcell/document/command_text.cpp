// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/command.h"

namespace hapticell::workcell {

namespace {

/// The verb of each command, and the entity or set it is about.
class Describer {
 public:
  explicit Describer(const DocumentState& state) : state_(state) {}

  std::string operator()(const AddEntity& c) const { return "Add " + c.entity.name; }
  std::string operator()(const RemoveEntity& c) const { return "Remove " + name(c.id); }
  std::string operator()(const RenameEntity& c) const { return "Rename " + name(c.id); }
  std::string operator()(const ReplaceShape& c) const { return "Read " + name(c.id) + " again"; }
  std::string operator()(const SetCollisionProxy& c) const { return "Change what is checked of " + name(c.id); }
  std::string operator()(const SetPlacement& c) const { return "Move " + name(c.id); }
  std::string operator()(const SetJoints& c) const { return "Move joints of " + name(c.id); }
  std::string operator()(const SetConfiguration& c) const { return "Move " + name(c.id); }
  std::string operator()(const SetFrames& c) const { return "Change frames of " + name(c.id); }
  std::string operator()(const SetTool& c) const { return "Change tool of " + name(c.id); }
  std::string operator()(const SetTools& c) const { return "Change tools of " + name(c.id); }
  std::string operator()(const SetNamedPoses& c) const { return "Change poses of " + name(c.id); }
  std::string operator()(const ChooseTool& c) const { return "Take tool " + c.name + " of " + name(c.id); }
  std::string operator()(const Attach& c) const { return "Attach " + name(c.id) + " to " + name(c.to); }
  std::string operator()(const Detach& c) const { return "Release " + name(c.id); }
  std::string operator()(const MakeMechanism& c) const { return "Make mechanism " + c.name; }
  std::string operator()(const EditMechanism& c) const { return "Change joints of " + name(c.id); }
  std::string operator()(const DissolveMechanism& c) const { return "Take apart " + name(c.id); }
  std::string operator()(const AddGuide& c) const { return "Add guide " + c.guide.name; }
  std::string operator()(const EditGuide& c) const { return "Change guide " + c.name; }
  std::string operator()(const RemoveGuide& c) const { return "Remove guide " + c.name; }
  std::string operator()(const AddTrajectory& c) const { return "Add trajectory " + c.trajectory.name; }
  std::string operator()(const RenameTrajectory& c) const { return "Rename trajectory " + c.name; }
  std::string operator()(const SetTrajectory& c) const { return "Edit trajectory " + c.name; }
  std::string operator()(const RemoveTrajectory& c) const { return "Remove trajectory " + c.name; }
  std::string operator()(const AddPairSet& c) const { return "Add pair set " + c.set.name; }
  std::string operator()(const EditPairSet& c) const { return "Change pair set " + c.name; }
  std::string operator()(const SetPairRules& c) const {
    if (!c.text.empty()) return c.text;
    if (c.rules.size() != 1) return "Change " + std::to_string(c.rules.size()) + " pairs";
    return "Change pair " + c.rules[0].first + " and " + c.rules[0].second;
  }
  std::string operator()(const RemovePairSet& c) const { return "Remove pair set " + c.name; }
  std::string operator()(const SetWorkTask& c) const { return "Change task " + c.task.name; }
  std::string operator()(const RemoveWorkTask& c) const { return "Remove task " + c.name; }
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

std::string commandText(const Command& command, const DocumentState& state) {
  return std::visit(Describer(state), command);
}

}  // namespace hapticell::workcell
