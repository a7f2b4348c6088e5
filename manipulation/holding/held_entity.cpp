// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_entity.h"

#include "manipulation/manipulators/manipulator_kinds.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;

bool goesAlongWithAxes(const MovedBy& moved_by) {
  const by::Tool* tool = toolOf(moved_by);
  return tool != nullptr && tool->with_axes;
}

Expected<std::unique_ptr<Manipulator>> manipulatorOf(const HeldModel& model, const HoldOptions& options,
                                                     const config::Configuration& configuration) {
  std::vector<Taking::Part> parts;
  for (const MovedPart& part : model.parts()) parts.push_back({part.link, part.X_LP});
  const Taking taking{model.form(),       model.taken(), resolved(options.moved_by, model.form()),
                      *model.scene(),     configuration, parts,
                      options.joints_move};
  return makeManipulator(taking, manipulatorKinds());
}

/// What of it and of its obstacles was written inside out, in one sentence.
void noteTurned(HeldState& state) {
  std::vector<std::string> names;
  const auto note = [&](const ScenePart& part) {
    if (part.mesh.bodies_turned > 0) names.push_back(state.model.nameOf(part));
  };
  for (const MovedPart& part : state.model.parts()) note(*part.part);
  for (const ScenePart* part : state.pairs.obstacleParts()) note(*part);
  if (names.empty()) return;
  const auto more = static_cast<std::int64_t>(names.size()) - 1;
  state.notes.push_back(
      more == 0 ? Text("%1: triangles face inward; they count as facing outward", names.front())
                : Text("%1 and %2 more: triangles face inward; they count as facing outward", names.front(), more));
}

}  // namespace

HeldEntity::HeldEntity(HeldState state) : state_(std::move(state)), constraints_(state_), way_(state_) {
  noteTurned(state_);
}

Expected<std::unique_ptr<HeldEntity>> HeldEntity::take(std::shared_ptr<const PreparedScene> scene,
                                                       workcell::EntityId entity, const Placements& placements,
                                                       const HoldOptions& options,
                                                       const config::Configuration& configuration) {
  const Entity* found = scene->find(entity);
  if (found == nullptr)
    return makeError({.found = "the entity does not exist", .expected = "one that exists in the document"});
  if (found->locked) return makeError(takingRefused(*found, Text("it is locked"), Text("an entity that can be moved")));
  std::vector<Text> notes;
  HeldModel model(std::move(scene), *found, placements, goesAlongWithAxes(options.moved_by), notes);
  auto manipulator = manipulatorOf(model, options, configuration);
  HAPTICELL_TRY(manipulator);
  HeldPairs pairs(model, **manipulator, placements, options, configuration);
  if (!pairs.leftOutNote().empty()) notes.push_back(pairs.leftOutNote());
  FreeMotion motion = pairs.motionCheck(model);
  motion.reset(**manipulator, model.taken());
  EntityConfiguration taken = model.taken();
  HeldState state{std::move(model), std::move(*manipulator), std::move(taken),
                  std::move(pairs), std::move(motion),       std::move(notes)};
  const auto* hand = std::get_if<by::Hand>(&options.moved_by);
  if (hand != nullptr && !hand->locks.any() && !hand->may_step) state.hand = hand->side;
  return std::unique_ptr<HeldEntity>(new HeldEntity(std::move(state)));
}

Pose HeldEntity::movedFrameWhen(const std::function<EntityConfiguration(workcell::EntityId)>& placed) const {
  const std::vector<const Entity*> members = state_.model.members();
  EntityConfiguration together = placed(members.front()->id);
  for (std::size_t k = 1; k < members.size(); ++k) {
    const EntityConfiguration one = placed(members[k]->id);
    together.joints.insert(together.joints.end(), one.joints.begin(), one.joints.end());
  }
  return state_.manipulator->movedFrame(together);
}

}  // namespace hapticell::manipulation
