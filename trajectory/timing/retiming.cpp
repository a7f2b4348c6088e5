// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/retiming.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "trajectory/editing/simplification.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/timing/frame_use.h"
#include "trajectory/timing/straight_timing.h"

namespace hapticell::trajectory {

namespace {

/// What counts as standing still (m, rad, rad or m of joints) when a path is laid: over rounding, under any tolerance.
/// Half, twice: no effect, what moves less than 1e-5 is noise.
constexpr PathTolerance kStill{1e-6, 1e-6, 1e-6};
/// Of the result: guards memory; 2.8 h at 1 kHz. Half, twice: other lengths are refused with a message.
constexpr double kMostFrames = 1e7;
/// Of the limits: numbers are rounded when they are written, and the check allows 1.001. Half the distance to 1:
/// written files may fail; twice: 0.05 % slower.
constexpr double kFullUse = 0.9995;
/// rad: corners that are rested at, by mode: 45 deg for least time, 20 deg where the speed is to stay. Half: more
/// rests, slower; twice: sharp corners are crept round.
constexpr double kSharp = 0.785398, kGlued = 0.35;
/// rad, 3 deg: a bend, where corners are looked for everywhere. Half: rests at noise are tried, for nothing; twice:
/// gentle zigzags that rests would make faster are crept through.
constexpr double kBent = 0.05;
/// Of the time between frames: to a sixteenth. Half: frames of fast corners are rested at instead; twice: sixteen times
/// more frames.
constexpr int kMostHalvings = 4;
/// In which further frames are rested at. Half: some motions are refused; twice: more time until they are.
constexpr int kMostRestRounds = 6;

struct Piece {
  std::size_t first, last;
};

/// From rest to rest: dwells and corners.
std::vector<Piece> piecesOf(const Trajectory& trajectory, const std::set<std::size_t>& rests) {
  std::vector<Piece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (rests.count(i) == 0 && i + 1 != trajectory.size()) continue;
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

/// Where a motion is on its path by time.
struct Timing {
  double duration = 0.0;
  std::function<double(double)> way;
  Timing slower(double factor) const {
    return {factor * duration, [way = way, factor](double t) { return way(t / factor); }};
  }
};

/// Along a straight path the bound of a derivative is the tightest of its coordinates'.
double tightest(std::span<const double> change, const std::vector<double>& limits) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < limits.size() && j < change.size(); ++j)
    if (std::abs(change[j]) > 0.0) least = std::min(least, limits[j] / std::abs(change[j]));
  return least;
}

Timing straightTiming(const MotionPath& path, const MotionLimits& limits) {
  std::vector<double> first(path.dimensions()), second(path.dimensions());
  path.derivatives(0.0, first, second);
  const StraightTiming timing(path.breaks().back(), kFullUse * tightest(first, limits.velocity),
                              kFullUse * tightest(first, limits.acceleration), kFullUse * tightest(first, limits.jerk));
  return {timing.duration(), [timing](double t) { return timing.at(t); }};
}

/// A trapezoid of the frame's own speed along the path.
class SpeedTiming {
 public:
  SpeedTiming(const MotionPath& path, const RetimingOptions& options) {
    // Places where the run of the tool is summed up; at 1 m apart by 50 um. Half, twice: speed varies more or less
    // between; the check allows 0.1 %.
    constexpr std::size_t kPlaces = 20000;
    const double length = path.breaks().back();
    Pose before = path.pose(0.0);
    for (std::size_t i = 0; i <= kPlaces; ++i) {
      const double u = length * static_cast<double>(i) / static_cast<double>(kPlaces);
      const Pose X = path.pose(u);
      const PoseDistance step = distanceBetween(before, X);
      const double way = std::hypot(step.position, options.metres_per_radian * step.angle);
      before = X;
      if (i > 0 && !(way > 0.0)) continue;
      places_.push_back(u);
      runs_.push_back(runs_.empty() ? 0.0 : runs_.back() + way);
    }
    places_.back() = length;
  }
  double length() const { return runs_.back(); }
  double placeAt(double run) const {
    const auto after = std::upper_bound(runs_.begin() + 1, runs_.end() - 1, run);
    const auto i = static_cast<std::size_t>(after - runs_.begin()) - 1;
    const double share = std::clamp((run - runs_[i]) / (runs_[i + 1] - runs_[i]), 0.0, 1.0);
    return places_[i] + share * (places_[i + 1] - places_[i]);
  }

 private:
  std::vector<double> places_, runs_;
};

class Retimer {
 public:
  Retimer(const Trajectory& original, const RetimingOptions& options)
      : original_(original),
        options_(options),
        moving_(withoutStillFrames(original, kStill)),
        by_(options.mode == TimingMode::kTimeOptimal && original.hasJoints() ? LimitedBy::kJoints : LimitedBy::kPose) {}

