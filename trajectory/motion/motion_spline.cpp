// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/motion_spline.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

namespace {

// Against 1 of a frame: ends stay within 1e-8 of what others pull. Half, twice: not seen; much more loses digits of the
// equations.
constexpr double kEndWeight = 1e8;
// Against 1 of a frame: what a user set, and dwells, stay where they are unless thousands of frames pull. Half, twice:
// set frames move by twice or half of very little.
constexpr double kByHandWeight = 1e4;
// Halvings of spans: 2^-24 of the first is below any two frames' distance. Half: long motions with a short wiggle stay
// out of tolerance; twice: no effect.
constexpr int kMostRounds = 24;

Pose poseOf(std::span<const double> v) {
  return {{v[0], v[1], v[2]}, glm::normalize(dquat(v[3], v[4], v[5], v[6]))};
}

/// The frames side by side, 7 + joints numbers each.
std::vector<double> flattened(const Trajectory& trajectory) {
  std::vector<double> values;
  values.reserve(trajectory.size() * (7 + trajectory.joint_names.size()));
  dquat last(1.0, 0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Pose& X = trajectory[i].X_WT;
    const dquat q = i > 0 && glm::dot(X.q, last) < 0.0 ? -X.q : X.q;
    last = q;
    values.insert(values.end(), {X.p.x, X.p.y, X.p.z, q.w, q.x, q.y, q.z});
    const auto joints = trajectory.joints(i);
    values.insert(values.end(), joints.begin(), joints.end());
  }
  return values;
}

/// How far the fit is from each frame: as vectors, for their running mean.
struct Residual {
  dvec3 position{0.0};
  dvec3 angle{0.0};
  double joint = 0.0;
};

class Fitter {
 public:
  Fitter(const Trajectory& trajectory, std::span<const double> u, const FitDemand& demand)
      : trajectory_(trajectory), u_(u), demand_(demand), values_(flattened(trajectory)), weights_(u.size(), 1.0) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (trajectory[i].by_hand || trajectory[i].dwell > 0.0) weights_[i] = kByHandWeight;
    }
    weights_.front() = weights_.back() = kEndWeight;
    const double length = u.back() - u.front();
    const auto spans = static_cast<std::size_t>(std::clamp(std::ceil(length / demand.first_span), 1.0, 1e5));
    for (std::size_t i = 0; i <= spans; ++i) {
      breaks_.push_back(u.front() + length * static_cast<double>(i) / static_cast<double>(spans));
    }
  }

  MotionSpline fit() {
    for (int round = 0;; ++round) {
      MotionSpline motion(fitSpline({u_, values_, weights_, 7 + trajectory_.joint_names.size()}, breaks_));
      if (round == kMostRounds || !split(motion)) return motion;
    }
  }

 private:
  std::vector<Residual> residualsOf(const MotionSpline& motion) const {
    const std::size_t dimensions = 7 + trajectory_.joint_names.size();
    std::vector<Residual> residuals(u_.size());
    std::vector<double> value(dimensions);
    for (std::size_t i = 0; i < u_.size(); ++i) {
      motion.spline().evaluate(u_[i], 0, value);
      const Pose X = poseOf(value);
      residuals[i].position = trajectory_[i].X_WT.p - X.p;
      residuals[i].angle = rotationVector(glm::conjugate(X.q) * trajectory_[i].X_WT.q);
      for (std::size_t j = 7; j < dimensions; ++j) {
        residuals[i].joint = std::max(residuals[i].joint, std::abs(values_[i * dimensions + j] - value[j]));
      }
    }
    return residuals;
  }

  bool isOut(const Residual& residual) const {
    return demand_.tolerance.shareOf({glm::length(residual.position), glm::length(residual.angle)}) > 1.0 ||
           residual.joint > demand_.joint_tolerance;
  }

  /// Marks the spans of frames that are out; false where none is (or can be split).
  bool split(const MotionSpline& motion) {
    const auto residuals = residualsOf(motion);
    std::vector<bool> is_wanted(breaks_.size() - 1, false);
    const auto want = [&](double at) {
      const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, at);
      is_wanted[static_cast<std::size_t>(after - breaks_.begin()) - 1] = true;
    };
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      if (isOut(residuals[i])) want(u_[i]);
    }
    if (demand_.mean_window > 0.0) wantLeaningSpans(residuals, want);
    return halve(is_wanted);
  }

  template <typename Want>
  void wantLeaningSpans(const std::vector<Residual>& residuals, const Want& want) const {
    std::size_t first = 0, last = 0;
    dvec3 position(0.0), angle(0.0);
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      for (; last < residuals.size() && u_[last] <= u_[i] + 0.5 * demand_.mean_window; ++last) {
        position += residuals[last].position;
        angle += residuals[last].angle;
      }
      for (; u_[first] < u_[i] - 0.5 * demand_.mean_window; ++first) {
        position -= residuals[first].position;
        angle -= residuals[first].angle;
      }
      const auto count = static_cast<double>(last - first);
      if (count < 3.0) continue;
      if (glm::length(position) > count * demand_.mean_position || glm::length(angle) > count * demand_.mean_angle) {
        want(u_[i]);
      }
    }
  }

  bool halve(const std::vector<bool>& is_wanted) {
    std::vector<double> breaks{breaks_.front()};
    for (std::size_t i = 0; i < is_wanted.size(); ++i) {
      const double middle = 0.5 * (breaks_[i] + breaks_[i + 1]);
      const auto first = std::lower_bound(u_.begin(), u_.end(), breaks_[i]);
      const auto last = std::upper_bound(u_.begin(), u_.end(), breaks_[i + 1]);
      if (is_wanted[i] && last - first > 2) breaks.push_back(middle);
      breaks.push_back(breaks_[i + 1]);
    }
    const bool has_changed = breaks.size() > breaks_.size();
    breaks_ = std::move(breaks);
    return has_changed;
  }

  const Trajectory& trajectory_;
  std::span<const double> u_;
  const FitDemand demand_;
  std::vector<double> values_;
  std::vector<double> weights_;
  std::vector<double> breaks_;
};

}  // namespace

Pose MotionSpline::pose(double u) const {
  std::vector<double> value(spline_.dimensions());
  spline_.evaluate(u, 0, value);
  return poseOf(value);
}

std::vector<double> MotionSpline::joints(double u) const {
  std::vector<double> value(spline_.dimensions());
  spline_.evaluate(u, 0, value);
  value.erase(value.begin(), value.begin() + 7);
  return value;
}

dvec3 MotionSpline::jerk(double u) const {
  std::vector<double> value(spline_.dimensions());
  spline_.evaluate(u, 3, value);
  return {value[0], value[1], value[2]};
}

MotionSpline fitMotion(const Trajectory& trajectory, std::span<const double> u, const FitDemand& demand) {
  HAPTICELL_DEMAND(trajectory.size() == u.size() && u.size() >= 2);
  return Fitter(trajectory, u, demand).fit();
}

MotionSpline splineThrough(const Trajectory& trajectory, std::span<const double> u) {
  HAPTICELL_DEMAND(trajectory.size() == u.size() && u.size() >= 2);
  const std::vector<double> values = flattened(trajectory);
  return MotionSpline(
      fitSpline({u, values, {}, 7 + trajectory.joint_names.size()}, std::vector<double>(u.begin(), u.end())));
}

}  // namespace hapticell::trajectory
