// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/motion_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "mannequin/ergonomics/figure_measurement.h"
#include "mannequin/ergonomics/owas.h"
#include "mannequin/ergonomics/reba.h"
#include "mannequin/ergonomics/rula.h"
#include "mannequin/retarget.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

constexpr double kDegrees = 57.295779513082323;

/// What the places of the recorded joints tell by themselves, degrees; arms left, right.
struct Recorded {
  double trunk = 0.0;  ///< Against the vertical (the file's Y), without a sign.
  double elevation[2] = {}, flexion[2] = {}, abduction[2] = {};
};

Recorded recordedAngles(const mannequin::ClipMap& map, const mannequin::ClipPose& pose) {
  const auto place = [&](int joint) { return pose.p[static_cast<std::size_t>(joint)]; };
  const dvec3 up = glm::normalize(place(map.neck) - 0.5 * (place(map.hip[0]) + place(map.hip[1])));
  const dvec3 across = place(map.shoulder[0]) - place(map.shoulder[1]);
  const dvec3 left = glm::normalize(across - glm::dot(across, up) * up);
  const dvec3 forward = glm::cross(left, up);
  Recorded recorded;
  recorded.trunk = kDegrees * std::atan2(std::hypot(up.x, up.z), up.y);
  for (std::size_t side = 0; side < 2; ++side) {
    const dvec3 arm = glm::normalize(place(map.elbow[side]) - place(map.shoulder[side]));
    const double ahead = glm::dot(arm, forward), down = -glm::dot(arm, up);
    recorded.elevation[side] = kDegrees * std::acos(std::clamp(down, -1.0, 1.0));
    recorded.flexion[side] = std::hypot(ahead, down) > 0.1 ? kDegrees * std::atan2(ahead, down) : 0.0;
    if (recorded.flexion[side] < -120.0) recorded.flexion[side] += 360.0;
    recorded.abduction[side] =
        kDegrees * std::asin(std::clamp(glm::dot(arm, left) * (side == 0 ? 1.0 : -1.0), -1.0, 1.0));
  }
  return recorded;
}

Rula::Values rulaOf(const PostureAngles& angles, const MotionTask& task) {
  std::vector<std::string_view> unknown;
  auto values = rulaValues(angles, unknown);
  values[Rula::kMuscleUseArm] = values[Rula::kMuscleUseBody] = task.muscle_use;
  values[Rula::kForceArm] = values[Rula::kForceBody] = task.force;
  return values;
}

Reba::Values rebaOf(const PostureAngles& angles, const MotionTask& task) {
  std::vector<std::string_view> unknown;
  auto values = rebaValues(angles, unknown);
  values[Reba::kLoad] = task.load;
  values[Reba::kCoupling] = task.coupling;
  values[Reba::kActivity] = task.activity;
  return values;
}

template <class Values>
int scoreOf(const ScoredMethod& method, const Values& values) {
  std::array<int, std::tuple_size_v<Values>> all{};
  std::transform(values.begin(), values.end(), all.begin(), [](const auto& value) { return value.value_or(1); });
  return method.score(all);
}

int levelOf(MotionMethod method, int score) {
  switch (method) {
    case MotionMethod::kRula:
      return Rula().levelOf(score);
    case MotionMethod::kReba:
      return Reba().levelOf(score);
    case MotionMethod::kOwas:
      return Owas().levelOf(score);
  }
  return 0;
}

class FrameScorer {
 public:
  FrameScorer(const mannequin::Figure& figure, MotionMethod method, const MotionTask& task)
      : figure_(figure), method_(method), task_(task) {}

  /// `recorded` replaces the figure's trunk (its sign is kept) and upper arms: they need no model.
  FrameScore score(const mannequin::Posture& posture, const Recorded& recorded) {
    const auto pose = mannequin::forwardKinematics(figure_, posture);
    FrameScore frame;
    frame.trunk_flexion = recorded.trunk;
    std::copy(std::begin(recorded.elevation), std::end(recorded.elevation), frame.upper_arm_elevation);
    if (method_ == MotionMethod::kOwas) {
      frame.left = frame.right = frame.score = scoreOf(Owas(), owasValues(owasOf(posture, pose, recorded)));
    } else {
      frame.left = sideScore(anglesOf(posture, pose, Side::kLeft, recorded));
      frame.right = sideScore(anglesOf(posture, pose, Side::kRight, recorded));
      frame.score = std::max(frame.left, frame.right);
    }
    frame.level = levelOf(method_, frame.score);
    return frame;
  }

