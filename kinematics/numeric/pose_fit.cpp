// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/pose_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hapticell::kinematics {

namespace {

constexpr int kMax = static_cast<int>(kMaxChainVariables);
// m and rad; as kFitTolerance of fit_lanes.h, the same descent for four arms, where half and twice are given.
constexpr double kTolerance = 2e-10;
// rad or m; as kLargestFitStep of fit_lanes.h.
constexpr double kLargestStep = 0.7;

// Of the matrix's largest entry; as kLeastFitDamping of fit_lanes.h.
constexpr double kLeastDamping = 1e-13;

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMax, kMax>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMax, 1>;

struct Residual {
  dvec3 position{0.0};
  dvec3 rotation{0.0};
  double cost = 0.0;
};

class Descent {
 public:
  Descent(const Chain& chain, const Pose& X_BT, const FitBox& box, const FitOptions& options)
      : chain_(chain),
        target_(X_BT),
        R_target_(X_BT.R()),
        box_(box),
        options_(options),
        n_(static_cast<Eigen::Index>(chain.size())) {}

  FitResult run(const ChainPositions& x_start);

 private:
  const Chain& chain_;
  const Pose& target_;
  const dmat3 R_target_;
  const FitBox& box_;
  const FitOptions& options_;
  const Eigen::Index n_;
  ChainPositions x_{};
  ChainState state_;
  Residual residual_;
  std::array<dvec3, kMaxChainJoints> linear_;
  Square gauss_newton_, hessian_;
  Column gradient_, step_;  // the gradient points downhill
  std::array<bool, kMaxChainVariables> fixed_{};
  double lambda_ = 0.0, growth_ = 4.0;
  bool curved_ = false;

  Residual residualOf(const ChainState& state) const;
  void linearise();
  void addCurvature();
  bool solveStep(const Square& H);
  double gain(const Square& H) const;
  bool fixBlocked();
  bool tryStep(double predicted);
  bool solved() const {
    return glm::length(residual_.position) < kTolerance && glm::length(residual_.rotation) < kTolerance;
  }
};

// The rotation vector of a matrix; near half a turn through its symmetric part, where the sine alone says nothing.
dvec3 rotationVectorOf(const dmat3& R) {
  const dvec3 sine = 0.5 * dvec3(R[1][2] - R[2][1], R[2][0] - R[0][2], R[0][1] - R[1][0]);
  const double cosine = 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0);
  const double length = glm::length(sine);
  if (cosine > -0.9) return length < 1e-12 ? sine : sine * (std::atan2(length, cosine) / length);
  return rotationVector(glm::normalize(glm::quat_cast(R)));
}

Residual Descent::residualOf(const ChainState& state) const {
  Residual residual{target_.p - state.p_BT, rotationVectorOf(R_target_ * glm::transpose(state.R_BT)), 0.0};
  residual.cost = 0.5 * (glm::dot(residual.position, residual.position) +
                         options_.lever * options_.lever * glm::dot(residual.rotation, residual.rotation));
  return residual;
}

void Descent::linearise() {
  const auto& elements = chain_.elements();
  const double weight = options_.lever * options_.lever;
  gauss_newton_.setZero(n_, n_);
  gradient_.setZero(n_);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const dvec3& z = state_.axis_B[i];
    linear_[i] = elements[i].prismatic ? z : glm::cross(z, state_.p_BT - state_.origin_B[i]);
    const int column = elements[i].variable;
    const double turning = elements[i].prismatic ? 0.0 : weight;
    gradient_[column] +=
        elements[i].factor * (glm::dot(linear_[i], residual_.position) + turning * glm::dot(z, residual_.rotation));
    for (std::size_t j = 0; j <= i; ++j) {
      const double both = elements[j].prismatic ? 0.0 : turning;
      const double value = elements[i].factor * elements[j].factor *
                           (glm::dot(linear_[i], linear_[j]) + both * glm::dot(z, state_.axis_B[j]));
      gauss_newton_(column, elements[j].variable) += value;
      if (j != i) gauss_newton_(elements[j].variable, column) += value;
    }
  }
}

