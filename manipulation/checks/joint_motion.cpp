// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "kinematics/model/jog.h"

namespace hapticell::manipulation {

namespace {

constexpr double kJointTouching = 1e-6;  ///< m

Error jointRefusal(const std::string& place, std::string found, std::string expected) {
  return {.file = {}, .place = place, .found = std::move(found), .expected = std::move(expected), .fix = {}};
}

Expected<const workcell::Entity*> robotOf(const PreparedScene& scene, workcell::EntityId id,
                                          const std::vector<double>& joints) {
  const workcell::Entity* entity = scene.find(id);
  if (entity == nullptr) return makeError(jointRefusal({}, "there is no such entity", "one of the document"));
  const std::string place = "entity '" + entity->name + "'";
  if (!entity->robot) return makeError(jointRefusal(place, "it has no joints", "a robot or a mechanism"));
  if (joints.size() != entity->robot->dof()) {
    return makeError(jointRefusal(place, std::to_string(joints.size()) + " joint positions",
                                  std::to_string(entity->robot->dof()) + " of them"));
  }
  if (!std::all_of(joints.begin(), joints.end(), [](double q) { return std::isfinite(q); }))
    return makeError(jointRefusal(place, "a joint position that is no number", "finite numbers"));
  return entity;
}

Expected<void> checkLimits(const workcell::Entity& entity, const std::vector<double>& joints) {
  constexpr double kSlack = 1e-9;
  const kinematics::RobotModel& model = *entity.robot;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    const double over = std::max(joints[i] - joint.upper, joint.lower - joints[i]);
    if (over <= kSlack) continue;
    const bool slides = joint.type == kinematics::JointType::kPrismatic;
    char text[160];
    std::snprintf(text, sizeof text, "%.100s would be %.1f %s %s limit", joint.name.c_str(),
                  over * (slides ? 1000.0 : 180.0 / std::numbers::pi), slides ? "mm" : "deg",
                  joints[i] > joint.upper ? "over its upper" : "under its lower");
    return makeError(jointRefusal("entity '" + entity.name + "'", text, "a position within the joint's limits"));
  }
  return {};
}

Expected<std::unique_ptr<HeldEntity>> takeAt(std::shared_ptr<const PreparedScene> scene, const workcell::Entity& entity,
                                             const std::vector<double>& joints,
                                             const config::Configuration& configuration) {
  const Placements placements{{entity.id, {entity.X_WE, joints}}};
  return HeldEntity::take(std::move(scene), entity.id, placements, {{}, entity.on_contact, entity.force_class},
                          configuration);
}

std::string meeting(const PreparedScene& scene, const workcell::Entity& entity, const HeldPair& pair) {
  const std::string moved = pair.moved_part.empty() ? entity.name : pair.moved_part;
  const workcell::Entity* other = scene.find(pair.other);
  std::string what = other ? other->name : "something";
  if (pair.other == entity.id) what = "its own " + pair.other_part;
  return moved + " would touch " + what;
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
  auto held = takeAt(scene, **entity, (*entity)->joints, configuration);
  HAPTICELL_TRY(held);
  const HeldEntity::WayResult way = (*held)->goTo({(*entity)->X_WE, joints});
  JointMotion motion;
  motion.joints = (*held)->accepted().joints;
  motion.share = way.share;
  motion.complete = !way.blocked;
  motion.time_s = timeFor(*(*entity)->robot, (*entity)->joints, joints);
  if (way.blocked) {
    const HeldPair& pair = (*held)->pairs()[way.pair];
    if (const workcell::Entity* other = scene->find(pair.other)) motion.obstacle = other->name;
    char text[64];
    std::snprintf(text, sizeof text, " after %.0f %% of the way", 100.0 * way.share);
    motion.reason = meeting(*scene, **entity, pair) + text;
  }
  motion.command = {id, motion.joints};
  return motion;
}

Expected<std::string> collisionAt(std::shared_ptr<const PreparedScene> scene, workcell::EntityId id,
                                  const std::vector<double>& joints, const config::Configuration& configuration) {
  const auto entity = robotOf(*scene, id, joints);
  HAPTICELL_TRY(entity);
  auto now = takeAt(scene, **entity, (*entity)->joints, configuration);
  HAPTICELL_TRY(now);
  auto then = takeAt(scene, **entity, joints, configuration);
  HAPTICELL_TRY(then);
  const std::set<std::uint32_t> already = touching(**now);
  for (const std::uint32_t pair : touching(**then)) {
    if (already.count(pair) == 0) return meeting(*scene, **entity, (*then)->pairs()[pair]);
  }
  return std::string{};
}

}  // namespace hapticell::manipulation
