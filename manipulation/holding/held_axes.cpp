// SPDX-License-Identifier: Apache-2.0
// The external axes of a held robot: the rail, gantry or rotary table that it stands on.
#include <algorithm>

#include "geometry/system/assertion.h"
#include "kinematics/model/mounted_robot.h"
#include "manipulation/holding/held_entity.h"
#include "workcell/entity/mechanism.h"

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
    const int link = carrier->robot ? carrier->robot->findLink(at->attachment.link) : -1;
    // A pedestal without joints is passed over: it hangs on the axis and goes with it.
    if (link >= 0 && kinematics::isMoved(*carrier->robot, link)) found.push_back({carrier, link});
    at = carrier;
  }
  return found;
}

}  // namespace

/// What cannot go along stands still: a locked axis, one with closed loops.
void HeldEntity::standOnAxes(const Placements& placements) {
  const auto placed = [&](const Entity& entity) {
    const auto moved = placements.find(entity.id);
    return moved == placements.end() ? EntityConfiguration{entity.X_WE, entity.joints} : moved->second;
  };
  if (!form_.robot || form_.kind == workcell::EntityKind::kMannequin) return;
  const std::vector<Footing> footings = footingsOf(*scene_, *scene_->find(id_));
  for (const Footing& footing : footings) {
    const Entity& carrier = *footing.carrier;
    if (carrier.locked) continue;
    const EntityConfiguration base = placed(carrier);
    const Pose X_WL = PreparedScene::partPose(carrier, base.X_WE, base.joints, footing.link);
    auto mounted = kinematics::mountRobot(*carrier.robot, footing.link, X_WL.inverse() * accepted_.X_WE, *form_.robot);
    if (!mounted) {
      notes_.push_back(carrier.name + " does not go along with " + form_.name + ": " + mounted.error().message());
      continue;
    }
    for (Member& member : members_) {
      member.first_link += static_cast<int>(carrier.robot->links.size());
      member.first_joint += static_cast<int>(carrier.robot->joints.size()) + 1;
      member.first_variable += carrier.robot->dof();
    }
    members_.insert(members_.begin(), Member{carrier.id, 0, 0, 0});
    form_.robot = std::make_shared<const kinematics::RobotModel>(std::move(*mounted));
    accepted_.X_WE = base.X_WE;
    accepted_.joints.insert(accepted_.joints.begin(), base.joints.begin(), base.joints.end());
  }
}

bool HeldEntity::isMember(workcell::EntityId id) const {
  return std::any_of(members_.begin(), members_.end(), [&](const Member& member) { return member.id == id; });
}

EntityConfiguration HeldEntity::standing() const {
  if (members_.size() == 1) return accepted_;
  const Member& own = members_.back();
  return {PreparedScene::partPose(form_, accepted_.X_WE, accepted_.joints, own.first_link),
          {accepted_.joints.begin() + static_cast<std::ptrdiff_t>(own.first_variable), accepted_.joints.end()}};
}

std::vector<std::pair<workcell::EntityId, EntityConfiguration>> HeldEntity::axes() const {
  std::vector<std::pair<workcell::EntityId, EntityConfiguration>> result;
  for (std::size_t k = 0; k + 1 < members_.size(); ++k) {
    const Member &member = members_[k], &next = members_[k + 1];
    const Pose X_WE = PreparedScene::partPose(form_, accepted_.X_WE, accepted_.joints, member.first_link);
    const auto joints = accepted_.joints.begin();
    result.emplace_back(member.id, EntityConfiguration{X_WE,
                                                       {joints + static_cast<std::ptrdiff_t>(member.first_variable),
                                                        joints + static_cast<std::ptrdiff_t>(next.first_variable)}});
  }
  return result;
}

Pose HeldEntity::movedFrameWhen(const std::function<EntityConfiguration(workcell::EntityId)>& placed) const {
  EntityConfiguration together = placed(members_.front().id);
  for (std::size_t k = 1; k < members_.size(); ++k) {
    const EntityConfiguration one = placed(members_[k].id);
    together.joints.insert(together.joints.end(), one.joints.begin(), one.joints.end());
  }
  return manipulator_->movedFrame(together);
}

int HeldEntity::ownJoint(int joint) const {
  return joint < 0 ? -1 : std::max(-1, joint - members_.back().first_joint);
}

const std::string& HeldEntity::jointName(int joint) const {
  HAPTICELL_DEMAND(form_.robot && joint >= 0 && static_cast<std::size_t>(joint) < form_.robot->joints.size());
  return form_.robot->joints[static_cast<std::size_t>(joint)].name;
}

}  // namespace hapticell::manipulation