// The residual's own second derivatives: position through z_j x J_i (j nearer to the base), orientation through the
// derivative of the logarithm on SO(3).
void Descent::addCurvature() {
  const auto& elements = chain_.elements();
  const double weight = options_.lever * options_.lever;
  const double angle = glm::length(residual_.rotation);
  const double a = angle < 1e-4 ? 1.0 - angle * angle / 12.0 : 0.5 * angle / std::tan(0.5 * angle);
  const dvec3 direction = angle < 1e-12 ? dvec3(0.0) : residual_.rotation / angle;
  hessian_ = gauss_newton_;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const dvec3& z_i = state_.axis_B[i];
    for (std::size_t j = 0; j <= i; ++j) {
      if (elements[j].prismatic) continue;  // moves the axes behind it, turns none
      const dvec3& z_j = state_.axis_B[j];
      double value = -glm::dot(glm::cross(residual_.position, z_j), linear_[i]);
      if (!elements[i].prismatic) {
        value += weight * ((1.0 - a) * (glm::dot(direction, z_i) * glm::dot(direction, z_j) - glm::dot(z_i, z_j)) -
                           0.5 * glm::dot(residual_.rotation, glm::cross(z_j, z_i)));
      }
      value *= elements[i].factor * elements[j].factor;
      hessian_(elements[i].variable, elements[j].variable) += value;
      if (j != i) hessian_(elements[j].variable, elements[i].variable) += value;
    }
  }
}

// Solves (H + lambda I) step = gradient inside the box; false when the free part is not positive definite.
bool Descent::solveStep(const Square& H) {
  std::array<bool, kMaxChainVariables> bound = fixed_;
  step_.setZero(n_);
  for (Eigen::Index round = 0; round <= n_; ++round) {
    std::array<Eigen::Index, kMaxChainVariables> free{};
    Eigen::Index count = 0;
    for (Eigen::Index i = 0; i < n_; ++i) {
      if (!bound[static_cast<std::size_t>(i)]) free[static_cast<std::size_t>(count++)] = i;
    }
    if (count == 0) return true;
    Square reduced(count, count);
    Column right(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      const Eigen::Index row = free[static_cast<std::size_t>(r)];
      right[r] = gradient_[row];
      for (Eigen::Index i = 0; i < n_; ++i) {
        if (bound[static_cast<std::size_t>(i)]) right[r] -= H(row, i) * step_[i];
      }
      for (Eigen::Index c = 0; c < count; ++c) reduced(r, c) = H(row, free[static_cast<std::size_t>(c)]);
      reduced(r, r) += lambda_;
    }
    const Eigen::LLT<Square> cholesky(reduced);
    if (cholesky.info() != Eigen::Success) return false;
    cholesky.solveInPlace(right);
    bool crossed = false;
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto i = static_cast<std::size_t>(free[static_cast<std::size_t>(r)]);
      const double room_up = box_.upper[i] - x_[i], room_down = box_.lower[i] - x_[i];
      const double wanted = right[r];
      step_[static_cast<Eigen::Index>(i)] = std::clamp(wanted, room_down, room_up);
      if (wanted > room_up || wanted < room_down) bound[i] = crossed = true;
    }
    if (!crossed) return true;
  }
  return true;
}

double Descent::gain(const Square& H) const {
  return gradient_.dot(step_) - 0.5 * step_.dot(H * step_);
}

// Fixes what stands on a bound and is pushed out; false when nothing is left that could gain.
bool Descent::fixBlocked() {
  double steepest = 0.0;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const double slope = gradient_[static_cast<Eigen::Index>(i)];
    fixed_[i] = (x_[i] <= box_.lower[i] && slope < 0.0) || (x_[i] >= box_.upper[i] && slope > 0.0);
    if (!fixed_[i]) steepest = std::max(steepest, std::abs(slope));
  }
  return steepest > 1e-13 * std::max(1.0, chain_.scale()) * std::sqrt(2.0 * residual_.cost);
}

