// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/inverse_model.h"
#include "kinematics/model/jacobian.h"
#include "manipulation/checks/path_finding.h"
#include "manipulation/manipulators/manipulator.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// Of a robot: joints against their ends and speeds, how near the arm is to losing a direction, and changes of its
/// branch. The entity must outlive it. One thread.
class JointTrack {
 public:
  /// @pre entity.robot() is set.
  explicit JointTrack(const workcell::Entity& entity);

  /// The frame at t (s), `dt` after the one `before` (null for the first): what is found goes into `list`. Joints in
  /// rad or m.
  void look(const EntityConfiguration& at, const EntityConfiguration* before, double t, double dt, FindingList& list);

 private:
  void lookAtConfiguration(const EntityConfiguration& at, double t, FindingList& list);

  const kinematics::RobotModel& model_;
  std::optional<kinematics::Chain> arm_;
  std::optional<int> configuration_;
  int tip_ = -1;
  std::vector<int> variables_;
  std::vector<Pose> X_BL_;
  kinematics::Jacobian jacobian_;
};

}  // namespace hapticell::manipulation
