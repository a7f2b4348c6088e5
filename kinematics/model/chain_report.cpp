// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/chain_report.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "kinematics/model/configuration_flags.h"

namespace hapticell::kinematics {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Jacobian6 = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, static_cast<int>(kMaxChainVariables)>;

// Sine of the angle between two axes, ten thousand times the rounding of files (1e-10). Half, twice: no effect unless
// an arm is calibrated, and that has no exact boundary anyway.
constexpr double kParallelAxes = 1e-6;
// m, between two axes; as kParallelAxes at 1 m. Half, twice: the same.
constexpr double kMeetingAxes = 1e-6;

Jacobian6 scaledJacobian(const Chain& chain, const ChainPositions& x) {
  ChainState state;
  chain.evaluate(x, state);
  Jacobian6 J = Jacobian6::Zero(6, static_cast<Eigen::Index>(chain.size()));
  const double scale = 2.0 / std::max(chain.scale(), 1e-6);
  for (std::size_t i = 0; i < chain.elements().size(); ++i) {
    const Chain::Element& element = chain.elements()[i];
    const dvec3& z = state.axis_B[i];
    const dvec3 linear =
        scale * element.factor * (element.prismatic ? z : glm::cross(z, state.p_BT - state.origin_B[i]));
    for (int row = 0; row < 3; ++row) {
      J(row, element.variable) += linear[row];
      if (!element.prismatic) J(row + 3, element.variable) += element.factor * z[row];
    }
  }
  return J;
}

// The point where axes 4, 5 and 6 meet, if they do.
std::optional<dvec3> wristCentre(const ChainState& state) {
  const dvec3 &o4 = state.origin_B[3], &z4 = state.axis_B[3], &o5 = state.origin_B[4], &z5 = state.axis_B[4];
  const dvec3 normal = glm::cross(z4, z5);
  const double squared = glm::dot(normal, normal);
  if (squared < kParallelAxes) return std::nullopt;
  const double along4 = glm::dot(glm::cross(o5 - o4, z5), normal) / squared;
  const dvec3 centre = o4 + along4 * z4;
  const auto distanceFrom = [&](std::size_t axis) {
    return glm::length(glm::cross(centre - state.origin_B[axis], state.axis_B[axis]));
  };
  if (distanceFrom(4) > kMeetingAxes || distanceFrom(5) > kMeetingAxes) return std::nullopt;
  return centre;
}

bool sixRevolutes(const Chain& chain) {
  return chain.size() == 6 && chain.elements().size() == 6 &&
         std::none_of(chain.elements().begin(), chain.elements().end(),
                      [](const Chain::Element& e) { return e.prismatic; });
}

}  // namespace

bool chainIsSingular(const Chain& chain, const ChainPositions& x) {
  const Jacobian6 J = scaledJacobian(chain, x);
  const Matrix6 JJt = J * J.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(JJt, Eigen::EigenvaluesOnly);
  const int rank = static_cast<int>(std::min<std::size_t>(chain.size(), 6));
  return solver.eigenvalues()[6 - rank] < 1e-6;
}

bool armIsDeficient(const Chain& chain, std::size_t rails) {
  // Postures tried; each of full rank with probability 1 for an arm of full rank, so few are enough. Half, twice: time
  // only.
  constexpr int kPlaces = 12;
  // Eigenvalue of J J^T at every place: rounding makes 1e-15, an arm of full rank has some far above. Half, twice: no
  // arm is between.
  constexpr double kLeast = 1e-9;
  for (int place = 0; place < kPlaces; ++place) {
    ChainPositions x{};
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const double share = 0.5 + place * (std::numbers::phi - 1.0) * static_cast<double>(i + 1);
      x[i] = 2.0 * std::numbers::pi * (share - std::floor(share) - 0.5) + 0.3 * static_cast<double>(i + 1);
    }
    const Jacobian6 J = scaledJacobian(chain, x);
    const Jacobian6 arm = J.rightCols(static_cast<Eigen::Index>(chain.size() - rails));
    const Matrix6 JJt = arm * arm.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(JJt, Eigen::EigenvaluesOnly);
    if (solver.eigenvalues()[0] > kLeast) return false;
  }
  return true;
}

std::string configurationName(const Chain& chain, const ChainPositions& x) {
  const std::optional<ArmShape> shape = armShape(chain, x);
  return shape ? toString(*shape) : std::string();
}

std::optional<Elbow> findElbow(const Chain& chain) {
  if (!sixRevolutes(chain)) return std::nullopt;
  const ChainPositions zero{};
  ChainState state;
  chain.evaluate(zero, state);
  const dvec3& axis = state.axis_B[2];
  if (glm::length(glm::cross(state.axis_B[1], axis)) > kParallelAxes) return std::nullopt;
  std::optional<dvec3> wrist = wristCentre(state);
  if (!wrist && glm::length(glm::cross(state.axis_B[3], axis)) <= kParallelAxes) wrist = state.origin_B[3];
  if (!wrist || chain.elements()[2].factor != 1.0) return std::nullopt;
  const auto across = [&](const dvec3& v) { return v - glm::dot(v, axis) * axis; };
  const dvec3 upper_arm = across(state.origin_B[2] - state.origin_B[1]), forearm = across(*wrist - state.origin_B[2]);
  if (glm::length(upper_arm) < kMeetingAxes || glm::length(forearm) < kMeetingAxes) return std::nullopt;
  // Joint 3 turns the forearm by its own angle, so the angle between the two arms is zero at minus the one at zero.
  const double bend = std::atan2(glm::dot(axis, glm::cross(upper_arm, forearm)), glm::dot(upper_arm, forearm));
  return Elbow{2, -bend};
}

}  // namespace hapticell::kinematics
