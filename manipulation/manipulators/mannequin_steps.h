// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/shapes/pose.h"
#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::manipulation {

using FootPlaces = std::array<Pose, 2>;  ///< X_WF of the left and the right foot.

/// A turn by `yaw` (rad) to the left about the vertical.
inline dquat turnedLeft(double yaw) {
  return glm::angleAxis(yaw, dvec3(0.0, 0.0, 1.0));
}

/// Reasons for a step.
struct StepWish {
  dvec3 missing_W{0.0};  ///< m that the hand lacks.
  double turn = 0.0;     ///< further rotation of the feet to the left, rad.
};

/// The intended poses of the feet: level, rotated only about the vertical since the figure was taken, at least one on
/// its floor.
FootPlaces standingFeet(const FootPlaces& taken, const FootPlaces& now);

/// Mean rotation of the feet to the left since the figure was taken, rad, -pi to pi.
double turnedFeet(const FootPlaces& taken, const FootPlaces& now);

/// The poses of feet with raised heels if they were level: rotated down about the balls, which are `ball_x` m ahead of
/// the ankles.
FootPlaces levelled(const FootPlaces& taken, const FootPlaces& now, double ball_x);

/// Rotation to the left of a pelvis at X_WR relative to the mean of the feet, rad, -pi to pi.
double headingBeside(const Pose& X_WR, const FootPlaces& feet);

/// The foot in the air; empty: both are on the floor.
std::optional<std::size_t> footInAir(const FootPlaces& taken, const FootPlaces& now);

/// The foot in the air or to be lifted next; empty: both are on the floor and no step would help. The rear foot steps
/// first; in a turn, the foot on the side of the turn.
std::optional<std::size_t> footToLift(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish);

/// The next poses of a figure's feet. One foot at a time is lifted by up to 40 mm, moves a stride ahead of the other
/// along the floor, turns by up to 35 deg against the other, and is put down. A stride is 0.20 m forward, or 0.18 m to
/// a side, after which the other foot follows; the feet never cross. If no step is wanted, a lifted foot is put down
/// where it is. The foot in motion is determined from `now`, so the function keeps no state.
///
/// `taken`: how the feet stood when the figure was taken (floor, stance, heading). No foot moves farther than `most`
/// (m) along the floor and as much up or down.
FootPlaces nextFeet(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish, double most);

/// Puts a lifted foot down at once where it is.
FootPlaces puttingDown(const FootPlaces& taken, const FootPlaces& now);

/// A posture that follows its feet: the pelvis moves by the mean of their motions, is rotated by `turn` (rad) about the
/// middle between them, and is placed so that neither leg is fully straight; the legs follow in closed form. The heel
/// of a lifted foot in `to` may rise for this. Empty if the limits of the legs do not allow it.
std::optional<mannequin::Posture> goneWith(const mannequin::Figure& figure, mannequin::Posture posture,
                                           const FootPlaces& from, FootPlaces& to, double turn = 0.0);

/// `there`, or the part of the motion from `start` to it for which the legs, in closed form, reach both feet exactly at
/// `feet`; `start` itself if no part does. So the feet do not slide, whatever the solver's remaining error.
mannequin::Posture stoodOn(const mannequin::Figure& figure, const mannequin::Posture& start,
                           const mannequin::Posture& there, const FootPlaces& feet);

}  // namespace hapticell::manipulation
