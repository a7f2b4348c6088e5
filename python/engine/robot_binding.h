// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::python {

/// What Python sees as hapticell.Robot: a model, the tool centre point that is asked for, and scratch for queries,
/// which run with the interpreter's lock.
class Robot {
 public:
  Robot(std::shared_ptr<const kinematics::RobotModel> model, int tip, Pose X_LT);

  /// The same without what it remembers, for another thread.
  Robot copy() const { return Robot(model_, tip_, X_LT_); }
  const kinematics::RobotModel& model() const { return *model_; }
  int tip() const { return tip_; }
  /// Made at the first call. Raises Error for a chain without one.
  const kinematics::InverseModel& inverse();
  /// One of its own, for another thread.
  std::unique_ptr<kinematics::InverseModel> freshInverse() const;

  /// `q` has one finite number a variable; the robot's rest positions for None. Raises Error otherwise.
  const std::vector<double>& variables(pybind11::handle q);
  /// Poses of all links in the root link at these variables; valid until the next call.
  const std::vector<Pose>& linkPoses(const std::vector<double>& q);
  /// The tool centre point in the root link.
  Pose toolPose(const std::vector<double>& q) { return linkPoses(q)[static_cast<std::size_t>(tip_)] * X_LT_; }

 private:
  std::shared_ptr<const kinematics::RobotModel> model_;
  int tip_;
  Pose X_LT_;
  std::unique_ptr<kinematics::InverseModel> inverse_;
  std::vector<double> q_;
  std::vector<Pose> X_BL_;
};

}  // namespace hapticell::python
