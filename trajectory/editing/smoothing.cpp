// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trajectory/motion/motion_spline.h"

namespace hapticell::trajectory {

namespace {

// Hz: in the middle of a hand's tremor (8 to 12 Hz), as what the window leaves of it is put right. Half: tremor is
// overestimated, more is smoothed; twice: underestimated.
constexpr double kTremorHz = 9.0;
/// s: two to three periods of a hand's tremor (8 to 12 Hz). Half: part of it counts as intended and stays; twice: quick
/// intended motions count as tremor.
constexpr double kTremorWindow = 0.25;

std::vector<double> timesOf(const Trajectory& trajectory) {
  std::vector<double> times;
  times.reserve(trajectory.size());
  for (const auto& frame : trajectory.frames()) times.push_back(frame.t);
  return times;
}

/// rms of what a parabola through a window leaves at its middle frame, over every few frames; as if it were a tremor of
/// 9 Hz, of which the window leaves a known share. `dt`: between frames, s.
double roughness(const std::vector<dvec3>& points, std::size_t half, double dt) {
  // Savitzky & Golay (1964), second degree: weights for evenly spaced frames.
  const auto m = static_cast<double>(half);
  std::vector<double> weights;
  double kept = 0.0;
  for (double i = -m; i <= m; ++i) {
    weights.push_back((3.0 * (3.0 * m * m + 3.0 * m - 1.0) - 15.0 * i * i) /
                      ((2.0 * m + 3.0) * (2.0 * m + 1.0) * (2.0 * m - 1.0)));
    kept += weights.back() * std::cos(2.0 * std::numbers::pi * kTremorHz * i * dt);
  }
  double sum = 0.0;
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, points.size() / 4000);
  for (std::size_t i = half; i + half < points.size(); i += step) {
    dvec3 mean(0.0);
    for (std::size_t j = 0; j < weights.size(); ++j) mean += weights[j] * points[i - half + j];
    const dvec3 left = points[i] - mean;
    sum += glm::dot(left, left);
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)) / (1.0 - kept);
}

/// Orientations as a running rotation vector: small steps add up without a wrap.
std::vector<dvec3> unrolledRotations(const Trajectory& trajectory) {
  std::vector<dvec3> angles(trajectory.size(), dvec3(0.0));
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    angles[i] = angles[i - 1] + rotationVector(glm::conjugate(trajectory[i - 1].X_WT.q) * trajectory[i].X_WT.q);
  }
  return angles;
}

double rmsJerkOf(const MotionSpline& motion) {
  // Constant within each span.
  const auto& breaks = motion.spline().breaks();
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const dvec3 jerk = motion.jerk(0.5 * (breaks[i] + breaks[i + 1]));
    sum += glm::dot(jerk, jerk) * (breaks[i + 1] - breaks[i]);
  }
  return std::sqrt(sum / (breaks.back() - breaks.front()));
}

void measure(const Trajectory& before, const Trajectory& after, SmoothingReport& report) {
  double sum = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const PoseDistance distance = distanceBetween(before[i].X_WT, after[i].X_WT);
    report.max_deviation.position = std::max(report.max_deviation.position, distance.position);
    report.max_deviation.angle = std::max(report.max_deviation.angle, distance.angle);
    sum += distance.position * distance.position;
  }
  report.rms_deviation = std::sqrt(sum / static_cast<double>(before.size()));
}

/// Where no spline of so few frames comes near enough, the frame is drawn towards where it was, to the tolerance's
/// edge.
bool bringWithin(const Trajectory& trajectory, std::size_t i, const PathTolerance& tolerance, Pose& X,
                 std::vector<double>& joints) {
  // Of the tolerance: moved points stay inside after rounding and writing. Half: no use is made of half the tolerance;
  // over 1: frames are out of it.
  constexpr double kEdge = 0.999;
  const PoseDistance off = distanceBetween(trajectory[i].X_WT, X);
  bool is_out = false;
  if (off.position > kEdge * tolerance.position) {
    X.p = trajectory[i].X_WT.p + (X.p - trajectory[i].X_WT.p) * (kEdge * tolerance.position / off.position);
    is_out = true;
  }
  if (off.angle > kEdge * tolerance.angle) {
    X.q = interpolate(trajectory[i].X_WT, X, kEdge * tolerance.angle / off.angle).q;
    is_out = true;
  }
  const auto given = trajectory.joints(i);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double edge = kEdge * tolerance.joint;
    is_out = is_out || std::abs(joints[j] - given[j]) > edge;
    joints[j] = std::clamp(joints[j], given[j] - edge, given[j] + edge);
  }
  return is_out;
}

}  // namespace

