// SPDX-License-Identifier: Apache-2.0
#include "trajectory/checks/motion_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hapticell::trajectory_checks {

namespace {

using trajectory::Trajectory;

double angleBetween(const dquat& a, const dquat& b) {
  const dquat step = glm::conjugate(a) * b;
  return 2.0 * std::atan2(std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z), std::abs(step.w));
}

/// Between two unit quaternions on the shorter arc, by sines.
dquat arc(const dquat& a, dquat b, double share) {
  double cosine = glm::dot(a, b);
  if (cosine < 0.0) {
    b = -b;
    cosine = -cosine;
  }
  const double angle = std::acos(std::min(1.0, cosine));
  if (angle < 1e-7) return glm::normalize(a * (1.0 - share) + b * share);
  return (a * std::sin((1.0 - share) * angle) + b * std::sin(share * angle)) / std::sin(angle);
}

struct Place {
  std::size_t segment = 0;
  double share = 0.0;
};

/// Three distances, and the largest share of what counts as near.
struct Off {
  double position = 0.0, angle = 0.0, joint = 0.0, share = 0.0;
};

class Comparison {
 public:
  Comparison(const Trajectory& given, const Trajectory& written, const Nearness& near)
      : given_(given),
        written_(written),
        near_(near),
        poses_(given.has_poses && written.has_poses),
        joints_(given.joint_names.size() == written.joint_names.size()) {}

  Off at(std::size_t i, const Place& place) const {
    const std::size_t a = place.segment, b = std::min(a + 1, written_.size() - 1);
    Off off;
    if (poses_) {
      const Pose &X = given_[i].X_WT, &X_a = written_[a].X_WT, &X_b = written_[b].X_WT;
      off.position = glm::length(X.p - (X_a.p + place.share * (X_b.p - X_a.p)));
      off.angle = angleBetween(X.q, arc(X_a.q, X_b.q, place.share));
    }
    for (std::size_t j = 0; joints_ && j < given_.joint_names.size(); ++j) {
      const double q_a = written_.joints(a)[j], q_b = written_.joints(b)[j];
      off.joint = std::max(off.joint, std::abs(given_.joints(i)[j] - (q_a + place.share * (q_b - q_a))));
    }
    off.share = std::max({off.position / near_.position, off.angle / near_.angle, off.joint / near_.joint});
    return off;
  }

  /// The share of a segment at which frame `i` is nearest, not before `from`: the largest of several distances each
  /// convex on it, so thirds find it.
  Place nearestOn(std::size_t i, std::size_t segment, double from) const {
    double low = from, high = 1.0;
    const double fine = 0.003 / std::max(1e-9, lengthOf(segment));
    for (int k = 0; k < 60 && high - low > fine; ++k) {
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      if (at(i, {segment, a}).share <= at(i, {segment, b}).share) {
        high = b;
      } else {
        low = a;
      }
    }
    const Place inner{segment, 0.5 * (low + high)};
    for (const double end : {from, 1.0})
      if (at(i, {segment, end}).share <= at(i, inner).share) return {segment, end};
    return inner;
  }

  /// A distance that no place of the segment comes below: from its middle less half its length.
  double leastOn(std::size_t i, std::size_t segment) const {
    if (!poses_) return 0.0;
    const dvec3 &a = written_[segment].X_WT.p, &b = written_[std::min(segment + 1, written_.size() - 1)].X_WT.p;
    return std::max(0.0, glm::length(given_[i].X_WT.p - 0.5 * (a + b)) - 0.5 * glm::length(b - a)) / near_.position;
  }

  /// In what counts as near.
  double lengthOf(std::size_t segment) const {
    const std::size_t a = segment, b = std::min(a + 1, written_.size() - 1);
    double length = 0.0;
    if (poses_) {
      const Pose &X_a = written_[a].X_WT, &X_b = written_[b].X_WT;
      length = std::max(glm::length(X_b.p - X_a.p) / near_.position, angleBetween(X_a.q, X_b.q) / near_.angle);
    }
    for (std::size_t j = 0; joints_ && j < given_.joint_names.size(); ++j)
      length = std::max(length, std::abs(written_.joints(b)[j] - written_.joints(a)[j]) / near_.joint);
    return length;
  }

  std::size_t segments() const { return std::max<std::size_t>(1, written_.size() - 1); }

