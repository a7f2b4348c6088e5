// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "kinematics/closed_form/closed_form.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/configuration_flags.h"
#include "kinematics/model/robot_class.h"
#include "kinematics/numeric/numeric_inverse.h"

namespace hapticell::kinematics {

/// The inverse model of a chain that classify() recognises: all solutions from the closed form of its class, each
/// checked on the true chain (and refined on it if the arm is only close to its class). The numeric model is used if
/// the pose is out of reach, if joints are too slow, and for variables that the closed form leaves free.
///
/// Leading slides and a seventh joint give infinitely many solutions: solve() finds the nearest one over all of them;
/// solveAll() lists a sample that begins with the present values of the free parameters. If no place of the sample is
/// within the limits, it searches as solve() does and adds what it finds. Const functions keep no state.
class AnalyticInverse final : public InverseModel {
 public:
  /// `classification` must not be kNumeric; `numeric` is for the same chain.
  AnalyticInverse(std::unique_ptr<NumericInverse> numeric, const Classification& classification,
                  const InverseOptions& options, std::size_t model_dof);

  std::string name() const override { return describe(classification_); }
  const Chain* chain() const override { return numeric_->chain(); }
  const std::vector<int>& variables() const override { return numeric_->variables(); }
  void solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                    InverseSolution& solution) const override;
  InverseSolution solve(const Pose& X_BT, const std::vector<double>& q_start) const override;
  std::vector<AlternativeSolution> solveAll(const Pose& X_BT, const std::vector<double>& q_start) const override;

 private:
  /// Positions of the slides, then the free parameter of the arm.
  using Free = std::array<double, kMaxChainVariables>;
  struct Found {
    ChainPositions x{};
    bool within = false;
    double distance_squared = 0.0;  ///< Distance from the start.
  };
  struct Best {
    ChainPositions x{};
    double distance_squared = 0.0;
    Free place{};
    bool any = false;      ///< Within limits.
    bool outside = false;  ///< A solution outside the limits was found.
    bool free = false;     ///< A singular solution outside the limits was found.
  };

  std::unique_ptr<NumericInverse> numeric_;
  Classification classification_;
  InverseOptions options_;
  std::size_t model_dof_;
  std::size_t rails_ = 0;  ///< Slides that the closed form does not handle.
  std::array<dvec3, kMaxChainVariables> rail_B_;
  std::unique_ptr<const ClosedForm> closed_;
  kernels::JointBounds bounds_{};
  kernels::TrueArm arm_{};  ///< Without the rails.
  ArmShapes shapes_;
  /// m and rad: the largest error of the closed form on the true chain, over a sample of poses.
  double proven_error_ = 1.0;

  std::size_t freeCount() const { return rails_ + static_cast<std::size_t>(closed_->redundancy()); }
  double sampleError() const;
  ChainPositions pick(const std::vector<double>& q) const;
  Free freeAt(const Pose& X_BT, const ChainPositions& x) const;
  void freeRange(std::size_t index, double& lower, double& upper) const;
  kernels::Choice evaluate(const Pose& X_BT, const Free& free, const ChainPositions& x_start, bool check,
                           kernels::Solutions& solutions) const;
  void check(const Pose& X_BT, const dvec3& p_BT, kernels::Solutions& solutions) const;
  ChainPositions assemble(const Free& free, const kernels::Solutions& solutions, int slot) const;
  void collect(const Pose& X_BT, const Free& free, const ChainPositions& x_start, std::vector<Found>& all) const;
  void consider(const Pose& X_BT, const Free& free, const ChainPositions& x_start, Best& best) const;
  void take(const Free& free, const kernels::Solutions& solutions, const kernels::Choice& choice,
            const ChainPositions& x_start, Best& best) const;
  bool considerRing(const Pose& X_BT, const ChainPositions& x_start, Best& best) const;
  void searchFree(const Pose& X_BT, const ChainPositions& x_start, Best& best) const;
  double leastExcess(const kernels::Solutions& solutions) const;
  void addBetweenSamples(const Pose& X_BT, const ChainPositions& x_start, const std::vector<double>& q_start,
                         std::vector<Found>& all) const;
  std::vector<AlternativeSolution> listed(const std::vector<Found>& all, const std::vector<double>& q_start) const;
  Best searchPlain(const Pose& X_BT, const ChainPositions& x_start) const;
  void fill(const Pose& X_BT, const ChainPositions& x, const std::vector<double>& q_start,
            InverseSolution& solution) const;
  bool quickAnswer(const Pose& X_BT, const std::vector<double>& q_start, double duration_s, InverseSolution& solution,
                   bool& too_fast) const;
};

}  // namespace hapticell::kinematics
