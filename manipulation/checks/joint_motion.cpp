// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "kinematics/model/jog.h"

namespace hapticell::manipulation {

namespace {

// m: pairs that meet where the motion begins do not stop it, kLeastClearance of the check. Half: rounding decides;
// twice: a pair 2 um apart may be entered from there.
constexpr double kJointTouching = 1e-6;

Error jointRefusal(Text place, Text found, Text expected) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

Expected<const workcell::Entity*> robotOf(const PreparedScene& scene, workcell::EntityId id,
                                          const std::vector<double>& joints) {
  const workcell::Entity* entity = scene.find(id);
  if (entity == nullptr)
    return makeError(jointRefusal({}, Text("the entity does not exist"), Text("one that exists in the document")));
  const Text place("entity '%1'", entity->name);
  if (!entity->robot()) return makeError(jointRefusal(place, Text("it has no joints"), Text("a robot or a mechanism")));
  if (joints.size() != entity->robot()->dof()) {
    return makeError(jointRefusal(place, Text("%1 joint positions", joints.size()),
                                  Text("%1 joint positions", entity->robot()->dof())));
  }
  if (!std::all_of(joints.begin(), joints.end(), [](double q) { return std::isfinite(q); }))
    return makeError(jointRefusal(place, Text("a joint position that is not a number"), Text("finite numbers")));
  return entity;
}

Expected<void> checkLimits(const workcell::Entity& entity, const std::vector<double>& joints) {
  /// rad or m beyond a limit that typed numbers may be by rounding (nine digits). Half and twice are far below what a
  /// joint can do.
  constexpr double kSlack = 1e-9;
  const kinematics::RobotModel& model = *entity.robot();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    const double over = std::max(joints[i] - joint.upper, joint.lower - joints[i]);
    if (over <= kSlack) continue;
    return makeError(jointRefusal(Text("entity '%1'", entity.name),
                                  kinematics::beyondLimitText(joint, over, joints[i] > joint.upper),
                                  Text("a position within the joint's limits")));
  }
  return {};
}

Expected<std::unique_ptr<HeldEntity>> takeAt(std::shared_ptr<const PreparedScene> scene, const workcell::Entity& entity,
                                             const std::vector<double>& joints,
                                             const config::Configuration& configuration) {
  const Placements placements{{entity.id, {entity.X_WE, joints}}};
  return HeldEntity::take(std::move(scene), entity.id, placements,
                          {{}, entity.contact.on_contact, entity.contact.force_class}, configuration);
}

/// What would meet what.
struct Meeting {
  std::string moved, met;
  bool own = false;
};
Meeting meetingOf(const PreparedScene& scene, const workcell::Entity& entity, const HeldPair& pair) {
  const std::string moved = pair.moved_part.empty() ? entity.name : pair.moved_part;
  if (pair.other == entity.id) return {moved, pair.other_part, true};
  const workcell::Entity* other = scene.find(pair.other);
  return {moved, other != nullptr ? other->name : "?"};
}

double timeFor(const kinematics::RobotModel& model, const std::vector<double>& from, const std::vector<double>& to) {
  double time = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    time = std::max(time, std::abs(to[i] - from[i]) / kinematics::greatestSpeed(joint));
  }
  return time;
}

/// The pairs that meet where it is held now.
std::set<std::uint32_t> touching(HeldEntity& held) {
  std::vector<FreeMotion::PairDistance> near;
  held.distances(kJointTouching, near);
  std::set<std::uint32_t> pairs;
  for (const auto& one : near) {
    if (held.pairs()[one.pair].on_contact != workcell::OnContact::kPass) pairs.insert(one.pair);
  }
  return pairs;
}

}  // namespace

Expected<JointMotion> checkJointMotion(std::shared_ptr<const PreparedScene> scene, workcell::EntityId id,
                                       const std::vector<double>& joints, const config::Configuration& configuration) {
  const auto entity = robotOf(*scene, id, joints);
  HAPTICELL_TRY(entity);
  HAPTICELL_TRY(checkLimits(**entity, joints));
  auto held = takeAt(scene, **entity, (*entity)->joints(), configuration);
  HAPTICELL_TRY(held);
  const HeldEntity::WayResult way = (*held)->goTo({(*entity)->X_WE, joints});
  JointMotion motion;
  motion.joints = (*held)->accepted().joints;
  motion.share = way.share;
  motion.complete = !way.blocked;
  motion.time_s = timeFor(*(*entity)->robot(), (*entity)->joints(), joints);
  if (way.blocked) {
    const HeldPair& pair = (*held)->pairs()[way.pair];
    if (const workcell::Entity* other = scene->find(pair.other)) motion.obstacle = other->name;
    const Meeting meeting = meetingOf(*scene, **entity, pair);
    const auto percent = static_cast<std::int64_t>(std::nearbyint(100.0 * way.share));
    motion.reason = meeting.own
                        ? Text("%1 would touch its own %2 after %3 % of the way", meeting.moved, meeting.met, percent)
                        : Text("%1 would touch %2 after %3 % of the way", meeting.moved, meeting.met, percent);
  }
  motion.command = {id, motion.joints};
  return motion;
}

Expected<Text> collisionAt(std::shared_ptr<const PreparedScene> scene, workcell::EntityId id,
                           const std::vector<double>& joints, const config::Configuration& configuration) {
  const auto entity = robotOf(*scene, id, joints);
  HAPTICELL_TRY(entity);
  auto now = takeAt(scene, **entity, (*entity)->joints(), configuration);
  HAPTICELL_TRY(now);
  auto then = takeAt(scene, **entity, joints, configuration);
  HAPTICELL_TRY(then);
  const std::set<std::uint32_t> already = touching(**now);
  for (const std::uint32_t pair : touching(**then)) {
    if (already.count(pair) != 0) continue;
    const Meeting meeting = meetingOf(*scene, **entity, (*then)->pairs()[pair]);
    return meeting.own ? Text("%1 would touch its own %2", meeting.moved, meeting.met)
                       : Text("%1 would touch %2", meeting.moved, meeting.met);
  }
  return Text();
}

}  // namespace hapticell::manipulation
