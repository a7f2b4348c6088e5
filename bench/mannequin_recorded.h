// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/motion/motion_clip.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::bench {

/// How near a posture that is told only where hands and feet are comes to the recorded one.
struct RecordedError {
  double trunk_deg = 0.0;       ///< Mean difference of the inclination (middle of the hips to the lowest neck joint).
  double trunk_axis_deg = 0.0;  ///< Mean angle between those lines.
  double swivel_deg = 0.0;      ///< Mean of both elbows, flexed over 20 deg.
  double elbow_mm = 0.0;        ///< Mean.
  double median_us = 0.0;       ///< Processor time a frame.
  double worst_hand_mm = 0.0;
  int frames = 0;
};

/// Replays a clip at 60 Hz on the figure: each frame's hands and feet (six degrees of freedom each) are asked of the
/// solver, which starts from its own last answer. Balance is not asked: recorded people fall forward as they walk.
RecordedError replayHandsAndFeet(const mannequin::Figure& figure, const mannequin::MotionClip& clip);

}  // namespace hapticell::bench
