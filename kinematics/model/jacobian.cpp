// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/jacobian.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::kinematics {

namespace {

using RowMajor6X = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
using RowMajorX6 = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The variable that drives a joint (-1 for none) and how many times it counts.
struct Drive {
  int variable = -1;
  double factor = 1.0;
};

Drive driveOf(const RobotModel& model, const Joint& joint) {
  if (joint.type == JointType::kFixed) return {};
  if (joint.variable >= 0) return {joint.variable, 1.0};
  if (!joint.mimic) return {};
  return {model.joints[static_cast<std::size_t>(joint.mimic->joint)].variable, joint.mimic->multiplier};
}

Vector6 rowScale(double lever_m) {
  Vector6 scale;
  scale << 1.0 / lever_m, 1.0 / lever_m, 1.0 / lever_m, 1.0, 1.0, 1.0;
  return scale;
}

/// Squared singular values, ascending, of the scaled Jacobian: the eigenvalues of J Jᵀ, of which the last n count.
Vector6 squaredSingularValues(const Matrix6& JJt) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(JJt, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseMax(0.0);
}

int movingColumns(const Jacobian& J) {
  int count = 0;
  for (std::size_t column = 0; column < J.columns; ++column) {
    bool moves = false;
    for (std::size_t row = 0; row < 6; ++row) moves = moves || J(row, column) != 0.0;
    count += moves ? 1 : 0;
  }
  return std::min(count, 6);
}

}  // namespace

std::vector<int> chainToTip(const RobotModel& model, int link) {
  HAPTICELL_DEMAND(link >= 0 && static_cast<std::size_t>(link) < model.links.size());
  std::vector<int> chain;
  for (int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;) {
    chain.push_back(joint);
    joint =
        model.links[static_cast<std::size_t>(model.joints[static_cast<std::size_t>(joint)].parent_link)].parent_joint;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::vector<int> variablesOfChain(const RobotModel& model, int link) {
  std::vector<int> variables;
  if (model.closure && link > 0) {  // Every drive moves every link of a closed loop, or may.
    for (std::size_t i = 0; i < model.dof(); ++i) variables.push_back(static_cast<int>(i));
    return variables;
  }
  for (const int joint : chainToTip(model, link)) {
    const int variable = driveOf(model, model.joints[static_cast<std::size_t>(joint)]).variable;
    if (variable >= 0 && std::find(variables.begin(), variables.end(), variable) == variables.end())
      variables.push_back(variable);
  }
  return variables;
}

void geometricJacobian(const RobotModel& model, const std::vector<Pose>& X_BL, int link, const dvec3& p_BQ,
                       Jacobian& J) {
  HAPTICELL_DEMAND(X_BL.size() == model.links.size() && link >= 0 &&
                   static_cast<std::size_t>(link) < model.links.size());
  J.columns = model.dof();
  J.values.assign(6 * J.columns, 0.0);
  HAPTICELL_DEMAND(!model.closure);  // closureJacobian() knows the joint positions that this needs.
  for (int index = model.links[static_cast<std::size_t>(link)].parent_joint; index >= 0;) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const Drive drive = driveOf(model, joint);
    if (drive.variable >= 0) {
      // The joint's motion leaves its own axis and origin where they are, so the child link's frame serves for both.
      const Pose& X_BJ = X_BL[static_cast<std::size_t>(joint.child_link)];
      const dvec3 axis = drive.factor * X_BJ.rotate(joint.axis_J);
      const bool prismatic = joint.type == JointType::kPrismatic;
      const dvec3 linear = prismatic ? axis : glm::cross(axis, p_BQ - X_BJ.p);
      for (int i = 0; i < 3; ++i) {
        J(static_cast<std::size_t>(i), static_cast<std::size_t>(drive.variable)) += linear[i];
        if (!prismatic) J(static_cast<std::size_t>(i) + 3, static_cast<std::size_t>(drive.variable)) += axis[i];
      }
    }
    index = model.links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
  }
}

Manipulability manipulability(const Jacobian& J, double lever_m) {
  const int rank = movingColumns(J);
  if (rank == 0) return {};
  const Eigen::Map<const RowMajor6X> raw(J.values.data(), 6, static_cast<Eigen::Index>(J.columns));
  const Matrix6 JJt = rowScale(lever_m).asDiagonal() * (raw * raw.transpose()) * rowScale(lever_m).asDiagonal();
  const Vector6 squared = squaredSingularValues(JJt);
  Manipulability result{std::sqrt(squared[6 - rank]), std::sqrt(squared[5]), 1.0};
  for (int i = 6 - rank; i < 6; ++i) result.measure *= std::sqrt(squared[i]);
  return result;
}

void dampedPseudoInverse(const Jacobian& J, double lever_m, double threshold, InverseJacobian& out) {
  out.rows = J.columns;
  out.values.assign(6 * J.columns, 0.0);
  const int rank = movingColumns(J);
  if (rank == 0) return;
  const Eigen::Map<const RowMajor6X> raw(J.values.data(), 6, static_cast<Eigen::Index>(J.columns));
  const Vector6 scale = rowScale(lever_m);
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(scale.asDiagonal() * (raw * raw.transpose()) *
                                                      scale.asDiagonal());
  const Vector6 squared = solver.eigenvalues().cwiseMax(0.0);
  const double ratio = std::min(1.0, std::sqrt(squared[6 - rank]) / threshold);
  const double damping = threshold * threshold * (1.0 - ratio * ratio);
  // Directions no variable reaches (a chain of fewer than six) have no inverse; the rest of J+ = Jᵀ U diag U ᵀ.
  Vector6 inverse = Vector6::Zero();
  for (int i = 6 - rank; i < 6; ++i) inverse[i] = squared[i] + damping > 0.0 ? 1.0 / (squared[i] + damping) : 0.0;
  const Matrix6& U = solver.eigenvectors();
  Eigen::Map<RowMajorX6> result(out.values.data(), static_cast<Eigen::Index>(J.columns), 6);
  result.noalias() =
      raw.transpose() * (scale.asDiagonal() * (U * inverse.asDiagonal() * U.transpose()) * scale.asDiagonal());
}

std::vector<LimitDistance> limitDistances(const RobotModel& model, const std::vector<double>& q) {
  HAPTICELL_DEMAND(q.size() == model.dof());
  std::vector<LimitDistance> distances(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    distances[i] = {q[i] - joint.lower, joint.upper - q[i]};
  }
  return distances;
}

}  // namespace hapticell::kinematics
