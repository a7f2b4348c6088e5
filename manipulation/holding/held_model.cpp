// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_model.h"

#include <algorithm>

#include "geometry/system/assertion.h"
#include "kinematics/model/mounted_robot.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;

/// What carries an entity, from the nearest on, and the link of each that it stands on.
struct Footing {
  const Entity* carrier = nullptr;
  int link = 0;
};

std::vector<Footing> footingsOf(const PreparedScene& scene, const Entity& entity) {
  std::vector<Footing> found;
  for (const Entity* at = &entity; !at->attachment.to.empty() && found.size() < scene.entities().size();) {
    const Entity* carrier = scene.find(at->attachment.to);
    if (carrier == nullptr) break;
    const int link = carrier->robot() ? carrier->robot()->findLink(at->attachment.link) : -1;
    // A pedestal without joints is passed over: it hangs on the axis and goes with it.
    if (link >= 0 && kinematics::isMoved(*carrier->robot(), link)) found.push_back({carrier, link});
    at = carrier;
  }
  return found;
}

}  // namespace

EntityConfiguration standingOf(const Entity& entity, const Placements& placements) {
  const auto moved = placements.find(entity.id);
  return moved == placements.end() ? EntityConfiguration{entity.X_WE, entity.joints()} : moved->second;
}

HeldModel::HeldModel(std::shared_ptr<const PreparedScene> scene, const Entity& entity, const Placements& placements,
                     bool with_axes, std::vector<Text>& notes)
    : scene_(std::move(scene)),
      id_(entity.id),
      form_(entity),
      taken_(standingOf(entity, placements)),
      members_{{entity.id, 0, 0, 0}} {
  if (with_axes) mountOnAxes(placements, notes);
  gatherCarried(placements);
  gatherParts();
}

/// What cannot go along stands still: a locked axis, one with closed loops.
void HeldModel::mountOnAxes(const Placements& placements, std::vector<Text>& notes) {
  if (!workcell::isMachine(form_)) return;
  const std::vector<Footing> footings = footingsOf(*scene_, *scene_->find(id_));
  for (const Footing& footing : footings) {
    const Entity& carrier = *footing.carrier;
    if (carrier.locked) continue;
    const EntityConfiguration base = standingOf(carrier, placements);
    const Pose X_WL = PreparedScene::partPose(carrier, base.X_WE, base.joints, footing.link);
    auto mounted = kinematics::mountRobot(*carrier.robot(), footing.link, X_WL.inverse() * taken_.X_WE, *form_.robot());
    if (!mounted) {
      notes.push_back(Text("%1 does not go along with %2: %3", carrier.name, form_.name, mounted.error().text()));
      continue;
    }
    for (Member& member : members_) {
      member.first_link += static_cast<int>(carrier.robot()->links.size());
      member.first_joint += static_cast<int>(carrier.robot()->joints.size()) + 1;
      member.first_variable += carrier.robot()->dof();
    }
    members_.insert(members_.begin(), Member{carrier.id, 0, 0, 0});
    form_.editJointed().model = std::make_shared<const kinematics::RobotModel>(std::move(*mounted));
    taken_.X_WE = base.X_WE;
    taken_.joints.insert(taken_.joints.begin(), base.joints.begin(), base.joints.end());
  }
  if (members_.size() == 1) return;
  form_.X_WE = taken_.X_WE;
  form_.setJoints(taken_.joints);
}

void HeldModel::gatherCarried(const Placements& placements) {
  // Entities hang on each other in a tree: each round finds those that hang on the ones found before.
  std::vector<std::string> names;
  std::vector<int> links;
  for (const Member& member : members_) {
    names.push_back(scene_->find(member.id)->name);
    links.push_back(form_.robot() ? member.first_link : -1);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const Entity& other : scene_->entities()) {
      if (other.attachment.to != names[k] || isMember(other.id)) continue;
      const Entity* on = k < members_.size() ? scene_->find(members_[k].id) : nullptr;
      const bool on_robot = on && on->robot() && !other.attachment.link.empty();
      const int link = links[k] + (on_robot ? std::max(0, on->robot()->findLink(other.attachment.link)) : 0);
      EntityConfiguration stands = standingOf(other, placements);
      const Pose X_WL = PreparedScene::partPose(form_, taken_.X_WE, taken_.joints, link);
      names.push_back(other.name);
      links.push_back(link);
      carried_.push_back({other.id, link, X_WL.inverse() * stands.X_WE, std::move(stands.joints)});
    }
  }
}

