// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Inverse kinematics of any robot with a closure, by bounded damped least squares over its variables.
///
/// Each step computes the Jacobian of the tool centre point by differences of the closure's forward model, so nothing
/// else of the closure is needed. Limits of variables form an active set; a step that would violate the closure's
/// margins or open its loops is not taken. Position weighs 1, orientation 0.25 m per rad. solve() restarts at Halton
/// points if the start does not lead to the pose. Const methods keep no state.
class ClosureInverse : public InverseModel {
 public:
  /// `model` must have a closure. The model's links are not kept. Errors: the link is the root.
  static Expected<std::unique_ptr<InverseModel>> create(const RobotModel& model, int tip_link, const Pose& X_LT);

  std::string name() const override { return closure_->name(); }
  const std::vector<int>& variables() const override { return variables_; }
  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override;
  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override;
  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const override;

 protected:
  ClosureInverse(const RobotModel& model, int tip_link, const Pose& X_LT);

  struct Bounds {
    std::vector<double> lower, upper;
  };
  /// Least squares from `q` (put into the bounds) in at most `iterations` steps.
  void descend(const Pose& X_BT, const Bounds& bounds, int iterations, std::vector<double>& q) const;
  Pose tipAt(const std::vector<double>& q) const;
  /// Sets errors, status and `singular` for solution.q.
  void judge(const Pose& X_BT, const Bounds& bounds, InverseSolution& solution) const;
  bool withinLimits(const std::vector<double>& q) const;
  /// True if no variable needs longer than this from the start.
  bool withinSpeed(const std::vector<double>& q, const std::vector<double>& q_start, double duration_s) const;
  const Bounds& limits() const { return limits_; }
  const std::vector<double>& home() const { return home_; }
  const Pose& toolInTip() const { return X_LT_; }

 private:
  bool allowed(const std::vector<double>& q, double& least_margin) const;

  std::shared_ptr<const Closure> closure_;
  int tip_link_ = 0;
  Pose X_LT_;
  std::vector<int> variables_;
  std::vector<bool> slides_;
  std::vector<double> velocity_, home_;
  Bounds limits_;
};

/// The tip's Jacobian over the variables at `q` by central differences of the closure (h = 1e-6), 6 rows like a
/// geometric Jacobian's, linear over angular.
struct Jacobian;
void closureJacobian(const RobotModel& model, const std::vector<double>& q, int link, const Pose& X_LT, Jacobian& J);

}  // namespace hapticell::kinematics
