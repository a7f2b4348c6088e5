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
/// If a pose cannot be met, position weighs 1 and orientation is converted by a lever of 0.25 m unless set otherwise: 1
/// rad counts like 250 mm. A longer lever keeps the orientation and gives up position, a shorter one the reverse.
/// Restarts begin at 1024 Halton points within the limits, those nearest to the requested pose first; they are always
/// the same, so answers are reproducible. Const methods keep no state and are thread-safe.
class NumericInverse final : public InverseModel {
 public:
  /// For the tool centre point X_LT on `tip_link` of `model`. The model is read, not kept. Errors: see Chain::create(),
  /// and an invalid pose of the tool.
  static Expected<std::unique_ptr<NumericInverse>> create(const RobotModel& model, int tip_link, const Pose& X_LT = {},
                                                          double lever_m = 0.25);

  std::string name() const override { return "numeric"; }
  const Chain* chain() const override { return &chain_; }
  const std::vector<int>& variables() const override { return chain_.variables(); }
  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override;

  /// The behaviour of a step if only the speeds of the joints prevent the pose (a wrist that would have to turn
  /// quickly).
  struct Hurried {
    /// What is kept (the position within 0.2 mm or the orientation within 0.2 mrad) while the other lags; if it cannot
    /// be kept, both lag by their weights.
    enum class Keep { kPosition, kOrientation };
    Keep keep = Keep::kPosition;
    int held = -1;  ///< A variable of the chain that does not move, or -1.
  };
  /// For solveNearest(); to be called before the model is used.
  void setHurried(const Hurried& hurried) { hurried_ = hurried; }
  /// solveNearest() for a pose that only speeds prevent: first tries to keep what must be kept.
  void solveHurried(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const;

  /// The pose of least error from `q_start` at any distance, within the limits; no restarts.
  InverseSolution nearestMiss(const Pose& X_BT, const std::vector<double>& q_start) const;

  /// Any solution within limits, with the start tried first if it is near: as solve(), but it returns the first
  /// solution found and does not check for singularity.
  InverseSolution solveAny(const Pose& X_BT, const std::vector<double>& q_start) const;

  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override;
  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const override;

 private:
  struct Seed {
    ChainPositions x{};
    Pose X_BT;
  };

  Chain chain_;
  std::optional<kernels::TrueArm> arm_;  ///< For the fast descent, if the chain allows it.
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
