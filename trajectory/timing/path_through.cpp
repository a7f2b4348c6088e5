// SPDX-License-Identifier: Apache-2.0
// The fits of motion_path.h.
#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "trajectory/editing/farthest_split.h"
#include "trajectory/editing/segment_distance.h"
#include "trajectory/timing/motion_path.h"

namespace hapticell::trajectory {

namespace {

/// Of it a fit uses at the frames: frames of the result cut a little more. Half: slower motions, less rounded; over 1:
/// results miss their tolerance.
constexpr double kOfTolerance = 0.7;
/// Of the tolerance: frames so near to a straight way are one, as what is left is for the result's cuts. Half: noisy
/// straight ways get a spline; twice: less is left for rounding.
constexpr double kOfStraight = 0.1;
/// Of the way between two frames, that a spline may leave it by; chosen by trial, docs/dev/motions.md tells it. Half:
/// more ways are rounded corners, slower; twice: motions between far frames bulge visibly.
constexpr double kBulge = 0.08;
/// m, however far frames are apart: what a bulge may take of a clearance. Half: slower motions; twice: 2 mm from what
/// was recorded.
constexpr double kMostBulge = 0.001;
/// rad, of the orientation or a joint, a quarter degree: the same at 0.23 m. Half: slower; twice: half a degree off.
constexpr double kMostTurned = 0.0044;
// Rounds in which spans are split; the tolerance ends them mostly. Half: noisy motions are left out of tolerance at
// some frames; twice: more time for those.
constexpr int kMostSplits = 60;
// Guards time and memory, some for each frame of an hour at 60 Hz. Half: long motions are coarser; twice: twice the
// time.
constexpr std::size_t kMostSpans = 200'000;
/// Tolerances that the legs of a corner are long: shorter bends are noise or get rounded within the tolerance. Half:
/// noise is rested at; twice: short zigzags are rounded where a rest is faster.
constexpr double kCornerScale = 40.0;

PathTolerance times(const PathTolerance& tolerance, double factor) {
  return {factor * tolerance.position, factor * tolerance.angle, factor * tolerance.joint};
}

Deviation difference(const Trajectory& frames, std::size_t i, const Pose& X, std::span<const double> joints) {
  Deviation deviation;
  if (frames.has_poses) deviation.pose = distanceBetween(frames[i].X_WT, X);
  for (std::size_t j = 0; j < joints.size(); ++j)
    deviation.joint = std::max(deviation.joint, std::abs(frames.joints(i)[j] - joints[j]));
  return deviation;
}

std::unique_ptr<MotionPath> straightThrough(const Trajectory& frames, std::span<const double> ways,
                                            const PathTolerance& tolerance, LimitedBy by) {
  auto path = std::make_unique<StraightPath>(frames, ways.back(), by);
  const PathTolerance close = times(tolerance, kOfStraight);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (difference(frames, i, path->pose(ways[i]), path->joints(ways[i])).shareOf(close) > 1.0) return nullptr;
  }
  return path;
}

/// Whether a spline passes the frames and stays by the straight ways between them.
bool isFaithful(const Trajectory& frames, std::span<const double> ways, const MotionSpline& spline,
                const PathTolerance& tolerance, LimitedBy by) {
  const PathTolerance close = times(tolerance, kOfTolerance);
  Trajectory between = frames.emptyCopy();
  if (by == LimitedBy::kJoints) between.has_poses = false;  // Between frames the joints go straight.
  double t = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (difference(frames, i, spline.pose(ways[i]), spline.joints(ways[i])).shareOf(close) > 1.0) return false;
    for (const double share : {0.25, 0.5, 0.75}) {
      if (i + 1 == frames.size()) break;
      const double u = ways[i] + share * (ways[i + 1] - ways[i]);
      between.addFrame({t += 1.0, spline.pose(u)}, spline.joints(u));
    }
  }
  const SegmentDistance distance(between, frames, tolerance);
  for (std::size_t k = 0; k < between.size(); ++k) {
    const std::size_t i = k / 3;
    const PoseDistance chord = distanceBetween(frames[i].X_WT, frames[i + 1].X_WT);
    double joint = 0.0;
    for (std::size_t j = 0; j < frames.joint_names.size(); ++j)
      joint = std::max(joint, std::abs(frames.joints(i + 1)[j] - frames.joints(i)[j]));
    const PathTolerance bulge{tolerance.position + std::min(kMostBulge, kBulge * chord.position),
                              tolerance.angle + std::min(kMostTurned, kBulge * chord.angle),
                              tolerance.joint + std::min(kMostTurned, kBulge * joint)};
    if (distance.of(k, {i, i + 1}).shareOf(bulge) > 1.0) return false;
  }
  return true;
}

