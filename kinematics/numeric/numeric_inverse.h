// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/chain.h"
#include "kinematics/model/chain_report.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/numeric/pose_fit.h"

namespace hapticell::kinematics {

/// Inverse kinematics of any serial chain by bounded damped least squares (see fitPose() for the method).
///
/// Where a pose cannot be met, position weighs 1 and orientation by a lever of 0.25 m unless set otherwise: 1 rad
/// counts like 250 mm. A longer lever keeps the orientation and lets the position yield, a shorter one the other way
/// round. Restarts begin at 1024 Halton points within the limits, those nearest to the wanted pose first, always the
/// same: answers repeat. Const methods keep no state and may run in several threads at once.
class NumericInverse final : public InverseModel {
 public:
  /// For the tool centre point X_LT on `tip_link` of `model`. The model is read, not kept. Errors: see Chain::create(),
  /// and a tool that is no pose.
  static Expected<std::unique_ptr<NumericInverse>> create(const RobotModel& model, int tip_link, const Pose& X_LT = {},
                                                          double lever_m = 0.25);

  std::string name() const override { return "numeric"; }
  const Chain* chain() const override { return &chain_; }
  const std::vector<int>& variables() const override { return chain_.variables(); }
  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override;

  /// What a shot does where only the joints' speeds are in the way (a wrist that would have to swing round).
  struct Hurried {
    /// What is kept, the position within 0.2 mm or the orientation within 0.2 mrad, while the other yields; where it
    /// cannot be kept, both yield by their weights.
    enum class Keep { kPosition, kOrientation };
    Keep keep = Keep::kPosition;
    int held = -1;  ///< A variable of the chain that does not move, or -1.
  };
  /// For solveNearest(); to be called before the model is used.
  void setHurried(const Hurried& hurried) { hurried_ = hurried; }
  /// solveNearest() for a pose that is known to be kept off by speeds alone: what is kept is tried first.
  void solveHurried(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const;

  /// The pose of least error from `q_start` however far it is, limits kept; no restarts.
  InverseSolution nearestMiss(const Pose& X_BT, const std::vector<double>& q_start) const;

  /// Any solution within limits, the start tried first where it is near: as solve(), but it returns the first one found
  /// and does not check its singularity.
  InverseSolution solveAny(const Pose& X_BT, const std::vector<double>& q_start) const;

  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override;
  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const override;

 private:
  struct Seed {
    ChainPositions x{};
    Pose X_BT;
  };

  Chain chain_;
  std::optional<kernels::TrueArm> arm_;  ///< For the fast descent, where the chain allows it.
  std::optional<Elbow> elbow_;
  FitOptions options_;
  Hurried hurried_;
  std::size_t model_dof_ = 0;
  std::vector<Seed> seeds_;
  std::array<std::vector<float>, 7> seed_columns_;  ///< The seeds' poses, column by column.

  NumericInverse(Chain chain, std::size_t model_dof, double lever_m);
  const kernels::TrueArm* arm() const { return arm_ ? &*arm_ : nullptr; }
  void makeSeeds();
  struct Shot {
    FitResult fit;
    bool at_limit = false;  ///< Not reached, and a joint is at its limit.
    bool at_speed = false;  ///< Not reached, and a joint moves at its greatest speed.
  };
  Shot shoot(const Pose& X_BT, const ChainPositions& x, double duration_s, double lever_m, int held) const;
  bool keepOne(const Pose& X_BT, const ChainPositions& x, double duration_s, Shot& shot) const;
  FitBox limits() const;
  FitBox withoutTurningLimits() const;
  void keepElbowSide(const ChainPositions& x, FitBox& box) const;
  ChainPositions pick(const std::vector<double>& q) const;
  void fill(const FitResult& fit, const std::vector<double>& q_start, InverseSolution& solution) const;
  double startApart(const Pose& X_BT, const ChainPositions& x_start) const;
  ChainPositions haltonPoint(std::size_t index) const;
  FitResult searchAny(const Pose& X_BT, const ChainPositions& x_start) const;
  bool isTooFar(const Pose& X_BT) const;
  std::vector<std::size_t> seedsNear(const Pose& X_BT) const;
  ChainPositions aboutStart(const ChainPositions& x_start, std::size_t index) const;
  FitResult searchWithinLimits(const Pose& X_BT, const ChainPositions& x_start) const;
  bool reachableWithoutLimits(const Pose& X_BT, const ChainPositions& x_start) const;
};

}  // namespace hapticell::kinematics
