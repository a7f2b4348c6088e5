// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_entity.h"

#include <algorithm>
#include <cmath>

#include "manipulation/manipulators/manipulator_kinds.h"
#include "workcell/entity/mechanism.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;
using workcell::ForceClass;
using workcell::OnContact;

constexpr double kStickingFriction = 1e3;  ///< A contact that stops: it sticks whatever the push.

Pose placementOf(const Entity& entity, const Placements& placements, std::vector<double>& joints) {
  const auto moved = placements.find(entity.id);
  joints = moved == placements.end() ? entity.joints : moved->second.joints;
  return moved == placements.end() ? entity.X_WE : moved->second.X_WE;
}

/// Two touching materials: the softer, the better damped, the mean of friction.
void blend(const config::Configuration& configuration, const Entity& a, const Entity& b, PairFeel& feel) {
  const auto first = configuration.materials.find(a.material), second = configuration.materials.find(b.material);
  const config::Material none;
  const config::Material& m1 = first == configuration.materials.end() ? none : first->second;
  const config::Material& m2 = second == configuration.materials.end() ? none : second->second;
  feel.stiffness = std::min(m1.stiffness, m2.stiffness);
  feel.damping = std::max(m1.damping, m2.damping);
  feel.friction = std::sqrt(m1.friction * m2.friction);
}

}  // namespace

Expected<std::unique_ptr<HeldEntity>> HeldEntity::take(std::shared_ptr<const PreparedScene> scene,
                                                       workcell::EntityId entity, const Placements& placements,
                                                       const HoldOptions& options,
                                                       const config::Configuration& configuration) {
  const Entity* found = scene->find(entity);
  if (found == nullptr)
    return makeError(
        {.file = {}, .place = {}, .found = "there is no such entity", .expected = "one of the document", .fix = {}});
  if (found->locked) return makeError(takingRefused(*found, "it is locked", "an entity that may be moved"));
  std::unique_ptr<HeldEntity> held(new HeldEntity);
  held->scene_ = std::move(scene);
  held->id_ = entity;
  held->form_ = *found;
  held->members_ = {{entity, 0, 0, 0}};
  held->accepted_.X_WE = placementOf(*found, placements, held->accepted_.joints);
  const MovedBy::Kind kind = options.moved_by.kind;
  const bool by_tcp = kind == MovedBy::Kind::kTcp || kind == MovedBy::Kind::kDefault;
  if (by_tcp && options.moved_by.with_axes) held->standOnAxes(placements);
  held->gatherMovedParts(placements);
  HAPTICELL_TRY(held->makeManipulator(held->form_, options, configuration));
  held->gatherPairs(held->form_, placements, options, configuration);
  held->startBoundaries();
  held->noteTurned();
  return held;
}

/// What of it and of its obstacles was written inside out, in one sentence.
void HeldEntity::noteTurned() {
  std::vector<std::string> names;
  const auto note = [&](const ScenePart& part) {
    if (part.mesh.bodies_turned > 0) names.push_back(nameOf(part));
  };
  for (const MovedPart& part : moved_parts_) note(*part.part);
  for (const ScenePart* part : obstacle_parts_) note(*part);
  if (names.empty()) return;
  std::string text = names.front();
  if (names.size() > 1) text += " and " + std::to_string(names.size() - 1) + " more";
  notes_.push_back(text + ": triangles face inward; they count as facing outward");
}

void HeldEntity::gatherMovedParts(const Placements& placements) {
  // Entities hang on each other in a tree: each round finds those that hang on the ones found before.
  std::vector<std::string> names;
  std::vector<int> links;
  for (const Member& member : members_) {
    names.push_back(scene_->find(member.id)->name);
    links.push_back(form_.robot ? member.first_link : -1);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const Entity& other : scene_->entities()) {
      if (other.attachment.to != names[k] || isMember(other.id)) continue;
      const Entity* on = k < members_.size() ? scene_->find(members_[k].id) : nullptr;
      const bool on_robot = on && on->robot && !other.attachment.link.empty();
      const int link = links[k] + (on_robot ? std::max(0, on->robot->findLink(other.attachment.link)) : 0);
      Carried carried{other.id, link, {}, {}};
      const Pose X_WE = placementOf(other, placements, carried.joints);
      const Pose X_WL = PreparedScene::partPose(form_, accepted_.X_WE, accepted_.joints, link);
      carried.X_LE = X_WL.inverse() * X_WE;
      names.push_back(other.name);
      links.push_back(link);
      carried_.push_back(std::move(carried));
    }
  }
  for (const ScenePart& part : scene_->parts()) {
    const auto member =
        std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.id == part.entity; });
    if (member != members_.end()) {
      moved_parts_.push_back({&part, part.entity, part.link < 0 ? -1 : member->first_link + part.link, {}});
    } else {
      const auto found =
          std::find_if(carried_.begin(), carried_.end(), [&](const Carried& c) { return c.id == part.entity; });
      if (found == carried_.end()) continue;
      const Entity& owner = *scene_->find(part.entity);
      const Pose X_EP = PreparedScene::partPose(owner, Pose::identity(), found->joints, part.link);
      moved_parts_.push_back({&part, part.entity, found->link, found->X_LE * X_EP});
    }
    parts_.push_back(part.mesh.pieces.get());
    surfaces_.push_back(part.mesh.surfaces.get());
  }
}

