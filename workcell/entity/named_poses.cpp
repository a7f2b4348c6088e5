// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/named_poses.h"

#include <algorithm>

namespace hapticell::workcell {

namespace {

const std::string& variableName(const kinematics::RobotModel& model, std::size_t variable) {
  return model.joints[static_cast<std::size_t>(model.moving[variable])].name;
}

}  // namespace

std::vector<kinematics::NamedPose> namedPosesOf(const Entity& entity) {
  std::vector<kinematics::NamedPose> poses;
  if (!isMachine(entity)) return poses;
  poses.push_back({"home", kinematics::restPositions(*entity.robot())});
  for (const auto* list : {&entity.robot()->named_poses, &entity.jointed().named_poses}) {
    for (const kinematics::NamedPose& pose : *list) {
      const auto known = std::find_if(poses.begin(), poses.end(), [&](const auto& p) { return p.name == pose.name; });
      known == poses.end() ? poses.push_back(pose) : void(known->q = pose.q);
    }
  }
  return poses;
}

std::vector<double> findNamedPose(const Entity& entity, const std::string& name) {
  for (kinematics::NamedPose& pose : namedPosesOf(entity)) {
    if (pose.name == name) return std::move(pose.q);
  }
  return {};
}

std::vector<kinematics::NamedPose> posesFor(const kinematics::RobotModel& model, const Entity& before) {
  std::vector<kinematics::NamedPose> poses;
  for (const kinematics::NamedPose& pose : before.jointed().named_poses) {
    kinematics::NamedPose moved{pose.name, kinematics::restPositions(model)};
    for (std::size_t i = 0; i < model.moving.size(); ++i) {
      for (std::size_t k = 0; k < pose.q.size(); ++k) {
        if (variableName(model, i) == variableName(*before.robot(), k)) moved.q[i] = pose.q[k];
      }
    }
    poses.push_back(std::move(moved));
  }
  return poses;
}

}  // namespace hapticell::workcell