  Expected<Retimed> run() {
    HAPTICELL_TRY(check());
    std::set<std::size_t> rests = restsOf();
    for (int round = 0;; ++round) {
      keepKnown();
      for (const Piece& piece : piecesOf(moving_, rests)) {
        HAPTICELL_TRY(addPiece(piece, rests));
      }
      std::vector<std::size_t> missed;
      double step = options_.sample_s;
      for (int halving = 0; halving <= kMostHalvings; ++halving, step *= 0.5) {
        HAPTICELL_TRY(sample(step));
        const std::size_t before = missed.size();
        missed = missedFrames();
        if (missed.empty() || (halving > 0 && 10 * missed.size() > 9 * before)) break;
      }
      if (missed.empty() || round == kMostRestRounds) break;
      const std::size_t before = rests.size();
      rests.insert(missed.begin(), missed.end());
      // Where that is most of them, it is soon all of them.
      if (2 * rests.size() > moving_.size())
        for (std::size_t i = 1; i + 1 < moving_.size(); ++i) rests.insert(i);
      if (rests.size() == before) break;
    }
    report(rests);
    return std::move(result_);
  }

 private:
  /// A part from rest to rest on its path.
  struct Part {
    Trajectory frames;
    std::vector<double> ways;
    std::unique_ptr<MotionPath> path;
    Timing timing;
    std::size_t first = 0;  ///< Of moving_.
    Trajectory samples, given;
    std::vector<double> places;  ///< Way run at each sample.
  };

  bool isStopped() const { return options_.stop != nullptr && *options_.stop; }
  static Error stopped() { return {.found = "stopped before its end", .fix = "Start it again."}; }

  Expected<void> check() const {
    if (moving_.size() < 2 || (moving_.size() == 2 && stands()))
      return makeError({.place = "frames", .found = "fewer than two different frames", .expected = "a motion"});
    if (!(options_.sample_s > 0.0))
      return makeError(
          {.place = "sample", .found = Text("%1 s", shortestText(options_.sample_s)), .expected = "a value above 0"});
    if (options_.mode == TimingMode::kTimeOptimal) {
      const std::size_t dimensions = by_ == LimitedBy::kJoints ? moving_.joint_names.size() : 6;
      const auto limits = checkLimits(dimensions, options_.limits);
      return limits ? checkJoints() : limits;
    }
    if (!(options_.speed > 0.0) || !(options_.acceleration > 0.0))
      return makeError(
          {.place = "speed, acceleration", .found = "a value that is not above 0", .expected = "positive values"});
    if (!moving_.has_poses)
      return makeError(
          {"", "poses", "none, so no speed of the tool", "a robot whose forward kinematics gives them", ""});
    for (std::size_t i = 1; i < moving_.size(); ++i) {
      const PoseDistance step = distanceBetween(moving_[i - 1].X_WT, moving_[i].X_WT);
      if (kStill.shareOf(step) <= 1.0 && jointsMove(i))
        return makeError({.place = Text("frame %1", i),
                          .found = "joints that move while the tool does not",
                          .expected = "a tool that moves, because its speed is to be constant",
                          .fix = "Use time-optimal timing (joint limits)."});
    }
    return {};
  }

  Expected<void> checkJoints() const {
    for (std::size_t i = 1; i < moving_.size() && by_ == LimitedBy::kJoints; ++i) {
      const PoseDistance step = distanceBetween(moving_[i - 1].X_WT, moving_[i].X_WT);
      if (!jointsMove(i) && kStill.shareOf(step) > 100.0)
        return makeError({.place = Text("frame %1", i),
                          .found = "a pose that changes while the joints do not",
                          .expected = "joints that move, because their limits set the speed",
                          .fix = "Use constant-speed timing."});
    }
    return {};
  }

  bool stands() const {
    return kStill.shareOf(distanceBetween(moving_[0].X_WT, moving_[1].X_WT)) <= 1.0 && !jointsMove(1);
  }

