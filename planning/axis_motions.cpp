// SPDX-License-Identifier: Apache-2.0
#include "planning/axis_motions.h"

#include <algorithm>
#include <string>

#include "kinematics/model/robot_model.h"

namespace hapticell::planning {

namespace {

using trajectory::Trajectory;

std::vector<std::string> jointNames(const kinematics::RobotModel& robot) {
  std::vector<std::string> names;
  for (const int joint : robot.moving) names.push_back(robot.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

/// The link of `axis` on which the next of the robot's carriers stands, or the robot itself.
std::string carryingLink(const manipulation::PreparedScene& scene, const workcell::Entity& robot,
                         const workcell::Entity& axis) {
  const workcell::Entity* at = &robot;
  for (std::size_t k = 0; k < scene.entities().size() && at != nullptr && !at->attachment.to.empty(); ++k) {
    if (at->attachment.to == axis.name) return at->attachment.link;
    at = scene.find(at->attachment.to);
  }
  return {};
}

Trajectory emptyMotion(const workcell::Entity& entity) {
  Trajectory motion;
  motion.entity = entity.name;
  motion.joint_names = jointNames(*entity.robot());
  return motion;
}

}  // namespace

std::vector<Trajectory> motionsOfEntities(const Trajectory& motion, const FreeSpace& space) {
  const std::size_t axis_variables = space.axisVariables();
  if (axis_variables == 0) return {motion};
  const manipulation::PreparedScene& scene = space.scene();
  EntityConfiguration at = space.present();
  std::vector<Trajectory> motions{emptyMotion(space.ownEntity())};
  motions.front().moved = motion.moved;
  std::vector<int> links;
  for (const auto& [id, stands] : space.axesAt(at)) {
    const workcell::Entity& axis = *scene.find(id);
    const std::string link = carryingLink(scene, space.ownEntity(), axis);
    motions.push_back(emptyMotion(axis));
    motions.back().moved = "frame:" + link;
    links.push_back(axis.robot()->findLink(link));
  }
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const auto joints = motion.joints(i);
    at.joints.assign(joints.begin(), joints.end());
    motions.front().addFrame(motion[i], joints.subspan(axis_variables));
    const auto axes = space.axesAt(at);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const auto& [id, stands] = axes[k];
      Trajectory::Frame frame;
      frame.t = motion[i].t;
      frame.X_WT = manipulation::PreparedScene::partPose(*scene.find(id), stands.X_WE, stands.joints, links[k]);
      motions[k + 1].addFrame(frame, stands.joints);
    }
  }
  return motions;
}

Expected<Trajectory> motionOfAll(const Trajectory& own, const std::vector<Trajectory>& axes,
                                 const workcell::Entity& whole) {
  Trajectory all = own.emptyCopy();
  all.joint_names = jointNames(*whole.robot());
  std::size_t count = own.joint_names.size();
  for (const Trajectory& axis : axes) count += axis.joint_names.size();
  bool fits = count == all.joint_names.size() && own.hasJoints();
  for (const Trajectory& axis : axes) {
    fits = fits && axis.hasJoints() && axis.size() == own.size();
    for (std::size_t i = 0; fits && i < own.size(); ++i) fits = axis[i].t == own[i].t;
  }
  if (!fits)
    return makeError({.place = Text("the motion of '%1'", whole.name),
                      .found = "motions of its external axes with other times or joints",
                      .expected = "motions that were written together"});
  all.reserve(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    std::vector<double> joints;
    for (const Trajectory& axis : axes) joints.insert(joints.end(), axis.joints(i).begin(), axis.joints(i).end());
    joints.insert(joints.end(), own.joints(i).begin(), own.joints(i).end());
    all.addFrame(own[i], joints);
  }
  return all;
}

}  // namespace hapticell::planning
