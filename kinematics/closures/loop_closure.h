// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/closure.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Two frames that a loop connects: C on link A and C on link B.
struct LoopConstraint {
  enum class Kind {
    kPoint,  ///< Their origins coincide (a ball joint): 3 equations.
    kAxis,   ///< Also, their z axes are parallel (a hinge): 5 equations.
    kWeld,   ///< The frames coincide: 6 equations.
  };
  Kind kind = Kind::kPoint;
  std::string name;
  int link_a = -1;
  Pose X_AC;
  int link_b = -1;
  Pose X_BC;
};

/// Properties of a mechanism other than its joints.
struct LoopOptions {
  std::vector<std::string> actuated;  ///< Joints that users set; empty: chosen automatically (see LoopClosure).
  std::vector<std::pair<std::string, double>> start;  ///< Joint positions near the home assembly; the others are 0.
};

/// Closed loops in general: the passive joints of a tree follow the actuated ones so that the loops stay closed.
///
/// The equations of all loops are solved by damped Gauss-Newton steps in the passive joints (constraint projection) to
/// 1e-12 m, along a straight line of actuated positions from the home assembly, so that the assembly never changes.
/// Redundant equations (planar linkages) and free motions without effect (a rod that spins) are allowed: the steps have
/// minimum length.
class LoopClosure final : public Closure {
 public:
  /// Closes the loops of `tree`, in which every moving joint is a variable: adds the closure to the model and keeps
  /// only the actuated joints as its variables. These are `options.actuated`, or else as many as the mechanism has
  /// degrees of freedom: prismatic joints first, then those nearest to the root, such that the others follow from them.
  /// `home` of the model becomes the assembly nearest to `options.start`.
  ///
  /// Errors: loops that cannot be closed from the start, an actuated or started joint that does not exist, actuated
  /// joints that do not determine the others or are not independent (too many).
  static Expected<void> close(RobotModel& tree, std::vector<LoopConstraint> loops, const LoopOptions& options);

  std::string name() const override { return "loops"; }
  bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const override;
  void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const override;
  Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel& model, int tip_link,
                                                  const Pose& X_LT) const override;

  /// All joint positions of the tree for `q`; false if the loops cannot be closed.
  bool solve(const std::vector<double>& q, std::vector<double>& all) const;
  /// The tree with all its joints as variables, and the loops: for tests and reports.
  const RobotModel& tree() const { return tree_; }
  const std::vector<LoopConstraint>& loops() const { return loops_; }
  /// The largest remaining gap (m; rotation times the size of the mechanism) at joint positions `all`.
  double gap(const std::vector<double>& all) const;

 private:
  friend struct LoopSolver;
  RobotModel tree_;
  std::vector<LoopConstraint> loops_;
  std::vector<int> actuated_;  ///< Variables of the tree, in the order of the model's variables.
  std::vector<int> passive_;
  std::vector<double> home_;  ///< All variables of the tree.
  double size_ = 1.0;         ///< m: lever that converts angles to lengths.

  mutable std::mutex mutex_;  ///< Guards the last solution, which is a better start than home if it is near.
  mutable std::vector<double> last_;
};

}  // namespace hapticell::kinematics
