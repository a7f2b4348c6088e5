// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// The greatest number of variables of a chain, for arrays without allocation in the loop: an arm of 7 on 6 external
/// axes fits. More are refused with a message. Half: that example is refused; twice: more state to copy.
inline constexpr std::size_t kMaxChainVariables = 16;
/// The greatest number of moving joints of a chain, including mimic joints: half as many again as variables. More are
/// refused with a message. Half: fewer than the variables; twice: more state to copy.
inline constexpr std::size_t kMaxChainJoints = 24;

/// Positions of a chain's variables, base to tip; the first `Chain::size()` numbers count.
using ChainPositions = std::array<double, kMaxChainVariables>;

/// Poses of the joints and the tip of a chain, in the root link's frame B.
struct ChainState {
  dmat3 R_BT{1.0};
  dvec3 p_BT{0.0};
  std::array<dvec3, kMaxChainJoints> axis_B;
  std::array<dvec3, kMaxChainJoints> origin_B;
};

/// The joints between the root and a tip, with fixed joints merged into their neighbours, for repeated evaluation by
/// inverse models.
///
/// A value; evaluation uses no heap and is thread-safe.
class Chain {
 public:
  /// A joint that moves the tip; a mimic joint names the variable that it follows.
  struct Element {
    dmat3 R_PJ{1.0};  ///< From the element before (or the root).
    dvec3 p_PJ{0.0};
    dvec3 axis_J{0.0, 0.0, 1.0};
    bool prismatic = false;
    int variable = 0;  ///< Of the chain.
    double factor = 1.0;
    double offset = 0.0;
  };

  /// The chain to `tip_link` and the tool centre point X_LT on it. Errors: nothing moves the tip, or there are more
  /// than 16 variables or 24 moving joints.
  static Expected<Chain> create(const RobotModel& model, int tip_link, const Pose& X_LT);

  std::size_t size() const { return variables_.size(); }
  const std::vector<Element>& elements() const { return elements_; }
  const std::vector<int>& variables() const { return variables_; }  ///< Of the model, base to tip.
  const ChainPositions& lower() const { return lower_; }
  const ChainPositions& upper() const { return upper_; }
  const ChainPositions& velocity() const { return velocity_; }  ///< If the file gives none: 1 m/s, pi rad/s.
  /// True if a full turn of the variable changes nothing at the tip.
  bool turns(std::size_t variable) const { return turns_[variable]; }
  /// An upper bound (m) of the tip's distance from the first joint's origin.
  double reach() const { return reach_; }  ///< Infinite if there is a slide without limits.
  /// A length (m) of the chain that scales errors: reach(), with 1 m for each slide without limits.
  double scale() const { return scale_; }

  void evaluate(const ChainPositions& x, ChainState& state) const;

  /// From the last element to the tip.
  const dmat3& R_LT() const { return R_LT_; }
  const dvec3& p_LT() const { return p_LT_; }

 private:
  std::vector<Element> elements_;
  std::vector<int> variables_;
  ChainPositions lower_{}, upper_{}, velocity_{};
  std::array<bool, kMaxChainVariables> turns_{};
  dmat3 R_LT_{1.0};  ///< From the last element to the tip.
  dvec3 p_LT_{0.0};
  double reach_ = 0.0, scale_ = 0.0;

  void addElement(const RobotModel& model, const Joint& joint, const Pose& X_PJ);
  void setReach();
};

}  // namespace hapticell::kinematics