  /// Of one frame: its sub-scores and what would bring them down.
  void explain(const mannequin::Posture& posture, const Recorded& recorded, MotionScores& scores) const {
    const auto pose = mannequin::forwardKinematics(figure_, posture);
    const auto set = [&](const auto& values, MethodAdvice advice) {
      scores.worst_values.assign(values.begin(), values.end());
      scores.worst_advice = std::move(advice);
    };
    if (method_ == MotionMethod::kOwas) {
      const OwasPosture whole = owasOf(posture, pose, recorded);
      return set(owasValues(whole), adviseOwas(whole));
    }
    const FrameScore& frame = scores.frames[scores.worst];
    const auto angles = anglesOf(posture, pose, frame.left > frame.right ? Side::kLeft : Side::kRight, recorded);
    if (method_ == MotionMethod::kRula) {
      const auto values = rulaOf(angles, task_);
      return set(values, adviseAngles(Rula(), angles, values));
    }
    const auto values = rebaOf(angles, task_);
    set(values, adviseAngles(Reba(), angles, values));
  }

 private:
  OwasPosture owasOf(const mannequin::Posture& posture, const mannequin::FigurePose& pose,
                     const Recorded& recorded) const {
    OwasPosture whole = owasPosture(figure_, posture, pose);
    whole.trunk_flexion = recorded.trunk;
    whole.load_kg = task_.load_kg;
    return whole;
  }

  PostureAngles anglesOf(const mannequin::Posture& posture, const mannequin::FigurePose& pose, Side side,
                         const Recorded& recorded) const {
    MeasuredPosture measured = measure(figure_, posture, pose, side);
    measured.trunk_flexion = std::copysign(recorded.trunk, measured.trunk_flexion);
    measured.upper_arm_flexion = recorded.flexion[static_cast<std::size_t>(side)];
    measured.upper_arm_abduction = recorded.abduction[static_cast<std::size_t>(side)];
    PostureAngles angles = postureAngles(measured);
    angles.arm_supported = false;
    return angles;
  }

  int sideScore(const PostureAngles& angles) const {
    return method_ == MotionMethod::kRula ? scoreOf(Rula(), rulaOf(angles, task_))
                                          : scoreOf(Reba(), rebaOf(angles, task_));
  }

  const mannequin::Figure& figure_;
  MotionMethod method_;
  MotionTask task_;
};

void summarise(MotionScores& scores) {
  const double share = 1.0 / static_cast<double>(scores.frames.size());
  for (std::size_t i = 0; i < scores.frames.size(); ++i) {
    const FrameScore& frame = scores.frames[i];
    scores.share_by_level[frame.level] += share;
    scores.share_by_score[frame.score] += share;
    const FrameScore& worst = scores.frames[scores.worst];
    if (frame.score > worst.score || (frame.score == worst.score && frame.trunk_flexion > worst.trunk_flexion)) {
      scores.worst = i;
    }
  }
}

constexpr double kFlicker = 0.2;  // s; shorter than a person takes to move out of a posture and back.

}  // namespace

ScorePhase worstPhase(std::span<const int> scores, double frame_time) {
  ScorePhase worst;
  if (scores.empty()) return worst;
  worst.score = *std::max_element(scores.begin(), scores.end());
  const auto bridged = static_cast<std::size_t>(frame_time > 0.0 ? kFlicker / frame_time + 1e-9 : 0.0);
  bool any = false;
  for (std::size_t first = 0; first < scores.size(); ++first) {
    if (scores[first] != worst.score) continue;
    std::size_t last = first;
    for (std::size_t i = first + 1; i < scores.size() && i - last <= bridged + 1; ++i)
      if (scores[i] == worst.score) last = i;
    if (!any || last - first > worst.last - worst.first) worst.first = first, worst.last = last;
    any = true;
    first = last;
  }
  const std::size_t middle = (worst.first + worst.last) / 2;
  worst.shown = worst.first;
  const auto off = [middle](std::size_t i) { return i > middle ? i - middle : middle - i; };
  for (std::size_t i = worst.first; i <= worst.last; ++i)
    if (scores[i] == worst.score && off(i) < off(worst.shown)) worst.shown = i;
  return worst;
}

Expected<MotionScores> scoreMotion(const mannequin::MotionClip& clip, const mannequin::Figure& figure,
                                   MotionMethod method, const MotionTask& task) {
  const auto map = mannequin::mapClip(clip);
  if (!map) return tl::unexpected(map.error());
  const auto motion = mannequin::retarget(figure, clip);
  if (!motion) return tl::unexpected(motion.error());
  if (motion->postures.empty()) return makeError({"", "frames", "none", "a motion", ""});
  MotionScores scores;
  scores.frame_time = motion->frame_time;
  FrameScorer scorer(figure, method, task);
  mannequin::ClipPose recorded;
  for (std::size_t i = 0; i < motion->postures.size(); ++i) {
    mannequin::placeJoints(clip, clip.frames[i], recorded);
    scores.frames.push_back(scorer.score(motion->postures[i], recordedAngles(*map, recorded)));
  }
  summarise(scores);
  mannequin::placeJoints(clip, clip.frames[scores.worst], recorded);
  scorer.explain(motion->postures[scores.worst], recordedAngles(*map, recorded), scores);
  return scores;
}

}  // namespace hapticell::ergonomics
