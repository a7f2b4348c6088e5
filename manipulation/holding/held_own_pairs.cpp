// SPDX-License-Identifier: Apache-2.0
// What of a held robot or mannequin is checked against itself.
#include <algorithm>

#include "manipulation/holding/held_entity.h"
#include "manipulation/scene/mannequin_own_pairs.h"
#include "manipulation/scene/own_pairs.h"

namespace hapticell::manipulation {

namespace {

constexpr double kTouching = 2e-3;  ///< m: nearer than this at rest the shapes are those of neighbours.
constexpr std::size_t kMostNamed = 3;

std::string noteOn(const std::string& robot, const std::vector<std::string>& touching) {
  std::string names;
  for (std::size_t i = 0; i < std::min(touching.size(), kMostNamed); ++i) names += (i == 0 ? "" : ", ") + touching[i];
  if (touching.size() > kMostNamed) names += " and " + std::to_string(touching.size() - kMostNamed) + " more pairs";
  return "links of " + robot + " that touch at rest are not checked against each other: " + names;
}

}  // namespace

/// Where the moved parts are while the robot is at rest, its root at the origin.
std::vector<Pose> HeldEntity::restPoses(const workcell::Entity& entity) const {
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*entity.robot, kinematics::restPositions(*entity.robot), X_EL);
  std::vector<Pose> poses;
  for (const MovedPart& part : moved_parts_) {
    poses.push_back(X_EL[static_cast<std::size_t>(std::max(0, part.link))] * part.X_LP);
  }
  return poses;
}

void HeldEntity::gatherOwnPairs(const workcell::Entity& entity, const HoldOptions& options,
                                const config::Configuration& configuration) {
  first_own_ = static_cast<std::uint32_t>(pairs_.size());
  const bool body = entity.kind == workcell::EntityKind::kMannequin;
  if (!entity.robot || !entity.checked || !configuration.robot.self_collision) return;
  if (options.on_contact == workcell::OnContact::kPass) return;
  std::vector<OwnPart> parts;
  for (const MovedPart& part : moved_parts_) parts.push_back({std::max(0, part.link), !isMember(part.owner)});
  std::vector<Pose> X_EP = restPoses(entity);
  // A body has no rest in which all is apart: what overlaps as it is taken (an arm on the thigh) is left out instead.
  if (body) manipulator_->partPoses(accepted_, X_EP);
  // What a hand carries is checked as that hand is.
  const auto linkOf = [&](const MovedPart& part) -> const std::string& {
    return entity.robot->links[static_cast<std::size_t>(std::max(0, part.link))].name;
  };
  std::vector<std::string> touching;
  for (OwnPair own : ownPairs(*entity.robot, parts)) {
    // What is carried is told first: "gripper touches robot/link_5".
    if (parts[own.second].carried) std::swap(own.first, own.second);
    const MovedPart &first = moved_parts_[own.first], &second = moved_parts_[own.second];
    if (!scene_->isChecked(*first.part, *second.part)) continue;
    const bool links = isMember(first.owner) && isMember(second.owner);
    if (body && !isOwnPairOfMannequin(linkOf(first), linkOf(second))) continue;
    const auto& a = first.part->mesh.collider;
    const auto& b = second.part->mesh.collider;
    // What lies between both hands touches the other one's fingers as it is taken.
    if ((links || body) &&
        collision::distance(a, X_EP[own.first], b, X_EP[own.second], 2.0 * kTouching).distance < kTouching) {
      if (!body) touching.push_back(first.part->name + " with " + second.part->name);
      continue;
    }
    HeldPair pair{second.owner,
                  first.owner,
                  first.part->name,
                  second.part->name,
                  configuration.manipulation.safety_distance,
                  0.0,
                  options.on_contact,
                  {}};
    if (const workcell::PairRule* rule = scene_->ruleFor(*first.part, *second.part); rule && rule->on_contact) {
      pair.on_contact = *rule->on_contact;
    }
    pair.feel.felt = pair.on_contact != workcell::OnContact::kPass;
    motion_pairs_.push_back({static_cast<std::uint32_t>(own.first), 0, pair.feel.felt, static_cast<int>(own.second)});
    feel_.push_back(pair.feel);
    pairs_.push_back(std::move(pair));
  }
  if (touching.empty()) return;
  left_out_note_ = noteOn(entity.name, touching);
  notes_.push_back(left_out_note_);
}

/// How the distance of a pair changes with the moved frame, at its nearest points.
haptic::Constraint HeldEntity::contactOf(const MotionPair& pair, const collision::DistanceResult& found) const {
  const std::vector<PartDifferential> parts = manipulator_->differentiate(accepted_);
  PointCondition condition;
  condition.p_WQ = found.p_WA;
  condition.nhat_W = found.nhat_BA_W;
  haptic::Constraint constraint;
  applyCondition(parts[pair.part], condition, constraint);
  if (pair.other_part < 0) return constraint;
  haptic::Constraint met;
  condition.p_WQ = found.p_WB;
  applyCondition(parts[static_cast<std::size_t>(pair.other_part)], condition, met);
  for (std::size_t i = 0; i < 6; ++i) constraint.gradient[i] -= met.gradient[i];
  for (std::size_t i = 0; i < 21; ++i) constraint.curvature[i] -= met.curvature[i];
  return constraint;
}

}  // namespace hapticell::manipulation