/// The straight ways between the frames with rounded corners: Schoenberg's spline on spans that are split until it is
/// as near as asked. It reproduces straight ways and leaves no convex hull, so it does not swing.
class RoundedWays {
 public:
  RoundedWays(const Trajectory& frames, std::span<const double> ways, const PathTolerance& tolerance)
      : frames_(frames), ways_(ways), close_(times(tolerance, kOfTolerance)), breaks_{ways.front(), ways.back()} {
    dquat before(1.0, 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const dquat& q = frames[i].X_WT.q;
      before = i > 0 && glm::dot(q, before) < 0.0 ? -q : q;
      rotations_.push_back(before);
    }
  }

  MotionSpline fit() {
    // A turn is a straight way in quaternions only in small pieces.
    std::vector<double> begin{ways_.front()};
    for (std::size_t i = 0; i + 1 < ways_.size(); ++i) {
      const auto pieces = static_cast<int>(distanceBetween(frames_[i].X_WT, frames_[i + 1].X_WT).angle / kTurnStep);
      for (int k = 1; k <= pieces; ++k)
        begin.push_back(ways_[i] + (ways_[i + 1] - ways_[i]) * k / static_cast<double>(pieces + 1));
    }
    begin.push_back(ways_.back());
    breaks_ = std::move(begin);
    MotionSpline spline = laid();
    for (int round = 0; round < kMostSplits && breaks_.size() < kMostSpans && split(spline); ++round) spline = laid();
    return spline;
  }

 private:
  /// rad a piece: a turn is straight in quaternions only in small pieces. Half: twice the spans of turns; twice: eight
  /// times as far from a uniform turn.
  static constexpr double kTurnStep = 0.1;

  /// The frames' straight ways at u: seven numbers of the pose, then the joints.
  void wayAt(double u, double* value) const {
    const auto after = std::upper_bound(ways_.begin() + 1, ways_.end() - 1, u);
    const auto i = static_cast<std::size_t>(after - ways_.begin()) - 1;
    const double share = std::clamp((u - ways_[i]) / (ways_[i + 1] - ways_[i]), 0.0, 1.0);
    const dvec3 p = glm::mix(frames_[i].X_WT.p, frames_[i + 1].X_WT.p, share);
    const dquat step = rotations_[i + 1] * glm::conjugate(rotations_[i]);
    const dquat q = quaternionFromRotationVector(share * rotationVector(step)) * rotations_[i];
    const double values[] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z};
    std::copy(std::begin(values), std::end(values), value);
    const auto a = frames_.joints(i), b = frames_.joints(i + 1);
    for (std::size_t j = 0; j < a.size(); ++j) value[7 + j] = a[j] + share * (b[j] - a[j]);
  }

  MotionSpline laid() const {
    CubicSpline spline(breaks_, 7 + frames_.joint_names.size());
    for (std::size_t i = 0; i < spline.controlCount(); ++i) wayAt(spline.averageKnot(i), spline.control(i));
    return MotionSpline(std::move(spline));
  }

  double shareAt(const MotionSpline& spline, double u) const {
    std::vector<double> value(7 + frames_.joint_names.size());
    wayAt(u, value.data());
    Deviation off;
    if (frames_.has_poses) {
      const Pose X{{value[0], value[1], value[2]}, glm::normalize(dquat(value[3], value[4], value[5], value[6]))};
      off.pose = distanceBetween(X, spline.pose(u));
    }
    const auto joints = spline.joints(u);
    for (std::size_t j = 0; j < joints.size(); ++j) off.joint = std::max(off.joint, std::abs(joints[j] - value[7 + j]));
    return off.shareOf(close_);
  }

  /// Splits the spans in which it is too far off, at the frame that is, or in the middle; false where none is.
  bool split(const MotionSpline& spline) {
    std::vector<double> breaks{breaks_.front()};
    auto frame = ways_.begin();
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
      const double a = breaks_[k], b = breaks_[k + 1], middle = 0.5 * (a + b);
      double worst = 1.0, at = middle;
      bool out = false;
      const auto look = [&](double u, bool is_frame) {
        const double share = shareAt(spline, u);
        if (share <= worst) return;
        worst = share;
        out = true;
        at = is_frame && u > a + 0.2 * (b - a) && u < b - 0.2 * (b - a) ? u : middle;
      };
      for (; frame != ways_.end() && *frame <= b; ++frame) look(*frame, true);
      if (frame != ways_.begin()) --frame;  // One on the break belongs to both.
      for (const double share : {0.25, 0.5, 0.75}) look(a + share * (b - a), false);
      if (out && at > a && at < b) breaks.push_back(at);
      breaks.push_back(b);
    }
    const bool changed = breaks.size() > breaks_.size();
    breaks_ = std::move(breaks);
    return changed;
  }

  const Trajectory& frames_;
  std::span<const double> ways_;
  const PathTolerance close_;
  std::vector<double> breaks_;
  std::vector<dquat> rotations_;
};

