// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/closure_inverse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::kinematics {

namespace {

// m a rad, so that both errors are lengths; as FitTask::lever of the serial arms. Half: position weighs twice as much
// where both cannot be met; twice: orientation does.
constexpr double kLever = 0.25;
// rad or m: between the best steps for one-sided (1e-8) and central (6e-6) differences, as both use it. Half: more
// rounding; twice: more curvature; both far below what costs a Newton step.
constexpr double kStep = 1e-6;
// m, rad: both errors under it is a solution, as kAccepted of the serial arms. Half, twice: at most one Newton step
// more or less.
constexpr double kReached = 1e-9;
// rad or m between solutions: far over kReached divided by a weak direction, far under two assemblies. Half: one may be
// listed twice near a singularity; twice: no effect unless two nearly meet.
constexpr double kSame = 1e-5;
// Iterations while dragging, that bound the time of a step of the loop; chosen by trial. Half: a new limit may not be
// found in one step of the loop; twice: twice the time where the pose is out of reach.
constexpr int kNearest = 12;
// Iterations of a full solution from a distant start. Chosen by trial. Half: more starts fail and the next of 24 is
// taken; twice: twice the time of starts that fail.
constexpr int kFull = 60;

using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 weighed(const Twist& t) {
  Vector6 e;
  e << t.linear.x, t.linear.y, t.linear.z, kLever * t.angular.x, kLever * t.angular.y, kLever * t.angular.z;
  return e;
}

double halton(std::size_t index, std::size_t base) {
  double value = 0.0, part = 1.0;
  for (; index > 0; index /= base) {
    part /= static_cast<double>(base);
    value += part * static_cast<double>(index % base);
  }
  return value;
}

double distanceBetween(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

}  // namespace

void closureJacobian(const RobotModel& model, const std::vector<double>& q, int link, const Pose& X_LT, Jacobian& J) {
  HAPTICELL_DEMAND(model.closure && link >= 0);
  J.columns = model.dof();
  J.values.assign(6 * J.columns, 0.0);
  std::vector<double> x = q;
  std::vector<Pose> X_BL;
  const auto tip = static_cast<std::size_t>(link);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = q[k] + kStep;
    model.closure->pose(x, X_BL);
    const Pose ahead = X_BL[tip] * X_LT;
    x[k] = q[k] - kStep;
    model.closure->pose(x, X_BL);
    const Twist t = difference(ahead, X_BL[tip] * X_LT);
    x[k] = q[k];
    for (int i = 0; i < 3; ++i) {
      J(static_cast<std::size_t>(i), k) = t.linear[i] / (2.0 * kStep);
      J(static_cast<std::size_t>(i) + 3, k) = t.angular[i] / (2.0 * kStep);
    }
  }
}

Expected<std::unique_ptr<InverseModel>> ClosureInverse::create(const RobotModel& model, int tip_link,
                                                               const Pose& X_LT) {
  HAPTICELL_DEMAND(model.closure && tip_link >= 0 && static_cast<std::size_t>(tip_link) < model.links.size());
  if (tip_link == 0 || model.dof() == 0) {
    return makeError(
        {.place = Text("robot '%1', link '%2'", model.name, model.links[static_cast<std::size_t>(tip_link)].name),
         .found = "no moving joint moves this link",
         .expected = "at least one",
         .fix = "Choose another tip link."});
  }
  return std::unique_ptr<InverseModel>(new ClosureInverse(model, tip_link, X_LT));
}

ClosureInverse::ClosureInverse(const RobotModel& model, int tip_link, const Pose& X_LT)
    : closure_(model.closure), tip_link_(tip_link), X_LT_(X_LT), home_(restPositions(model)) {
  for (std::size_t k = 0; k < model.dof(); ++k) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[k])];
    variables_.push_back(static_cast<int>(k));
    slides_.push_back(joint.type == JointType::kPrismatic);
    velocity_.push_back(greatestSpeed(joint));
    limits_.lower.push_back(joint.lower);
    limits_.upper.push_back(joint.upper);
  }
}

