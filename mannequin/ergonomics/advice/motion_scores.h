// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/body/figure.h"
#include "mannequin/ergonomics/advice/method_advice.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::ergonomics {

enum class MotionMethod { kRula, kReba, kOwas };

/// Task data that the frames do not show, constant over the motion.
struct MotionTask {
  int muscle_use = 0;    ///< RULA, 0 or 1.
  int force = 0;         ///< RULA, 0 to 3.
  int load = 0;          ///< REBA, 0 to 3.
  int coupling = 0;      ///< REBA.
  int activity = 0;      ///< REBA.
  double load_kg = 0.0;  ///< OWAS.
};

struct FrameScore {
  int score = 0;
  int level = 0;
  int left = 0, right = 0;             ///< Of each arm's side; both equal for OWAS.
  double trunk_inclination = 0.0;      ///< Total angle to the vertical, degrees;
  double trunk_flexion = 0.0;          ///< forward in the plane that the hips face, backward negative;
  double trunk_side_bend = 0.0;        ///< out of that plane, left positive.
  double upper_arm_elevation[2] = {};  ///< Left, right, degrees.
};

struct MotionScores {
  double frame_time = 0.0;
  std::vector<FrameScore> frames{};
  std::map<int, double> share_by_level{};  ///< Share of the time, 0 to 1.
  std::map<int, double> share_by_score{};
  std::size_t worst = 0;  ///< The first frame with the highest score (among those, the most bent trunk).
  std::vector<std::optional<int>> worst_values{};  ///< Its sub-scores, for its worse side.
  MethodAdvice worst_advice{};                     ///< The reasons, and the nearest better posture.
};

/// Scores each frame of a recorded motion; the worse side counts. Joint angles come from the motion on `figure`; the
/// trunk's bends (of the line from mid-hip to the lowest neck joint) and the upper arms' angles are from the joints of
/// the recorded person. Nobody is assumed to be seated or walking; arms are not supported. Errors: no frames.
Expected<MotionScores> scoreMotion(const mannequin::RecordedMotion& recorded, const mannequin::Figure& figure,
                                   MotionMethod method, const MotionTask& task);
/// The same for a clip, with the errors of recordedMotion().
Expected<MotionScores> scoreMotion(const mannequin::MotionClip& clip, const mannequin::Figure& figure,
                                   MotionMethod method, const MotionTask& task);

/// A stretch of a motion during which the score is at its highest; frames, both ends included.
struct ScorePhase {
  std::size_t first = 0, last = 0;
  std::size_t shown = 0;  ///< The frame with the highest score that is nearest to its middle.
  int score = 0;
};

/// The longest stretch at the highest score. Within it the score may fall for up to 0.2 s, because it flickers near the
/// boundary of a class. Of equally long ones the first. No scores: a phase of score 0. `frame_time` in s.
ScorePhase worstPhase(std::span<const int> scores, double frame_time);

}  // namespace hapticell::ergonomics
