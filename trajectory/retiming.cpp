// SPDX-License-Identifier: Apache-2.0
#include "trajectory/retiming.h"

#include <algorithm>
#include <cmath>

#include "trajectory/motion_spline.h"
#include "trajectory/simplification.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::trajectory {

namespace {

/// What counts as standing still when a path is laid.
constexpr PathTolerance kStill{1e-6, 1e-6};
constexpr double kMostFrames = 1e7;  ///< Of the result.
constexpr double kMostLooks = 1e6;   ///< At the limits' use.

struct Piece {
  std::size_t first, last;
};

/// From dwell to dwell: at a dwell all comes to rest.
std::vector<Piece> piecesOf(const Trajectory& trajectory) {
  std::vector<Piece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (trajectory[i].dwell <= 0.0 && i + 1 != trajectory.size()) continue;
    pieces.push_back({first, i});
    first = i;
  }
  return pieces;
}

Trajectory pieceOf(const Trajectory& trajectory, const Piece& piece) {
  Trajectory copy = trajectory.emptyCopy();
  for (std::size_t i = piece.first; i <= piece.last; ++i) copy.addFrame(trajectory[i], trajectory.joints(i));
  return copy;
}

/// Way run from the first frame to each, with joints where there are any: what moves fast gets long.
std::vector<double> waysOf(const Trajectory& trajectory, double metres_per_radian, bool by_joints) {
  std::vector<double> ways{0.0};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    double square = 0.0;
    if (by_joints) {
      const auto a = trajectory.joints(i - 1), b = trajectory.joints(i);
      for (std::size_t j = 0; j < a.size(); ++j) square += (b[j] - a[j]) * (b[j] - a[j]);
    } else {
      const PoseDistance distance = distanceBetween(trajectory[i - 1].X_WT, trajectory[i].X_WT);
      const double turned = metres_per_radian * distance.angle;
      square = distance.position * distance.position + turned * turned;
    }
    ways.push_back(ways.back() + std::max(std::sqrt(square), 1e-12));
  }
  return ways;
}

/// The coordinates that limits are for: joints, or position and the running rotation vector.
std::vector<double> limitedCoordinates(const Trajectory& trajectory) {
  std::vector<double> values;
  dvec3 turned(0.0);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (trajectory.hasJoints()) {
      const auto joints = trajectory.joints(i);
      values.insert(values.end(), joints.begin(), joints.end());
      continue;
    }
    const Pose& X = trajectory[i].X_WT;
    if (i > 0) turned += rotationVector(X.q * glm::conjugate(trajectory[i - 1].X_WT.q));
    values.insert(values.end(), {X.p.x, X.p.y, X.p.z, turned.x, turned.y, turned.z});
  }
  return values;
}

/// Trapezoid of speed over the way, at rest at both ends.
PathTiming trapezoid(double way, double speed, double acceleration, std::size_t points) {
  std::vector<double> s, speeds;
  for (std::size_t i = 0; i < points; ++i) {
    const double at = way * static_cast<double>(i) / static_cast<double>(points - 1);
    s.push_back(at);
    speeds.push_back(std::min(speed, std::sqrt(2.0 * acceleration * std::max(0.0, std::min(at, way - at)))));
  }
  return {std::move(s), std::move(speeds)};
}

class Retimer {
 public:
  Retimer(const Trajectory& original, const RetimingOptions& options)
      : original_(original), options_(options), moving_(withoutStillFrames(original, kStill)) {}

  Expected<Retimed> run() {
    if (moving_.size() < 2 || (moving_.size() == 2 && stands())) {
      return makeError({"", "frames", "fewer than two different frames", "a motion", ""});
    }
    result_.trajectory = moving_.emptyCopy();
    result_.given = moving_.emptyCopy();
    result_.report.duration_before = original_.duration();
    result_.report.still_frames = original_.size() - moving_.size();
    double start = 0.0;
    for (const Piece& piece : piecesOf(moving_)) {
      const auto duration = addPiece(pieceOf(moving_, piece), start);
      if (!duration) return tl::unexpected(duration.error());
      start += *duration + moving_[piece.last].dwell;
    }
    result_.report.duration_after = result_.trajectory.duration();
    return std::move(result_);
  }

 private:
  bool stands() const {
    return kStill.shareOf(distanceBetween(moving_[0].X_WT, moving_[1].X_WT)) <= 1.0 && !jointsMove();
  }

  bool jointsMove() const {
    const auto a = moving_.joints(0), b = moving_.joints(1);
    return !std::equal(a.begin(), a.end(), b.begin());
  }