Pose ClosureInverse::tipAt(const std::vector<double>& q) const {
  std::vector<Pose> X_BL;
  closure_->pose(q, X_BL);
  return X_BL[static_cast<std::size_t>(tip_link_)] * X_LT_;
}

bool ClosureInverse::allowed(const std::vector<double>& q, double& least_margin) const {
  std::vector<Pose> X_BL;
  std::vector<ClosureMargin> margins;
  least_margin = 0.0;
  if (!closure_->pose(q, X_BL)) return false;
  closure_->margins(q, margins);
  for (const ClosureMargin& margin : margins) least_margin = std::min(least_margin, margin.value);
  return true;
}

bool ClosureInverse::withinLimits(const std::vector<double>& q) const {
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (q[k] < limits_.lower[k] - kReached || q[k] > limits_.upper[k] + kReached) return false;
  }
  double margin = 0.0;
  return allowed(q, margin) && margin > -1e-9;
}

bool ClosureInverse::withinSpeed(const std::vector<double>& q, const std::vector<double>& q_start,
                                 double duration_s) const {
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (std::abs(q[k] - q_start[k]) > velocity_[k] * duration_s) return false;
  }
  return true;
}

void ClosureInverse::descend(const Pose& X_BT, const Bounds& bounds, int iterations, std::vector<double>& q) const {
  const auto n = static_cast<Eigen::Index>(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = std::clamp(q[k], bounds.lower[k], bounds.upper[k]);
  double margin = 0.0, damping = 1e-8;
  allowed(q, margin);
  Pose X_BTip = tipAt(q);
  Vector6 error = weighed(difference(X_BT, X_BTip));
  Eigen::MatrixXd J(6, n);
  for (int iteration = 0; iteration < iterations && error.norm() > 0.1 * kReached; ++iteration) {
    for (Eigen::Index k = 0; k < n; ++k) {
      std::vector<double> x = q;
      const auto v = static_cast<std::size_t>(k);
      const double h = q[v] + kStep > bounds.upper[v] ? -kStep : kStep;
      x[v] += h;
      J.col(k) = weighed(difference(tipAt(x), X_BTip)) / h;
    }
    Eigen::VectorXd gradient = J.transpose() * error;  // Points downhill.
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto v = static_cast<std::size_t>(k);
      if ((q[v] <= bounds.lower[v] && gradient[k] < 0.0) || (q[v] >= bounds.upper[v] && gradient[k] > 0.0)) {
        J.col(k).setZero();
        gradient[k] = 0.0;
      }
    }
    const Eigen::MatrixXd H = J.transpose() * J;
    const double scale = std::max(1e-12, H.diagonal().maxCoeff());
    bool better = false;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Eigen::MatrixXd damped = H;
      damped.diagonal().array() += damping * scale;
      const Eigen::VectorXd step = damped.ldlt().solve(gradient);
      std::vector<double> trial = q;
      for (std::size_t k = 0; k < q.size(); ++k) {
        const double longest = slides_[k] ? 0.3 : 0.5;
        trial[k] = std::clamp(q[k] + std::clamp(step[static_cast<Eigen::Index>(k)], -longest, longest), bounds.lower[k],
                              bounds.upper[k]);
      }
      double trial_margin = 0.0;
      if (allowed(trial, trial_margin) && trial_margin >= std::min(0.0, margin) - 1e-12) {
        const Pose X_BTrial = tipAt(trial);
        const Vector6 now = weighed(difference(X_BT, X_BTrial));
        if (now.norm() < error.norm()) {
          better = true;
          q = std::move(trial);
          X_BTip = X_BTrial;
          error = now;
          margin = trial_margin;
        }
      }
      damping = better ? std::max(1e-12, damping * 0.1) : std::max(1e-6, damping * 10.0);
    }
    if (!better) break;
  }
}