  bool jointsMove(std::size_t i) const {
    const auto a = moving_.joints(i - 1), b = moving_.joints(i);
    return !std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) <= 1e-12; });
  }

  std::set<std::size_t> restsOf() const {
    std::set<std::size_t> rests;
    for (std::size_t i = 0; i < moving_.size(); ++i)
      if (moving_[i].dwell > 0.0) rests.insert(i);
    const double sharp = options_.mode == TimingMode::kTimeOptimal ? kSharp : kGlued;
    for (const Piece& piece : piecesOf(moving_, rests)) {
      for (const std::size_t i : cornersOf(pieceOf(moving_, piece), options_.tolerance, by_, sharp))
        rests.insert(piece.first + i);
    }
    return rests;
  }

  Expected<Timing> timingOf(const MotionPath& path) const {
    if (options_.mode == TimingMode::kConstantSpeed) {
      auto runs = std::make_shared<const SpeedTiming>(path, options_);
      const StraightTiming timing(runs->length(), options_.speed, options_.acceleration);
      return Timing{timing.duration(), [runs, timing](double t) { return runs->placeAt(timing.at(t)); }};
    }
    if (path.isStraight()) return straightTiming(path, options_.limits);
    auto timing = options_.limits.jerk.empty() ? timeOptimal(path, options_.limits, {options_.grid_points})
                                               : jerkLimited(path, options_.limits, {options_.grid_points});
    HAPTICELL_TRY(timing);
    return Timing{timing->duration(), [timing = std::move(*timing)](double t) { return timing.at(t).s; }};
  }

  Expected<Part> partOf(const Piece& piece) const {
    if (isStopped()) return makeError(stopped());
    Part part;
    part.first = piece.first;
    part.frames = pieceOf(moving_, piece);
    part.ways = waysOf(part.frames, options_.metres_per_radian, by_ == LimitedBy::kJoints);
    part.path = pathThrough(part.frames, part.ways, options_.tolerance, by_);
    auto timing = timingOf(*part.path);
    HAPTICELL_TRY(timing);
    part.timing = std::move(*timing);
    return part;
  }

  /// What was laid and timed in the round before is so still where no further rest lies within.
  void keepKnown() {
    known_.clear();
    for (Part& part : pieces_) {
      const std::size_t first = part.first, last = first + part.frames.size() - 1;
      known_.emplace(std::pair(first, last), std::move(part));
    }
    pieces_.clear();
  }

  Expected<void> addPiece(const Piece& piece, std::set<std::size_t>& rests) {
    if (const auto known = known_.find({piece.first, piece.last}); known != known_.end()) {
      pieces_.push_back(std::move(known->second));
      return {};
    }
    auto part = partOf(piece);
    HAPTICELL_TRY(part);
    if (part->path->isRounded() && !options_.limits.jerk.empty()) {
      auto parts = restingEverywhere(piece);
      double sum = 0.0;
      for (const Part& one : parts) sum += one.timing.duration;
      if (!parts.empty() && sum < part->timing.duration) {
        for (Part& one : parts) {
          if (one.first != piece.first) rests.insert(one.first);
          pieces_.push_back(std::move(one));
        }
        return {};
      }
    }
    pieces_.push_back(std::move(*part));
    return {};
  }

  /// The same piece with a rest at every bend that is one at the scale of the tolerance: where the jerk is limited
  /// that is often faster than to creep round corners. Nothing where there is no such bend.
  std::vector<Part> restingEverywhere(const Piece& piece) const {
    std::set<std::size_t> bends;
    for (const std::size_t i : cornersOf(pieceOf(moving_, piece), options_.tolerance, by_, kBent))
      bends.insert(piece.first + i);
    std::vector<Part> parts;
    std::size_t first = piece.first;
    bends.insert(piece.last);
    if (bends.size() == 1) return parts;
    for (const std::size_t last : bends) {
      auto part = partOf({first, last});
      if (!part) return {};
      parts.push_back(std::move(*part));
      first = last;
    }
    return parts;
  }

  /// Frames of every part, `step` apart over all of the motion; parts are slowed to whole numbers of steps, and until
  /// their frames keep the limits.
  Expected<void> sample(double step) {
    double whole = 0.0;
    for (const Part& part : pieces_) whole += part.timing.duration;
    if (!(whole / step <= kMostFrames)) {
      return makeError({.place = "sample",
                        .found = Text("a step of %1 s for a motion of %2 s", shortestText(step), shortestText(whole)),
                        .expected = "a step above 0 that gives at most 10 million frames",
                        .fix = "Use a longer step or a higher speed."});
    }
    step_ = step;
    result_.report.use = {};
    for (Part& part : pieces_) {
      double stretch = 1.0;
      LimitUse use;
      for (int round = 0; round < 20; ++round) {
        const double duration = stretch * part.timing.duration;
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(duration / step - 1e-6)));
        // One part alone is given its own step, so that nothing is slowed; several share it.
        const double dt = pieces_.size() == 1 ? duration / static_cast<double>(count) : step;
        samplePart(part, count, dt);
        if (isStopped()) return makeError(stopped());
        if (options_.mode != TimingMode::kTimeOptimal) break;
        use = useOfFrames(part.samples, dt, options_.limits, by_);
        const double factor = stretchFor({use.velocity / kFullUse, use.acceleration / kFullUse, use.jerk / kFullUse});
        if (factor <= 1.0 + 1e-6) break;
        stretch = std::max(stretch, static_cast<double>(count) * dt / part.timing.duration) * factor * (1.0 + 1e-7);
      }
      auto& worst = result_.report.use;
      worst.velocity = std::max(worst.velocity, use.velocity);
      worst.acceleration = std::max(worst.acceleration, use.acceleration);
      worst.jerk = std::max(worst.jerk, use.jerk);
    }
    return {};
  }

  void samplePart(Part& part, std::size_t count, double dt) const {
    part.samples = part.frames.emptyCopy();
    part.given = part.frames.emptyCopy();
    part.places.clear();
    const double duration = static_cast<double>(count) * dt;
    const Timing timing = part.timing.slower(duration / part.timing.duration);
    std::size_t before = 0;
    const auto& ways = part.ways;
    for (std::size_t i = 0; i <= count; ++i) {
      if (isStopped()) return;
      const double t = static_cast<double>(i) * dt;
      const double u = i == count ? ways.back() : timing.way(t);
      while (before + 2 < ways.size() && ways[before + 1] < u) ++before;
      const double share = std::clamp((u - ways[before]) / (ways[before + 1] - ways[before]), 0.0, 1.0);
      const double t_given = part.frames[before].t + share * (part.frames[before + 1].t - part.frames[before].t);
      const double dwell = i == count ? part.frames[part.frames.size() - 1].dwell : 0.0;
      const bool apart = moving_.hasJoints() && moving_.has_poses;
      part.samples.addFrame({t, part.path->pose(u), false, dwell, nullptr, apart}, part.path->joints(u));
      part.given.addFrame({t, part.frames.poseAt(t_given), false, dwell, nullptr, apart},
                          part.frames.jointsAt(t_given));
      part.places.push_back(u);
    }
    // Rests are met to the last digit.
    for (const std::size_t i : {std::size_t{0}, count}) {
      const std::size_t k = i == 0 ? 0 : part.frames.size() - 1;
      part.samples.replaceFrame(i, part.frames[k].X_WT, part.frames[k].is_pose_apart, part.frames.joints(k));
    }
  }

  /// Given frames that the straight ways between the samples miss; keeps the largest deviations.
  std::vector<std::size_t> missedFrames() {
    worst_ = {};
    std::vector<std::size_t> missed;
    for (const Part& part : pieces_) {
      const SegmentDistance distance(part.frames, part.samples, options_.tolerance);
      for (std::size_t k = 1; k + 1 < part.frames.size() && !isStopped(); ++k) {
        const auto after = std::upper_bound(part.places.begin(), part.places.end(), part.ways[k]);
        const auto at = static_cast<std::size_t>(after - part.places.begin());
        Deviation nearest{{1e300, 1e300}, 1e300};
        for (std::size_t i = at > 3 ? at - 3 : 0; i + 1 < part.samples.size() && i < at + 2; ++i) {
          const Deviation one = distance.of(k, {i, i + 1});
          if (one.shareOf(options_.tolerance) < nearest.shareOf(options_.tolerance)) nearest = one;
        }
        worst_.grow(nearest);
        if (nearest.shareOf(options_.tolerance) > 1.0) missed.push_back(part.first + k);
      }
    }
    return missed;
  }

  void report(const std::set<std::size_t>& rests) {
    auto& report = result_.report;
    result_.trajectory = moving_.emptyCopy();
    result_.given = moving_.emptyCopy();
    double start = 0.0;
    for (const Part& part : pieces_) {
      for (std::size_t i = 0; i < part.samples.size(); ++i) {
        Trajectory::Frame frame = part.samples[i], given = part.given[i];
        frame.t += start;
        given.t += start;
        // The first frame of a later part is the last of the one before, or comes after its dwell.
        result_.trajectory.addFrame(frame, part.samples.joints(i));
        result_.given.addFrame(given, part.given.joints(i));
      }
      const auto& last = part.samples.frames().back();
      start += last.t + last.dwell;
    }
    report.duration_before = original_.duration();
    report.duration_after = result_.trajectory.duration();
    report.still_frames = original_.size() - moving_.size();
    report.max_deviation = worst_.pose;
    report.max_joint_deviation = worst_.joint;
    report.sample_s = pieces_.size() == 1 && pieces_[0].samples.size() > 1 ? pieces_[0].samples[1].t : step_;
    for (const std::size_t i : rests) report.corners += moving_[i].dwell > 0.0 ? 0 : 1;
  }

  const Trajectory& original_;
  const RetimingOptions& options_;
  const Trajectory moving_;
  const LimitedBy by_;
  std::vector<Part> pieces_;
  std::map<std::pair<std::size_t, std::size_t>, Part> known_;  ///< By their first and last frame in moving_.
  Deviation worst_;
  double step_ = 0.0;
  Retimed result_;
};

}  // namespace

Expected<Retimed> retimed(const Trajectory& trajectory, const RetimingOptions& options) {
  return Retimer(trajectory, options).run();
}

}  // namespace hapticell::trajectory