Tremor estimateTremor(const Trajectory& trajectory) {
  Tremor tremor;
  if (trajectory.size() < 8 || trajectory.duration() <= 0.0) return tremor;
  const double dt = trajectory.duration() / static_cast<double>(trajectory.size() - 1);
  const double frames = std::round(0.5 * kTremorWindow / dt);
  if (!(frames >= 2.0) || 2.0 * frames + 1.0 > static_cast<double>(trajectory.size())) return tremor;
  const auto half = static_cast<std::size_t>(frames);
  std::vector<dvec3> points;
  for (const auto& frame : trajectory.frames()) points.push_back(frame.X_WT.p);
  tremor.position = roughness(points, half, dt);
  tremor.angle = roughness(unrolledRotations(trajectory), half, dt);
  return tremor;
}

double rmsJerk(const Trajectory& trajectory) {
  double sum = 0.0, time = 0.0;
  for (std::size_t i = 0; i + 3 < trajectory.size(); ++i) {
    // Third divided difference (Newton), times 3!.
    dvec3 p[4];
    double t[4];
    for (std::size_t j = 0; j < 4; ++j) {
      p[j] = trajectory[i + j].X_WT.p;
      t[j] = trajectory[i + j].t;
    }
    for (std::size_t order = 1; order < 4; ++order) {
      for (std::size_t j = 0; j + order < 4; ++j) p[j] = (p[j + 1] - p[j]) / (t[j + order] - t[j]);
    }
    const dvec3 jerk = 6.0 * p[0];
    const double dt = t[2] - t[1];
    sum += glm::dot(jerk, jerk) * dt;
    time += dt;
  }
  return time > 0.0 ? std::sqrt(sum / time) : 0.0;
}

Smoothed smoothed(const Trajectory& trajectory, const SmoothingOptions& options) {
  Smoothed result{trajectory, {}};
  result.report.rms_jerk_before = result.report.rms_jerk_after = rmsJerk(trajectory);
  if (trajectory.size() < 4) return result;
  result.report.tremor = estimateTremor(trajectory);
  const Tremor& tremor = result.report.tremor;
  // A sine's peak is 1.4 times its rms; three axes and other frequencies add up to about twice.
  result.report.tremor_exceeds_tolerance =
      2.0 * tremor.position > options.tolerance.position || 2.0 * tremor.angle > options.tolerance.angle;

  FitDemand demand;
  demand.tolerance = options.tolerance;
  demand.mean_position = std::max(0.15 * options.tolerance.position, 0.5 * tremor.position);
  demand.mean_angle = std::max(0.15 * options.tolerance.angle, 0.5 * tremor.angle);
  demand.mean_window = kTremorWindow;
  demand.joint_tolerance = options.tolerance.joint;
  const MotionSpline motion = fitMotion(trajectory, timesOf(trajectory), demand);

  Trajectory smooth = trajectory.emptyCopy();
  smooth.reserve(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const auto& frame = trajectory[i];
    Pose X = motion.pose(frame.t);
    std::vector<double> joints = motion.joints(frame.t);
    if (bringWithin(trajectory, i, options.tolerance, X, joints)) ++result.report.frames_drawn_back;
    smooth.addFrame(
        {frame.t, X, frame.by_hand, frame.dwell, frame.name, trajectory.hasJoints() && trajectory.has_poses}, joints);
  }
  measure(trajectory, smooth, result.report);
  result.report.rms_jerk_after = result.report.frames_drawn_back > 0 ? rmsJerk(smooth) : rmsJerkOf(motion);
  result.report.spans = motion.spline().breaks().size() - 1;
  result.trajectory = std::move(smooth);
  return result;
}

}  // namespace hapticell::trajectory