void ClosureInverse::judge(const Pose& X_BT, const Bounds& bounds, InverseSolution& solution) const {
  const Twist left = difference(X_BT, tipAt(solution.q));
  solution.position_error = glm::length(left.linear);
  solution.orientation_error = glm::length(left.angular);
  const bool solved = solution.position_error < kReached && solution.orientation_error < kReached;
  bool held = false;
  for (std::size_t k = 0; k < solution.q.size(); ++k) {
    held = held || solution.q[k] <= bounds.lower[k] || solution.q[k] >= bounds.upper[k];
  }
  std::vector<ClosureMargin> margins;
  closure_->margins(solution.q, margins);
  solution.singular = false;
  for (const ClosureMargin& margin : margins) {
    if (margin.kind == ClosureMargin::Kind::kSingularity) solution.singular = solution.singular || margin.value < 1e-3;
    held = held || margin.value < 1e-6;
  }
  solution.status = statusOf(solved, held);
}

void ClosureInverse::solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                                  InverseSolution& solution) const {
  Bounds bounds = limits_;
  for (std::size_t k = 0; k < q_start.size(); ++k) {
    const double from = std::clamp(q_start[k], limits_.lower[k], limits_.upper[k]);
    bounds.lower[k] = std::max(bounds.lower[k], from - velocity_[k] * duration_s);
    bounds.upper[k] = std::min(bounds.upper[k], from + velocity_[k] * duration_s);
  }
  solution.q = q_start;
  descend(X_BT, bounds, kNearest, solution.q);
  judge(X_BT, bounds, solution);
}

InverseSolution ClosureInverse::solve(const Pose& X_BT, const std::vector<double>& q_start) const {
  InverseSolution best;
  best.q = q_start;
  descend(X_BT, limits_, kFull, best.q);
  judge(X_BT, limits_, best);
  constexpr std::size_t kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  for (std::size_t attempt = 0; attempt < 24 && best.status != InverseStatus::kSolved; ++attempt) {
    InverseSolution other;
    other.q = home_;
    for (std::size_t k = 0; attempt > 0 && k < other.q.size(); ++k) {
      const double low = std::max(limits_.lower[k], home_[k] - std::numbers::pi);
      const double high = std::min(limits_.upper[k], home_[k] + std::numbers::pi);
      other.q[k] = low + (high - low) * halton(attempt, kPrimes[k % 16]);
    }
    double margin = 0.0;
    if (!allowed(other.q, margin)) continue;
    descend(X_BT, limits_, kFull, other.q);
    judge(X_BT, limits_, other);
    if (other.position_error + kLever * other.orientation_error < best.position_error + kLever * best.orientation_error)
      best = other;
  }
  return best;
}

std::vector<AlternativeSolution> ClosureInverse::solveAll(const Pose& X_BT, const std::vector<double>& q_start) const {
  std::vector<AlternativeSolution> found;
  constexpr std::size_t kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  for (std::size_t attempt = 0; attempt < 24; ++attempt) {
    InverseSolution one;
    one.q = attempt == 0 ? q_start : home_;
    for (std::size_t k = 0; attempt > 1 && k < one.q.size(); ++k) {
      const double low = std::max(limits_.lower[k], home_[k] - std::numbers::pi);
      const double high = std::min(limits_.upper[k], home_[k] + std::numbers::pi);
      one.q[k] = low + (high - low) * halton(attempt, kPrimes[k % 16]);
    }
    double margin = 0.0;
    if (!allowed(one.q, margin)) continue;
    descend(X_BT, limits_, kFull, one.q);
    judge(X_BT, limits_, one);
    if (one.status != InverseStatus::kSolved) continue;
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const auto& other) { return distanceBetween(other.q, one.q) < kSame; });
    if (!known) found.push_back({one.q, withinLimits(one.q), ""});
  }
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return distanceBetween(a.q, q_start) < distanceBetween(b.q, q_start);
  });
  return found;
}

}  // namespace hapticell::kinematics