void HeldModel::gatherParts() {
  for (const ScenePart& part : scene_->parts()) {
    const auto member =
        std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.id == part.entity; });
    if (member != members_.end()) {
      parts_.push_back({&part, part.entity, part.link < 0 ? -1 : member->first_link + part.link, {}});
    } else {
      const auto found =
          std::find_if(carried_.begin(), carried_.end(), [&](const Carried& c) { return c.id == part.entity; });
      if (found == carried_.end()) continue;
      const Entity& owner = *scene_->find(part.entity);
      const Pose X_EP = PreparedScene::partPose(owner, Pose::identity(), found->joints, part.link);
      parts_.push_back({&part, part.entity, found->link, found->X_LE * X_EP});
    }
    pieces_.push_back(part.mesh.pieces.get());
    surfaces_.push_back(part.mesh.surfaces.get());
  }
}

std::vector<const Entity*> HeldModel::members() const {
  std::vector<const Entity*> result;
  for (const Member& member : members_) result.push_back(scene_->find(member.id));
  return result;
}

bool HeldModel::isMember(workcell::EntityId id) const {
  return std::any_of(members_.begin(), members_.end(), [&](const Member& member) { return member.id == id; });
}

bool HeldModel::isMoved(workcell::EntityId id) const {
  return isMember(id) || std::any_of(carried_.begin(), carried_.end(), [&](const Carried& c) { return c.id == id; });
}

EntityConfiguration HeldModel::standing(const EntityConfiguration& all) const {
  if (members_.size() == 1) return all;
  const Member& own = members_.back();
  return {PreparedScene::partPose(form_, all.X_WE, all.joints, own.first_link),
          {all.joints.begin() + static_cast<std::ptrdiff_t>(own.first_variable), all.joints.end()}};
}

HeldModel::Standing HeldModel::axes(const EntityConfiguration& all) const {
  Standing result;
  for (std::size_t k = 0; k + 1 < members_.size(); ++k) {
    const Member &member = members_[k], &next = members_[k + 1];
    const Pose X_WE = PreparedScene::partPose(form_, all.X_WE, all.joints, member.first_link);
    const auto joints = all.joints.begin();
    result.emplace_back(member.id, EntityConfiguration{X_WE,
                                                       {joints + static_cast<std::ptrdiff_t>(member.first_variable),
                                                        joints + static_cast<std::ptrdiff_t>(next.first_variable)}});
  }
  return result;
}

HeldModel::Standing HeldModel::carried(const EntityConfiguration& all) const {
  Standing result = axes(all);
  for (const Carried& carried : carried_) {
    const Pose X_WL = PreparedScene::partPose(form_, all.X_WE, all.joints, carried.link);
    result.emplace_back(carried.id, EntityConfiguration{X_WL * carried.X_LE, carried.joints});
  }
  return result;
}

int HeldModel::ownJoint(int joint) const {
  return joint < 0 ? -1 : std::max(-1, joint - members_.back().first_joint);
}

const std::string& HeldModel::jointName(int joint) const {
  HAPTICELL_DEMAND(form_.robot() && joint >= 0 && static_cast<std::size_t>(joint) < form_.robot()->joints.size());
  return form_.robot()->joints[static_cast<std::size_t>(joint)].name;
}

std::string HeldModel::nameOf(const ScenePart& part) const {
  const std::string& entity = scene_->find(part.entity)->name;
  return part.name.empty() ? entity : entity + "/" + part.name;
}

}  // namespace hapticell::manipulation
