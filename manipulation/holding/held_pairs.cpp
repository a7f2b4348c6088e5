// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "manipulation/scene/mannequin_own_pairs.h"
#include "manipulation/scene/own_pairs.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;
using workcell::ForceClass;
using workcell::OnContact;

/// A contact that stops: it sticks whatever the push, as friction of 1000 is a cone of 0.06 deg. Half and twice as
/// well.
constexpr double kStickingFriction = 1e3;
/// m: nearer than this at rest the shapes are those of neighbours (convex hulls of links overlap or nearly). Half:
/// hulls that touch in motion block; twice: links 4 mm apart are not checked.
constexpr double kTouching = 2e-3;
/// Pairs named in the message. Half: one; twice: a long line.
constexpr std::size_t kMostNamed = 3;

/// Two touching materials: the softer, the better damped, the mean of friction.
void blend(const config::Configuration& configuration, const Entity& a, const Entity& b, PairFeel& feel) {
  const auto first = configuration.materials.find(a.contact.material),
             second = configuration.materials.find(b.contact.material);
  const config::Material none;
  const config::Material& m1 = first == configuration.materials.end() ? none : first->second;
  const config::Material& m2 = second == configuration.materials.end() ? none : second->second;
  feel.stiffness = std::min(m1.stiffness, m2.stiffness);
  feel.damping = std::max(m1.damping, m2.damping);
  feel.friction = std::sqrt(m1.friction * m2.friction);
}

Text noteOn(const std::string& robot, const std::vector<std::string>& touching) {
  std::string names;
  for (std::size_t i = 0; i < std::min(touching.size(), kMostNamed); ++i) names += (i == 0 ? "" : ", ") + touching[i];
  if (touching.size() <= kMostNamed)
    return Text("links of %1 that touch at rest are not checked against each other: %2", robot, names);
  return Text("links of %1 that touch at rest are not checked against each other: %2 and %3 more pairs", robot, names,
              static_cast<std::int64_t>(touching.size() - kMostNamed));
}

/// m from a foot to what it stands on, and of the sole over its lowest point: a heel sunk into a carpet. Half of either:
/// a figure put down by hand is stopped by its floor; twice: what lies beside a foot counts as the floor.
constexpr double kStandsOn = 2e-3, kSole = 0.02;

/// Whether a part of a figure is a foot whose sole is on the obstacle.
bool standsOn(const MovedPart& foot, const Pose& X_WF, const ScenePart& obstacle, const Pose& X_WO) {
  if (!foot.part->name.ends_with("foot")) return false;
  const auto& collider = foot.part->mesh.collider;
  const auto found = collision::distance(collider, X_WF, obstacle.mesh.collider, X_WO, 2.0 * kStandsOn);
  return found.distance < kStandsOn && found.p_WA.z < geometry::transformed(X_WF, collider->bounds()).min.z + kSole;
}

/// Where the moved parts are while the robot is at rest, its root at the origin.
std::vector<Pose> restPoses(const kinematics::RobotModel& robot, const std::vector<MovedPart>& parts) {
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(robot, kinematics::restPositions(robot), X_EL);
  std::vector<Pose> poses;
  for (const MovedPart& part : parts) {
    poses.push_back(X_EL[static_cast<std::size_t>(std::max(0, part.link))] * part.X_LP);
  }
  return poses;
}

}  // namespace

HeldPairs::HeldPairs(const HeldModel& model, const Manipulator& manipulator, const Placements& placements,
                     const HoldOptions& options, const config::Configuration& configuration) {
  gatherObstacles(model, manipulator, placements, options, configuration);
  first_own_ = static_cast<std::uint32_t>(pairs_.size());
  if (!configuration.robot.self_collision) return;
  gatherOwn(model, manipulator, options, configuration.manipulation.safety_distance);
}

void HeldPairs::add(const MotionPair& motion_pair, HeldPair pair) {
  motion_pairs_.push_back(motion_pair);
  feel_.push_back(pair.feel);
  pairs_.push_back(std::move(pair));
}

