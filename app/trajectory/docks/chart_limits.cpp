// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/chart_limits.h"

#include "app/trajectory/motions/motion_work.h"
#include "manipulation/checks/motion_replay.h"

namespace hapticell::app {

std::vector<MotionChart::Limit> chartLimits(const workcell::Entity& entity, const trajectory::Trajectory& trajectory) {
  const auto bounds = limitsOf(entity, trajectory);
  std::vector<std::string> names = trajectory.joint_names;
  if (!trajectory.hasJoints()) names = {"x", "y", "z", "turn x", "turn y", "turn z"};
  const auto columns = manipulation::jointColumns(entity, trajectory);
  std::vector<MotionChart::Limit> limits;
  for (std::size_t i = 0; i < names.size(); ++i) {
    MotionChart::Limit limit;
    limit.curve = names[i];
    limit.speed = bounds.velocity[i];
    limit.acceleration = bounds.acceleration[i];
    limit.jerk = bounds.acceleration[i] / kUsualRamp;
    if (trajectory.hasJoints() && columns && entity.robot()) {
      const int joint = entity.robot()->moving[(*columns)[i]];
      limit.lowest = entity.robot()->joints[static_cast<std::size_t>(joint)].lower;
      limit.highest = entity.robot()->joints[static_cast<std::size_t>(joint)].upper;
      limit.slides = entity.robot()->joints[static_cast<std::size_t>(joint)].type == kinematics::JointType::kPrismatic;
    }
    limits.push_back(std::move(limit));
  }
  return limits;
}

}  // namespace hapticell::app