bool Descent::tryStep(double predicted) {
  ChainPositions moved = x_;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    moved[i] = std::clamp(x_[i] + step_[static_cast<Eigen::Index>(i)], box_.lower[i], box_.upper[i]);
  }
  ChainState state;
  chain_.evaluate(moved, state);
  const Residual residual = residualOf(state);
  if (!(residual.cost < residual_.cost) || !(predicted > 0.0)) {
    lambda_ = std::max(lambda_, 1e-9 * gauss_newton_.diagonal().maxCoeff()) * growth_;
    growth_ *= 2.0;
    return false;
  }
  const double ratio = (residual_.cost - residual.cost) / predicted;
  curved_ = options_.second_order && residual.cost > 0.2 * residual_.cost;
  lambda_ *= std::max(0.125, 1.0 - std::pow(2.0 * ratio - 1.0, 3));
  if (ratio > 0.9) lambda_ = std::min(lambda_, 1e-3 * residual.cost);
  growth_ = 4.0;
  x_ = moved;
  state_ = state;
  residual_ = residual;
  return true;
}

FitResult Descent::run(const ChainPositions& x_start) {
  for (std::size_t i = 0; i < chain_.size(); ++i) x_[i] = std::clamp(x_start[i], box_.lower[i], box_.upper[i]);
  chain_.evaluate(x_, state_);
  residual_ = residualOf(state_);
  lambda_ = 1e-3 * residual_.cost;
  FitResult result;
  int slow = 0;
  bool fresh = true;
  bool free = true;
  while (!solved() && result.iterations < options_.max_iterations) {
    if (fresh) {
      linearise();
      free = fixBlocked();
      if (!free) break;
      if (curved_) addCurvature();
    }
    ++result.iterations;
    // A redundant or singular chain has a JᵀJ without inverse; this much damping costs no speed of convergence.
    lambda_ = std::max(lambda_, kLeastDamping * gauss_newton_.diagonal().maxCoeff());
    const Square* H = curved_ ? &hessian_ : &gauss_newton_;
    if (!solveStep(*H)) {
      H = &gauss_newton_;
      if (!solveStep(*H)) {
        lambda_ *= 16.0;
        fresh = false;
        continue;
      }
    }
    const double largest = step_.cwiseAbs().maxCoeff();
    if (largest < 1e-14) break;
    if (largest > kLargestStep) step_ *= kLargestStep / largest;
    const double before = residual_.cost;
    fresh = tryStep(gain(*H));
    if (!fresh && largest < 1e-10) break;
    if (fresh) slow = residual_.cost > 0.6 * before ? slow + 1 : 0;
    if (options_.give_up_when_slow && slow >= 4) break;
  }
  result.x = x_;
  result.position_error = glm::length(residual_.position);
  result.orientation_error = glm::length(residual_.rotation);
  result.converged = result.position_error < 1e-9 && result.orientation_error < 1e-9;
  if (!result.converged) {
    for (std::size_t i = 0; i < chain_.size(); ++i) result.held = result.held || fixed_[i];
  }
  return result;
}

FitResult fitArm(const kernels::TrueArm& arm, const Pose& X_BT, const ChainPositions& x_start, const FitBox& box,
                 const FitOptions& options) {
  kernels::FitTask task;
  const dmat3 R = X_BT.R();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) task.R[3 * row + column] = R[column][row];
    task.p[row] = X_BT.p[row];
  }
  for (int i = 0; i < arm.joints; ++i) {
    const auto k = static_cast<std::size_t>(i);
    task.lower[i] = box.lower[k];
    task.upper[i] = box.upper[k];
    task.start[i] = x_start[k];
  }
  task.lever = options.lever;
  task.max_iterations = options.max_iterations;
  task.second_order = options.second_order;
  task.give_up_when_slow = options.give_up_when_slow;
  kernels::FitAnswer answer;
  kernels::table().fit(arm, task, answer);
  FitResult result;
  std::copy(answer.x, answer.x + arm.joints, result.x.begin());
  result.position_error = answer.position_error;
  result.orientation_error = answer.orientation_error;
  result.converged = answer.position_error < 1e-9 && answer.orientation_error < 1e-9;
  result.held = !result.converged && answer.held;
  result.iterations = answer.iterations;
  return result;
}

}  // namespace

FitResult fitPose(const Chain& chain, const Pose& X_BT, const ChainPositions& x_start, const FitBox& box,
                  const FitOptions& options, const kernels::TrueArm* arm) {
  if (arm != nullptr) return fitArm(*arm, X_BT, x_start, box, options);
  return Descent(chain, X_BT, box, options).run(x_start);
}

}  // namespace hapticell::kinematics