  Expected<PathTiming> timingOf(const Trajectory& piece, const std::vector<double>& ways, const MotionSpline& motion) {
    if (options_.mode == TimingMode::kConstantSpeed) {
      if (!(options_.speed > 0.0) || !(options_.acceleration > 0.0)) {
        return makeError({"", "speed, acceleration", "a value that is not positive", "positive values", ""});
      }
      return trapezoid(ways.back(), options_.speed, options_.acceleration, options_.grid_points);
    }
    const std::size_t dimensions = piece.hasJoints() ? piece.joint_names.size() : 6;
    const auto values = limitedCoordinates(piece);
    std::vector<double> weights(ways.size(), 1.0);
    weights.front() = weights.back() = 1e8;
    const CubicSpline path = fitSpline({ways, values, weights, dimensions}, motion.spline().breaks());
    auto timing = options_.limits.jerk.empty() ? timeOptimal(path, options_.limits, {options_.grid_points})
                                               : jerkLimited(path, options_.limits, {options_.grid_points});
    if (timing) {
      const double dt = std::max(1e-3, timing->duration() / kMostLooks);
      const LimitUse use = limitUse(path, *timing, options_.limits, dt);
      result_.report.use.velocity = std::max(result_.report.use.velocity, use.velocity);
      result_.report.use.acceleration = std::max(result_.report.use.acceleration, use.acceleration);
      result_.report.use.jerk = std::max(result_.report.use.jerk, use.jerk);
    }
    return timing;
  }

  void noteDeviation(const Trajectory& piece, const std::vector<double>& ways, const MotionSpline& motion) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const PoseDistance distance = distanceBetween(piece[i].X_WT, motion.pose(ways[i]));
      auto& worst = result_.report.max_deviation;
      worst.position = std::max(worst.position, distance.position);
      worst.angle = std::max(worst.angle, distance.angle);
      const auto joints = motion.joints(ways[i]);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        result_.report.max_joint_deviation =
            std::max(result_.report.max_joint_deviation, std::abs(joints[j] - piece.joints(i)[j]));
      }
    }
  }

  /// Adds the frames of one piece from time `start` on; its duration.
  Expected<double> addPiece(const Trajectory& piece, double start) {
    const bool by_joints = options_.mode == TimingMode::kTimeOptimal && piece.hasJoints();
    const auto ways = waysOf(piece, options_.metres_per_radian, by_joints);
    FitDemand demand;
    demand.tolerance = {5e-5, 1e-3};
    demand.joint_tolerance = 2e-4;
    demand.first_span = ways.back() / 4.0;
    const MotionSpline motion = fitMotion(piece, ways, demand);
    noteDeviation(piece, ways, motion);
    const auto timing = timingOf(piece, ways, motion);
    if (!timing) return tl::unexpected(timing.error());
    const double duration = timing->duration(), frames = std::ceil(duration / options_.sample_s);
    if (!(options_.sample_s > 0.0) || !(frames <= kMostFrames)) {
      return makeError({"", "sample", shortestText(options_.sample_s) + " s for " + shortestText(duration) + " s",
                        "a positive one, at most ten million frames", "Take a longer one, or a higher speed."});
    }
    const auto count = static_cast<std::size_t>(std::max(1.0, frames));
    std::size_t before = 0;
    for (std::size_t i = 0; i <= count; ++i) {
      const double t = duration * static_cast<double>(i) / static_cast<double>(count);
      const double s = timing->at(t).s;
      while (before + 2 < ways.size() && ways[before + 1] < s) ++before;
      const double share = std::clamp((s - ways[before]) / (ways[before + 1] - ways[before]), 0.0, 1.0);
      const double t_given = piece[before].t + share * (piece[before + 1].t - piece[before].t);
      const double dwell = i == count ? piece[piece.size() - 1].dwell : 0.0;
      // The first frame of a later piece is the last of the one before, or comes after its dwell.
      result_.trajectory.addFrame({start + t, motion.pose(s), false, dwell}, motion.joints(s));
      result_.given.addFrame({start + t, piece.poseAt(t_given), false, dwell}, piece.jointsAt(t_given));
    }
    return duration;
  }

  const Trajectory& original_;
  const RetimingOptions& options_;
  const Trajectory moving_;
  Retimed result_;
};

}  // namespace

Expected<Retimed> retimed(const Trajectory& trajectory, const RetimingOptions& options) {
  return Retimer(trajectory, options).run();
}

}  // namespace hapticell::trajectory
