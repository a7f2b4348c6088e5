// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/motion_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"
#include "mannequin/ergonomics/scores/figure_measurement.h"
#include "mannequin/motion/retarget.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

/// What the places of the recorded joints tell by themselves; arms left, right.
struct Recorded {
  PlaneAngles trunk, arm[2];
};

Recorded recordedAngles(const mannequin::RecordedBody& body) {
  // The hips' line says which way they face.
  ViewPlanes hips{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
  const dvec3 to_left = body.hip[0] - body.hip[1];
  const dvec3 level_left(to_left.x, to_left.y, 0.0);
  if (glm::length(level_left) > 1e-3 * glm::length(to_left)) hips.outward = glm::normalize(level_left);
  hips.forward = glm::cross(hips.outward, hips.up);
  const dvec3 line = body.neck - body.p_root;
  Recorded recorded;
  recorded.trunk = trunkAngles(hips, line);
  ViewPlanes chest;
  chest.up = glm::normalize(line);
  const dvec3 across = body.shoulder[0] - body.shoulder[1];
  chest.outward = glm::normalize(across - glm::dot(across, chest.up) * chest.up);
  chest.forward = glm::cross(chest.outward, chest.up);
  for (std::size_t side = 0; side < 2; ++side) {
    recorded.arm[side] = upperArmAngles(chest, body.elbow[side] - body.shoulder[side]);
    chest.outward = -chest.outward;
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

  /// `recorded` replaces the bends of the figure's trunk and its upper arms: they need no model.
  FrameScore score(const mannequin::Posture& posture, const Recorded& recorded) {
    const auto pose = mannequin::forwardKinematics(figure_, posture);
    FrameScore frame;
    frame.trunk_inclination = recorded.trunk.elevation;
    frame.trunk_flexion = recorded.trunk.flexion;
    frame.trunk_side_bend = recorded.trunk.sideways;
    for (std::size_t side = 0; side < 2; ++side) frame.upper_arm_elevation[side] = recorded.arm[side].elevation;
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
    whole.trunk_flexion = recorded.trunk.flexion;
    whole.trunk_side_bend = recorded.trunk.sideways;
    whole.load_kg = task_.load_kg;
    return whole;
  }

  PostureAngles anglesOf(const mannequin::Posture& posture, const mannequin::FigurePose& pose, Side side,
                         const Recorded& recorded) const {
    MeasuredPosture measured = measure(figure_, posture, pose, side);
    measured.trunk_flexion = recorded.trunk.flexion;
    measured.trunk_side_bend = recorded.trunk.sideways;
    const PlaneAngles& arm = recorded.arm[static_cast<std::size_t>(side)];
    measured.upper_arm_flexion = arm.flexion;
    measured.upper_arm_abduction = arm.sideways;
    measured.upper_arm_elevation = arm.elevation;
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
    if (frame.score > worst.score ||
        (frame.score == worst.score && frame.trunk_inclination > worst.trunk_inclination)) {
      scores.worst = i;
    }
  }
}

// s: shorter than a person takes to move out of a posture and back. Our choice. Half: noise at a limit of a class
// splits the worst phase; twice: short pauses count to it.
constexpr double kFlicker = 0.2;

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

Expected<MotionScores> scoreMotion(const mannequin::RecordedMotion& recorded, const mannequin::Figure& figure,
                                   MotionMethod method, const MotionTask& task) {
  const auto motion = mannequin::retarget(figure, recorded);
  HAPTICELL_TRY(motion);
  if (motion->postures.empty()) return makeError({.place = "frames", .found = "none", .expected = "a motion"});
  MotionScores scores;
  scores.frame_time = motion->frame_time;
  FrameScorer scorer(figure, method, task);
  for (std::size_t i = 0; i < motion->postures.size(); ++i)
    scores.frames.push_back(scorer.score(motion->postures[i], recordedAngles(recorded.bodies[i])));
  summarise(scores);
  scorer.explain(motion->postures[scores.worst], recordedAngles(recorded.bodies[scores.worst]), scores);
  return scores;
}

Expected<MotionScores> scoreMotion(const mannequin::MotionClip& clip, const mannequin::Figure& figure,
                                   MotionMethod method, const MotionTask& task) {
  const auto recorded = mannequin::recordedMotion(clip);
  HAPTICELL_TRY(recorded);
  return scoreMotion(*recorded, figure, method, task);
}

}  // namespace hapticell::ergonomics