/// The limited coordinates of each frame in units of the tolerance.
std::vector<std::vector<double>> scaledPoints(const Trajectory& frames, const PathTolerance& tolerance, LimitedBy by) {
  std::vector<std::vector<double>> points;
  const auto turns = runningTurns(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::vector<double> point;
    if (by == LimitedBy::kJoints) {
      for (const double q : frames.joints(i)) point.push_back(q / tolerance.joint);
    } else {
      for (int k = 0; k < 3; ++k) point.push_back(frames[i].X_WT.p[k] / tolerance.position);
      for (int k = 0; k < 3; ++k) point.push_back(turns[i][k] / tolerance.angle);
    }
    points.push_back(std::move(point));
  }
  return points;
}

using Point = std::vector<double>;

double dot(const Point& a, const Point& b, const Point& c, const Point& d) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (b[k] - a[k]) * (d[k] - c[k]);
  return sum;
}

/// Squared distance of b from the segment a to c.
double offSquared(const Point& a, const Point& b, const Point& c) {
  const double length = dot(a, c, a, c);
  const double share = length > 0.0 ? std::clamp(dot(a, b, a, c) / length, 0.0, 1.0) : 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double off = b[k] - a[k] - share * (c[k] - a[k]);
    sum += off * off;
  }
  return sum;
}

}  // namespace

std::unique_ptr<MotionPath> pathThrough(const Trajectory& frames, std::span<const double> ways,
                                        const PathTolerance& tolerance, LimitedBy by) {
  HAPTICELL_DEMAND(frames.size() == ways.size() && frames.size() >= 2);
  if (auto straight = straightThrough(frames, ways, tolerance, by)) return straight;
  FitDemand demand;
  demand.tolerance = times(tolerance, kOfTolerance);
  demand.joint_tolerance = demand.tolerance.joint;
  demand.first_span = ways.back() / 4.0;
  if (frames.size() > 3) {
    MotionSpline few = fitMotion(frames, ways, demand);
    if (isFaithful(frames, ways, few, tolerance, by)) return std::make_unique<CurvedPath>(std::move(few), by, false);
  }
  // Frames close together are noisy: a spline through each of them would swing.
  const double far = by == LimitedBy::kJoints ? kMostTurned : kMostBulge;
  const bool sparse = ways.back() > far * static_cast<double>(frames.size() - 1);
  MotionSpline all = splineThrough(frames, ways);
  if (sparse && isFaithful(frames, ways, all, tolerance, by))
    return std::make_unique<CurvedPath>(std::move(all), by, false);
  return std::make_unique<CurvedPath>(RoundedWays(frames, ways, tolerance).fit(), by, true);
}

std::vector<std::size_t> cornersOf(const Trajectory& frames, const PathTolerance& tolerance, LimitedBy by,
                                   double angle) {
  const auto points = scaledPoints(frames, tolerance, by);
  std::vector<std::size_t> kept{0, frames.size() - 1}, corners;
  const auto off = [&](std::size_t i, const FrameSpan& span) {
    return offSquared(points[span.first], points[i], points[span.last]);
  };
  splitAtFarthest({{0, frames.size() - 1}}, off, kept);
  const double cosine = std::cos(angle);
  for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
    const Point &a = points[kept[k - 1]], &b = points[kept[k]], &c = points[kept[k + 1]];
    const double one = std::sqrt(dot(a, b, a, b)), other = std::sqrt(dot(b, c, b, c));
    if (std::min(one, other) < kCornerScale) continue;
    if (dot(a, b, b, c) < cosine * one * other) corners.push_back(kept[k]);
  }
  return corners;
}

}  // namespace hapticell::trajectory