std::vector<std::pair<workcell::EntityId, EntityConfiguration>> HeldEntity::carried() const {
  std::vector<std::pair<workcell::EntityId, EntityConfiguration>> result;
  for (auto& axis : axes()) result.push_back(std::move(axis));
  for (const Carried& carried : carried_) {
    const Pose X_WL = PreparedScene::partPose(form_, accepted_.X_WE, accepted_.joints, carried.link);
    result.emplace_back(carried.id, EntityConfiguration{X_WL * carried.X_LE, carried.joints});
  }
  return result;
}

/// Rounded, so that the server is not told of every hair's breadth.
void HeldEntity::updateJointFriction() {
  constexpr double kStep = 0.05, kMost = 3.0;  // N
  const bool any = std::any_of(friction_.begin(), friction_.end(), [](double friction) { return friction > 0.0; });
  if (!any) return;
  joint_friction_ = std::min(kMost, kStep * std::round(manipulator_->resistance(accepted_, friction_) / kStep));
}

Expected<void> HeldEntity::makeManipulator(const Entity& entity, const HoldOptions& options,
                                           const config::Configuration& configuration) {
  std::vector<Taking::Part> parts;
  for (const MovedPart& part : moved_parts_) parts.push_back({part.link, part.X_LP});
  const Taking taking{entity, accepted_, resolved(options.moved_by, entity), *scene_, configuration, parts};
  auto made = manipulation::makeManipulator(taking, manipulatorKinds());
  HAPTICELL_TRY(made);
  manipulator_ = std::move(*made);
  gatherFriction();
  return {};
}

void HeldEntity::gatherFriction() {
  friction_.clear();
  for (const Member& member : members_) {
    const Entity& one = *scene_->find(member.id);
    if (!one.robot) continue;
    const auto own =
        one.mechanism ? workcell::frictionOf(*one.mechanism, *one.robot) : std::vector<double>(one.robot->dof(), 0.0);
    friction_.insert(friction_.end(), own.begin(), own.end());
  }
  updateJointFriction();
}

void HeldEntity::gatherPairs(const Entity& entity, const Placements& placements, const HoldOptions& options,
                             const config::Configuration& configuration) {
  std::vector<std::shared_ptr<const collision::MeshCollider>> colliders;
  for (const MovedPart& part : moved_parts_) colliders.push_back(part.part->mesh.collider);
  const auto is_moved = [&](workcell::EntityId id) {
    return isMember(id) || std::any_of(carried_.begin(), carried_.end(), [&](const Carried& c) { return c.id == id; });
  };
  std::map<workcell::EntityId, std::vector<workcell::EffectivePair>> rules_of;
  for (const MovedPart& part : moved_parts_) {
    if (!rules_of.count(part.owner)) rules_of[part.owner] = scene_->pairsOf(part.owner, options.on_contact);
  }
  std::vector<Obstacle> obstacles;
  for (const ScenePart& part : scene_->parts()) {
    if (is_moved(part.entity)) continue;
    const Entity& other = *scene_->find(part.entity);
    std::vector<double> joints;
    const Pose X_WE = placementOf(other, placements, joints);
    const Pose X_WO = PreparedScene::partPose(other, X_WE, joints, part.link);
    bool checked = false;
    for (std::uint32_t k = 0; k < colliders.size(); ++k) {
      const auto& rules = rules_of[moved_parts_[k].owner];
      const auto rule = std::find_if(rules.begin(), rules.end(), [&](const auto& r) { return r.other == other.id; });
      if (rule == rules.end()) continue;
      if (!scene_->isChecked(*moved_parts_[k].part, part)) continue;
      const workcell::PairRule* own = scene_->ruleFor(*moved_parts_[k].part, part);
      HeldPair pair{other.id,
                    moved_parts_[k].owner,
                    moved_parts_[k].part->name,
                    part.name,
                    rule->safety_distance,
                    rule->near_miss,
                    rule->on_contact,
                    {}};
      if (own && own->on_contact) pair.on_contact = *own->on_contact;
      pair.feel.felt = pair.on_contact != OnContact::kPass;
      const Entity& owner = moved_parts_[k].owner == id_ ? entity : *scene_->find(moved_parts_[k].owner);
      if (options.force_class != ForceClass::kConstant) blend(configuration, owner, other, pair.feel);
      if (pair.on_contact == OnContact::kStop) pair.feel.friction = kStickingFriction;
      motion_pairs_.push_back({k, static_cast<std::uint32_t>(obstacles.size()), pair.feel.felt});
      feel_.push_back(pair.feel);
      pairs_.push_back(std::move(pair));
      checked = true;
    }
    if (!checked) continue;
    obstacles_.push_back({part.mesh.pieces.get(), X_WO, obstacles.size() + 1, 0.0, part.mesh.surfaces.get()});
    obstacles.push_back({part.mesh.collider, X_WO});
    obstacle_parts_.push_back(&part);
  }
  gatherOwnPairs(entity, options, configuration);
  gaps_.resize(pairs_.size());
  motion_ = std::make_unique<FreeMotion>(std::move(colliders), std::move(obstacles), motion_pairs_);
  motion_->reset(*manipulator_, accepted_);
}

std::string HeldEntity::nameOf(const ScenePart& part) const {
  const std::string& entity = scene_->find(part.entity)->name;
  return part.name.empty() ? entity : entity + "/" + part.name;
}

void HeldEntity::distances(double limit, std::vector<FreeMotion::PairDistance>& near) {
  motion_->distances(limit, near);
}

}  // namespace hapticell::manipulation