 private:
  const Trajectory& given_;
  const Trajectory& written_;
  const Nearness near_;
  bool poses_, joints_;
};

void take(Distances& worst, const Off& off, double t) {
  if (off.position > worst.position) worst.t_position = t;
  if (off.angle > worst.angle) worst.t_angle = t;
  if (off.joint > worst.joint) worst.t_joint = t;
  worst.position = std::max(worst.position, off.position);
  worst.angle = std::max(worst.angle, off.angle);
  worst.joint = std::max(worst.joint, off.joint);
}

/// Numbers of the frames in time, standing before and after.
class Samples {
 public:
  Samples(const Trajectory& motion, bool by_joints) : motion_(motion), by_joints_(by_joints) {}
  std::size_t dimensions() const { return by_joints_ ? motion_.joint_names.size() : 6; }
  std::size_t size() const { return motion_.size(); }

  double timeOf(std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(size()) - 1;
    if (i < 0) return motion_[0].t + static_cast<double>(i) * (motion_[1].t - motion_[0].t);
    if (i > last) {
      const double step = motion_[size() - 1].t - motion_[size() - 2].t;
      return motion_[size() - 1].t + static_cast<double>(i - last) * step;
    }
    return motion_[static_cast<std::size_t>(i)].t;
  }

  /// Seen from frame `from`, so that turns are small rotation vectors.
  void valuesAt(std::ptrdiff_t i, std::ptrdiff_t from, std::span<double> values) const {
    const auto inside = [&](std::ptrdiff_t k) {
      return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, static_cast<std::ptrdiff_t>(size()) - 1));
    };
    if (by_joints_) {
      const auto q = motion_.joints(inside(i));
      std::copy(q.begin(), q.end(), values.begin());
      return;
    }
    const Pose &X = motion_[inside(i)].X_WT, &X_0 = motion_[inside(from)].X_WT;
    dquat step = X.q * glm::conjugate(X_0.q);
    if (step.w < 0.0) step = -step;
    const dvec3 axis(step.x, step.y, step.z);
    const double sine = glm::length(axis);
    const dvec3 turn = sine > 1e-12 ? axis * (2.0 * std::atan2(sine, step.w) / sine) : 2.0 * axis;
    for (int k = 0; k < 3; ++k) {
      values[static_cast<std::size_t>(k)] = X.p[k] - X_0.p[k];
      values[static_cast<std::size_t>(k) + 3] = turn[k];
    }
  }

 private:
  const Trajectory& motion_;
  bool by_joints_;
};

/// Largest derivative of `order` in each dimension, over frames `stride` apart.
void differentiate(const Samples& samples, std::size_t order, std::ptrdiff_t stride, std::vector<double>& most,
                   std::vector<double>& when) {
  const std::size_t d = samples.dimensions();
  most.assign(d, 0.0);
  when.assign(d, 0.0);
  std::array<std::vector<double>, 4> x;
  for (auto& values : x) values.resize(d);
  const double factorial = std::array{1.0, 1.0, 2.0, 6.0}[static_cast<std::size_t>(order)];
  const auto span = static_cast<std::ptrdiff_t>(order) * stride;
  for (std::ptrdiff_t first = -span; first < static_cast<std::ptrdiff_t>(samples.size()); ++first) {
    std::array<double, 4> t{};
    for (std::size_t k = 0; k <= order; ++k) {
      const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(k) * stride;
      t[k] = samples.timeOf(at);
      samples.valuesAt(at, first + stride, x[k]);
    }
    for (std::size_t j = 0; j < d; ++j) {
      std::array<double, 4> f{};
      for (std::size_t k = 0; k <= order; ++k) f[k] = x[k][j];
      for (std::size_t m = 1; m <= order; ++m)
        for (std::size_t k = 0; k + m <= order; ++k) f[k] = (f[k + 1] - f[k]) / (t[k + m] - t[k]);
      const double derivative = factorial * std::abs(f[0]);
      if (derivative > most[j]) when[j] = t[1];
      most[j] = std::max(most[j], derivative);
    }
  }
}

}  // namespace

