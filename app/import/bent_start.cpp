// SPDX-License-Identifier: Apache-2.0
#include "app/import/bent_start.h"

#include "kinematics/model/start_posture.h"

namespace hapticell::app {

void startBent(workcell::Entity& entity, workcell::ImportReport& report) {
  if (entity.kind() != workcell::EntityKind::kRobot || !entity.robot() || !entity.robot()->home.empty()) return;
  if (!entity.joints().empty() && entity.joints() != kinematics::restPositions(*entity.robot())) return;
  auto start = kinematics::bentStart(*entity.robot(), entity.robot()->findLink(entity.jointed().tip_link));
  if (!start) return;
  std::string joints;
  for (const std::string& joint : start->bent_joints) joints += (joints.empty() ? "" : ", ") + joint;
  entity.setJoints(std::move(start->q));
  report.warnings.push_back(
      Text("The file of %1 has no home pose, and its zero pose is singular, so it could hardly be dragged. It "
           "starts with %2 bent. To set a home pose, use the Robot panel.",
           entity.name, joints));
}

}  // namespace hapticell::app
