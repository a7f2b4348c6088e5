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

/// Two frames that a loop holds together: C on link A and C on link B.
struct LoopConstraint {
  enum class Kind {
    kPoint,  ///< Their origins coincide (a ball joint): 3 equations.
    kAxis,   ///< And their z axes are parallel (a hinge): 5 equations.
    kWeld,   ///< The frames coincide: 6 equations.
  };
  Kind kind = Kind::kPoint;
  std::string name;
  int link_a = -1;
  Pose X_AC;
  int link_b = -1;
  Pose X_BC;
};

/// What is known of a mechanism besides its joints.
struct LoopOptions {
  std::vector<std::string> actuated;                  ///< Joints that users set; empty: chosen (see LoopClosure).
  std::vector<std::pair<std::string, double>> start;  ///< Joint positions near the home assembly; others 0.
};

/// Closed loops in general: the passive joints of a tree follow the set ones so that the loops stay closed.
///
/// The equations of all loops are solved by damped Gauss-Newton steps in the passive joints (constraint projection)
/// to 1e-12 m, along a straight line of set positions from the home assembly, so that the assembly never changes.
/// Redundant equations (planar linkages) and idle freedoms (a rod that spins) do no harm: the steps have least length.
class LoopClosure final : public Closure {
 public:
  /// Closes the loops of `tree`, whose moving joints are all variables: puts the closure into the model and leaves the
  /// set joints as its variables. Those are `options.actuated`, else as many as the mechanism has degrees of freedom,
  /// prismatic joints first, then those nearest to the root, so that the others follow from them. `home` of the model
  /// becomes the assembly nearest to `options.start`.
  ///
  /// Errors: loops that cannot be closed from the start, an actuated or started joint that does not exist, actuated
  /// joints that do not determine the rest or are not independent (too many).
  static Expected<void> close(RobotModel& tree, std::vector<LoopConstraint> loops, const LoopOptions& options);

  std::string name() const override { return "loops"; }
  bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const override;
  void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const override;
  Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel& model, int tip_link,
                                                  const Pose& X_LT) const override;

  /// All joint positions of the tree for `q`; false where the loops cannot be closed.
  bool solve(const std::vector<double>& q, std::vector<double>& all) const;
  /// The tree with all its joints as variables, and the loops: for tests and reports.
  const RobotModel& tree() const { return tree_; }
  const std::vector<LoopConstraint>& loops() const { return loops_; }
  /// The largest gap (m; rotation times the size of the mechanism) that is left at joint positions `all`.
  double gap(const std::vector<double>& all) const;

 private:
  friend struct LoopSolver;
  RobotModel tree_;
  std::vector<LoopConstraint> loops_;
  std::vector<int> actuated_;  ///< Variables of the tree, in the order of the model's variables.
  std::vector<int> passive_;
  std::vector<double> home_;  ///< All variables of the tree.
  double size_ = 1.0;         ///< m: lever that turns angles into lengths.

  mutable std::mutex mutex_;  ///< Guards the last solution, a better start than home when it is near.
  mutable std::vector<double> last_;
};

}  // namespace hapticell::kinematics
