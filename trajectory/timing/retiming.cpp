// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/retiming.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/system/in_parallel.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/timing/frame_use.h"
#include "trajectory/timing/retimed_part.h"

namespace hapticell::trajectory {

namespace {

/// What counts as standing still (m, rad, rad or m of joints) when a path is laid: over rounding, under any tolerance.
/// Half, twice: no effect, what moves less than 1e-5 is noise.
constexpr PathTolerance kStill{1e-6, 1e-6, 1e-6};
/// Of the result: guards memory; 2.8 h at 1 kHz. Half, twice: other lengths are refused with a message.
constexpr double kMostFrames = 1e7;
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

/// From rest to rest: dwells and corners.
std::vector<MotionPiece> piecesOf(const Trajectory& trajectory, const std::set<std::size_t>& rests) {
  std::vector<MotionPiece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (rests.count(i) == 0 && i + 1 != trajectory.size()) continue;
    pieces.push_back({first, i});
    first = i;
  }
  return pieces;
}

/// Calls work(i) for each part of a motion by whoever is free, as some take a thousand times as long as others. One part
/// is worth a thread: of a few frames it takes 50 us, of many a second.
template <typename Work>
void forEachTogether(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const std::size_t threads = geometry::rangesOf(count, 1);
  geometry::inRanges(threads, threads, [&](std::size_t, std::size_t, std::size_t) {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  });
}

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
      HAPTICELL_TRY(addPieces(rests));
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
  bool isStopped() const { return options_.stop != nullptr && *options_.stop; }

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
    for (const MotionPiece& piece : piecesOf(moving_, rests)) {
      for (const std::size_t i : cornersOf(pieceOf(moving_, piece), options_.tolerance, by_, sharp))
        rests.insert(piece.first + i);
    }
    return rests;
  }

  /// What was laid and timed in the round before is so still where no further rest lies within.
  void keepKnown() {
    known_.clear();
    for (RetimedPart& part : pieces_) {
      const std::size_t first = part.first, last = first + part.frames.size() - 1;
      known_.emplace(std::pair(first, last), std::move(part));
    }
    pieces_.clear();
  }

  /// Those that are not known are laid and timed on all cores. The first error counts.
  Expected<void> addPieces(std::set<std::size_t>& rests) {
    const std::vector<MotionPiece> pieces = piecesOf(moving_, rests);
    std::vector<std::optional<Expected<std::vector<RetimedPart>>>> parts(pieces.size());
    forEachTogether(pieces.size(), [&](std::size_t i) {
      if (known_.count({pieces[i].first, pieces[i].last}) == 0) parts[i] = partsOf(pieces[i]);
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!parts[i]) {
        pieces_.push_back(std::move(known_.find({pieces[i].first, pieces[i].last})->second));
        continue;
      }
      HAPTICELL_TRY(*parts[i]);
      for (RetimedPart& one : **parts[i]) {
        if (one.first != pieces[i].first) rests.insert(one.first);
        pieces_.push_back(std::move(one));
      }
    }
    return {};
  }

  /// One, or with rests between where that is faster.
  Expected<std::vector<RetimedPart>> partsOf(const MotionPiece& piece) const {
    auto part = RetimedPart::of(moving_, piece, options_, by_);
    HAPTICELL_TRY(part);
    std::vector<RetimedPart> parts;
    if (part->path->isRounded() && !options_.limits.jerk.empty()) {
      parts = restingEverywhere(piece);
      double sum = 0.0;
      for (const RetimedPart& one : parts) sum += one.timing.duration;
      if (!parts.empty() && sum < part->timing.duration) return Expected<std::vector<RetimedPart>>(std::move(parts));
      parts.clear();
    }
    parts.push_back(std::move(*part));
    return Expected<std::vector<RetimedPart>>(std::move(parts));
  }

  /// The same piece with a rest at every bend that is one at the scale of the tolerance: where the jerk is limited
  /// that is often faster than to creep round corners. Nothing where there is no such bend.
  std::vector<RetimedPart> restingEverywhere(const MotionPiece& piece) const {
    std::set<std::size_t> bends;
    for (const std::size_t i : cornersOf(pieceOf(moving_, piece), options_.tolerance, by_, kBent))
      bends.insert(piece.first + i);
    std::vector<RetimedPart> parts;
    std::size_t first = piece.first;
    bends.insert(piece.last);
    if (bends.size() == 1) return parts;
    for (const std::size_t last : bends) {
      auto part = RetimedPart::of(moving_, {first, last}, options_, by_);
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
    for (const RetimedPart& part : pieces_) whole += part.timing.duration;
    if (!(whole / step <= kMostFrames)) {
      return makeError({.place = "sample",
                        .found = Text("a step of %1 s for a motion of %2 s", shortestText(step), shortestText(whole)),
                        .expected = "a step above 0 that gives at most 10 million frames",
                        .fix = "Use a longer step or a higher speed."});
    }
    step_ = step;
    std::vector<LimitUse> uses(pieces_.size());
    forEachTogether(pieces_.size(), [&](std::size_t i) { uses[i] = samplePart(pieces_[i], step); });
    if (isStopped()) return makeError(retimingStopped());
    auto& worst = result_.report.use;
    worst = {};
    for (const LimitUse& use : uses) {
      worst.velocity = std::max(worst.velocity, use.velocity);
      worst.acceleration = std::max(worst.acceleration, use.acceleration);
      worst.jerk = std::max(worst.jerk, use.jerk);
    }
    return {};
  }

  LimitUse samplePart(RetimedPart& part, double step) const {
    double stretch = 1.0;
    LimitUse use;
    for (int round = 0; round < 20 && !isStopped(); ++round) {
      const double duration = stretch * part.timing.duration;
      const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(duration / step - 1e-6)));
      // One part alone is given its own step, so that nothing is slowed; several share it.
      const double dt = pieces_.size() == 1 ? duration / static_cast<double>(count) : step;
      part.sample(count, dt, options_);
      if (options_.mode != TimingMode::kTimeOptimal) break;
      use = useOfFrames(part.samples, dt, options_.limits, by_);
      const double factor = stretchFor({use.velocity / kFullUse, use.acceleration / kFullUse, use.jerk / kFullUse});
      if (factor <= 1.0 + 1e-6) break;
      stretch = std::max(stretch, static_cast<double>(count) * dt / part.timing.duration) * factor * (1.0 + 1e-7);
    }
    return use;
  }

  /// Given frames that the samples miss; keeps the largest deviations.
  std::vector<std::size_t> missedFrames() {
    worst_ = {};
    std::vector<std::vector<std::size_t>> of_parts(pieces_.size());
    std::vector<Deviation> worst(pieces_.size());
    forEachTogether(pieces_.size(),
                    [&](std::size_t i) { of_parts[i] = pieces_[i].missedFrames(options_, worst[i]); });
    std::vector<std::size_t> missed;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      missed.insert(missed.end(), of_parts[i].begin(), of_parts[i].end());
      worst_.grow(worst[i]);
    }
    return missed;
  }

  void report(const std::set<std::size_t>& rests) {
    auto& report = result_.report;
    result_.trajectory = moving_.emptyCopy();
    result_.given = moving_.emptyCopy();
    double start = 0.0;
    for (const RetimedPart& part : pieces_) {
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
  std::vector<RetimedPart> pieces_;
  std::map<std::pair<std::size_t, std::size_t>, RetimedPart> known_;  ///< By their first and last frame in moving_.
  Deviation worst_;
  double step_ = 0.0;
  Retimed result_;
};

}  // namespace

Expected<Retimed> retimed(const Trajectory& trajectory, const RetimingOptions& options) {
  return Retimer(trajectory, options).run();
}

}  // namespace hapticell::trajectory