void HeldPairs::gatherObstacles(const HeldModel& model, const Manipulator& manipulator, const Placements& placements,
                                const HoldOptions& options, const config::Configuration& configuration) {
  const PreparedScene& scene = *model.scene();
  const std::vector<MovedPart>& moved = model.parts();
  std::map<workcell::EntityId, std::unordered_map<workcell::EntityId, workcell::EffectivePair>> rules_of;
  for (const MovedPart& part : moved) {
    const auto [rules, is_new] = rules_of.try_emplace(part.owner);
    if (!is_new) continue;
    for (const workcell::EffectivePair& pair : scene.pairsOf(part.owner, options.on_contact)) {
      rules->second.emplace(pair.other, pair);
    }
  }
  // The feet of a figure that is moved by a hand or its head stay (to 0.2 mm) on what they stand on: that is no contact
  // which could stop it.
  const bool stays = isOfBody(options.moved_by) && !std::holds_alternative<by::Whole>(options.moved_by);
  std::vector<Pose> X_WP(moved.size());
  if (stays) manipulator.partPoses(model.taken(), X_WP);
  for (const ScenePart& part : scene.parts()) {
    if (model.isMoved(part.entity)) continue;
    const Entity& other = *scene.find(part.entity);
    const EntityConfiguration stands = standingOf(other, placements);
    const Pose X_WO = PreparedScene::partPose(other, stands.X_WE, stands.joints, part.link);
    bool checked = false;
    for (std::uint32_t k = 0; k < moved.size(); ++k) {
      const auto& rules = rules_of[moved[k].owner];
      const auto found = rules.find(other.id);
      if (found == rules.end()) continue;
      const workcell::EffectivePair& rule = found->second;
      if (!scene.isChecked(*moved[k].part, part)) continue;
      if (stays && moved[k].owner == model.id() && standsOn(moved[k], X_WP[k], part, X_WO)) {
        left_out_note_ = Text("%1 stands on %2: these feet are not checked against it", model.form().name, other.name);
        continue;
      }
      const workcell::PairRule* own = scene.ruleFor(*moved[k].part, part);
      HeldPair pair{other.id,
                    moved[k].owner,
                    moved[k].part->name,
                    part.name,
                    rule.safety_distance,
                    rule.near_miss,
                    rule.on_contact,
                    {}};
      if (own && own->on_contact) pair.on_contact = *own->on_contact;
      pair.feel.felt = pair.on_contact != OnContact::kPass;
      const Entity& owner = moved[k].owner == model.id() ? model.form() : *scene.find(moved[k].owner);
      if (options.force_class != ForceClass::kConstant) blend(configuration, owner, other, pair.feel);
      if (pair.on_contact == OnContact::kStop) pair.feel.friction = kStickingFriction;
      add({k, static_cast<std::uint32_t>(obstacles_.size()), pair.feel.felt}, std::move(pair));
      checked = true;
    }
    if (!checked) continue;
    obstacles_.push_back({part.mesh.pieces.get(), X_WO, obstacles_.size() + 1, 0.0, part.mesh.surfaces.get()});
    obstacle_parts_.push_back(&part);
  }
}

/// What of a held robot or mannequin is checked against itself.
void HeldPairs::gatherOwn(const HeldModel& model, const Manipulator& manipulator, const HoldOptions& options,
                          double safety_distance) {
  const Entity& entity = model.form();
  const PreparedScene& scene = *model.scene();
  const std::vector<MovedPart>& moved = model.parts();
  const bool body = entity.kind() == workcell::EntityKind::kMannequin;
  if (!entity.robot() || !entity.checked || options.on_contact == OnContact::kPass) return;
  std::vector<OwnPart> parts;
  for (const MovedPart& part : moved) parts.push_back({std::max(0, part.link), !model.isMember(part.owner)});
  std::vector<Pose> X_EP = restPoses(*entity.robot(), moved);
  // A body has no rest in which all is apart: what overlaps as it is taken (an arm on the thigh) is left out instead.
  if (body) manipulator.partPoses(model.taken(), X_EP);
  // What a hand carries is checked as that hand is.
  const auto linkOf = [&](const MovedPart& part) -> const std::string& {
    return entity.robot()->links[static_cast<std::size_t>(std::max(0, part.link))].name;
  };
  std::vector<std::string> touching;
  for (OwnPair own : ownPairs(*entity.robot(), parts)) {
    // What is carried is told first: "gripper touches robot/link_5".
    if (parts[own.second].carried) std::swap(own.first, own.second);
    const MovedPart &first = moved[own.first], &second = moved[own.second];
    if (!scene.isChecked(*first.part, *second.part)) continue;
    const bool links = model.isMember(first.owner) && model.isMember(second.owner);
    if (body && !isOwnPairOfMannequin(linkOf(first), linkOf(second))) continue;
    const auto& a = first.part->mesh.collider;
    const auto& b = second.part->mesh.collider;
    // What lies between both hands touches the other one's fingers as it is taken.
    if ((links || body) &&
        collision::distance(a, X_EP[own.first], b, X_EP[own.second], 2.0 * kTouching).distance < kTouching) {
      if (!body) touching.push_back(first.part->name + " with " + second.part->name);
      continue;
    }
    HeldPair pair{second.owner,    first.owner, first.part->name,   second.part->name,
                  safety_distance, 0.0,         options.on_contact, {}};
    if (const workcell::PairRule* rule = scene.ruleFor(*first.part, *second.part); rule && rule->on_contact) {
      pair.on_contact = *rule->on_contact;
    }
    pair.feel.felt = pair.on_contact != OnContact::kPass;
    add({static_cast<std::uint32_t>(own.first), 0, pair.feel.felt, static_cast<int>(own.second)}, std::move(pair));
  }
  if (!touching.empty()) left_out_note_ = noteOn(entity.name, touching);
}

FreeMotion HeldPairs::motionCheck(const HeldModel& model) const {
  std::vector<std::shared_ptr<const collision::MeshCollider>> colliders;
  for (const MovedPart& part : model.parts()) colliders.push_back(part.part->mesh.collider);
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    obstacles.push_back({obstacle_parts_[i]->mesh.collider, obstacles_[i].X_W});
  }
  return {std::move(colliders), std::move(obstacles), motion_pairs_};
}

}  // namespace hapticell::manipulation
