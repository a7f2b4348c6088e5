// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/closure_jets.h"

#include "geometry/system/assertion.h"

namespace hapticell::manipulation {

namespace {

/// rad or m of a difference: its error (1e-8) is as small as rounding in second order (1e-16 / 1e-8). Half: four times
/// the rounding in curvatures; twice: four times the error.
constexpr double kStep = 1e-4;

using Twists = std::vector<Twist>;

/// What the links do when the variables move by `dq`.
class Mover {
 public:
  Mover(const kinematics::RobotModel& model, const std::vector<double>& q, const Pose& X_WB)
      : model_(model), q_(q), X_WB_(X_WB), here_(posesAt(q)) {}

  const std::vector<Pose>& here() const { return here_; }

  Twists moved(std::size_t i, double di, std::size_t j, double dj) const {
    std::vector<double> q = q_;
    q[i] += di;
    q[j] += dj;
    const std::vector<Pose> there = posesAt(q);
    Twists twists(there.size());
    for (std::size_t k = 0; k < there.size(); ++k) twists[k] = difference(there[k], here_[k]);
    return twists;
  }

 private:
  std::vector<Pose> posesAt(const std::vector<double>& q) const {
    std::vector<Pose> X_WL;
    model_.closure->pose(q, X_WL);
    for (Pose& pose : X_WL) pose = X_WB_ * pose;
    return X_WL;
  }

  const kinematics::RobotModel& model_;
  const std::vector<double>& q_;
  const Pose X_WB_;
  const std::vector<Pose> here_;
};

Twist sum(const Twist& a, const Twist& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}

Twist scaled(const Twist& t, double s) {
  return {t.linear * s, t.angular * s};
}

}  // namespace

ClosureJets::ClosureJets(const kinematics::RobotModel& model, const std::vector<double>& q, const Pose& X_WB)
    : variables_(q.size()) {
  HAPTICELL_DEMAND(model.closure && q.size() == model.dof());
  const Mover mover(model, q, X_WB);
  X_WL_ = mover.here();
  const std::size_t n = variables_, count = links();
  velocity_.resize(n * count);
  acceleration_.resize(n * n * count);
  std::vector<Twists> even(n);  // D(+h) + D(-h) of each variable.
  for (std::size_t i = 0; i < n; ++i) {
    const Twists ahead = mover.moved(i, kStep, i, 0.0), back = mover.moved(i, -kStep, i, 0.0);
    even[i].resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      velocity_[i * count + k] = scaled(sum(ahead[k], scaled(back[k], -1.0)), 0.5 / kStep);
      even[i][k] = sum(ahead[k], back[k]);
      acceleration_[(i * n + i) * count + k] = scaled(even[i][k], 1.0 / (kStep * kStep));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Twists ahead = mover.moved(i, kStep, j, kStep), back = mover.moved(i, -kStep, j, -kStep);
      for (std::size_t k = 0; k < count; ++k) {
        const Twist both = sum(ahead[k], back[k]), single = sum(even[i][k], even[j][k]);
        const Twist mixed = scaled(sum(both, scaled(single, -1.0)), 0.5 / (kStep * kStep));
        acceleration_[(i * n + j) * count + k] = acceleration_[(j * n + i) * count + k] = mixed;
      }
    }
  }
  std::vector<kinematics::ClosureMargin> here, ahead, back;
  model.closure->margins(q, here);
  for (kinematics::ClosureMargin& margin : here) margins_.push_back({std::move(margin), std::vector<double>(n)});
  std::vector<double> x = q;
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = q[i] + kStep;
    model.closure->margins(x, ahead);
    x[i] = q[i] - kStep;
    model.closure->margins(x, back);
    x[i] = q[i];
    for (std::size_t m = 0; m < margins_.size(); ++m) {
      margins_[m].gradient[i] = (ahead[m].value - back[m].value) / (2.0 * kStep);
    }
  }
}

}  // namespace hapticell::manipulation