namespace {

/// Passes all given frames in order where each comes within what `comparison` calls near, each at the first place where
/// it does and where it is nearest there; false at the first frame that is nowhere passed.
bool pass(const Trajectory& given, const Comparison& comparison, Distances& worst) {
  worst = {};
  Place here;
  for (std::size_t i = 0; i < given.size(); ++i) {
    Place best = here;
    Off least;
    least.share = std::numeric_limits<double>::infinity();
    bool passed = false;
    for (std::size_t segment = here.segment; segment < comparison.segments(); ++segment) {
      const double bound = comparison.leastOn(i, segment);
      if (!passed && bound > 1.0) continue;
      if (passed && bound >= least.share) break;
      const Place place = comparison.nearestOn(i, segment, segment == here.segment ? here.share : 0.0);
      const Off off = comparison.at(i, place);
      if (passed && off.share >= least.share) break;  // It goes away again.
      if (off.share > 1.0) continue;
      passed = true;
      least = off;
      best = place;
      if (place.share < 1.0) break;  // It is nearest within this one, so the way goes away from here.
    }
    if (!passed) return false;
    take(worst, least, given[i].t);
    here = best;
  }
  return true;
}

}  // namespace

Distances passing(const Trajectory& given, const Trajectory& written, const Nearness& near) {
  constexpr Distances kNowhere{1e300, 0.0, 1e300, 0.0, 1e300, 0.0};
  // Growth of the window of nearness until a pass fits: a failed motion's distance is reported up to 1.5 times too
  // large. Less: more passes; twice: up to three times. Beyond kWidest times what was asked it is "nowhere".
  constexpr double kWider = 1.5, kWidest = 1e6;
  Distances worst;
  if (written.empty()) return kNowhere;
  for (double factor = 1.0 + 1e-6; factor < kWidest; factor *= kWider) {
    const Nearness wide{factor * near.position, factor * near.angle, factor * near.joint};
    if (pass(given, Comparison(given, written, wide), worst)) return worst;
  }
  return kNowhere;
}

Distances atSameTimes(const Trajectory& given, const Trajectory& written) {
  Distances worst;
  if (written.empty()) return {1e300, 0.0, 1e300, 0.0, 1e300, 0.0};
  const Comparison comparison(given, written, {});
  std::size_t segment = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    while (segment + 2 < written.size() && written[segment + 1].t <= given[i].t) ++segment;
    const std::size_t next = std::min(segment + 1, written.size() - 1);
    const double span = written[next].t - written[segment].t;
    const double share = span > 0.0 ? std::clamp((given[i].t - written[segment].t) / span, 0.0, 1.0) : 0.0;
    take(worst, comparison.at(i, {segment, share}), given[i].t);
  }
  return worst;
}

Derivatives derivativesOf(const Trajectory& written, bool by_joints, double least_jerk) {
  Derivatives result;
  if (written.size() < 2) return result;
  const Samples samples(written, by_joints);
  double largest = 1.0;
  for (std::size_t i = 0; i < written.size(); ++i) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(written[i].X_WT.p[k]));
    for (const double q : written.joints(i)) largest = std::max(largest, std::abs(q));
  }
  differentiate(samples, 1, 1, result.speed, result.t_speed);
  differentiate(samples, 2, 1, result.acceleration, result.t_acceleration);
  if (!(least_jerk > 0.0)) return result;
  const double step = written.duration() / static_cast<double>(written.size() - 1);
  // Third differences of numbers that are rounded to half a unit in their last place.
  const double wide = std::cbrt(8.0 * 1.2e-16 * largest / (1e-4 * least_jerk)) / step;
  const double most = static_cast<double>(written.size());
  differentiate(samples, 3, static_cast<std::ptrdiff_t>(std::clamp(std::ceil(wide), 1.0, most)), result.jerk,
                result.t_jerk);
  return result;
}

FrameSpeed greatestSpeed(const Trajectory& written, double metres_per_radian) {
  FrameSpeed most;
  for (std::size_t i = 1; i < written.size(); ++i) {
    const Pose &X_0 = written[i - 1].X_WT, &X_1 = written[i].X_WT;
    const double way = std::hypot(glm::length(X_1.p - X_0.p), metres_per_radian * angleBetween(X_0.q, X_1.q));
    const double speed = way / (written[i].t - written[i - 1].t);
    if (speed > most.speed) most = {speed, written[i - 1].t};
  }
  return most;
}

}  // namespace hapticell::trajectory_checks
