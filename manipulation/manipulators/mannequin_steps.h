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

/// Why feet step.
struct StepWish {
  dvec3 missing_W{0.0};  ///< m that the hand lacks.
  double turn = 0.0;     ///< rad to the left by which the feet should head farther round.
};

/// The places of feet as they are meant: level and turned only about the vertical from how they were when the figure
/// was taken, at least one on its floor.
FootPlaces standingFeet(const FootPlaces& taken, const FootPlaces& now);

/// rad to the left that the feet head farther round than when the figure was taken, in the mean, -pi to pi.
double turnedFeet(const FootPlaces& taken, const FootPlaces& now);

/// Feet whose heels are raised, as they would be level: turned down about their balls, which are `ball_x` m ahead of
/// the ankles.
FootPlaces levelled(const FootPlaces& taken, const FootPlaces& now, double ball_x);

/// rad to the left that a pelvis at X_WR heads beside the mean of the feet, -pi to pi.
double headingBeside(const Pose& X_WR, const FootPlaces& feet);

/// The foot that is in the air; nothing: both stand.
std::optional<std::size_t> footInAir(const FootPlaces& taken, const FootPlaces& now);

/// The foot that is in the air or is to be lifted next; nothing: both stand, and nothing is wanted that a step would
/// help. Behind goes before, and in a turn the foot of the side that it goes to.
std::optional<std::size_t> footToLift(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish);

/// Where the feet of a figure go next: one foot at a time is lifted by up to 40 mm, goes a stride ahead of the other
/// along the floor, turns by up to 35 deg against the other, and is put down; forward by 0.20 m, to a side by 0.18 m
/// with the other foot closing up, and never across each other. Where nothing is wanted a lifted foot is put down where
/// it is. Which foot is on its way is read from `now`, so the answer depends on nothing else.
///
/// `taken`: how the feet stood when the figure was taken (floor, stance, heading). No foot moves farther than `most`
/// (m) along the floor and as much up or down.
FootPlaces nextFeet(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish, double most);

/// A lifted foot put down at once where it is.
FootPlaces puttingDown(const FootPlaces& taken, const FootPlaces& now);

/// A posture that goes along with its feet: the pelvis by the mean of their ways, turned by `turn` (rad) about the
/// middle between them, and to where neither leg is quite straight; the legs follow in closed form. The heel of a
/// lifted foot in `to` may rise for it. Nothing where the limits of the legs do not let them.
std::optional<mannequin::Posture> goneWith(const mannequin::Figure& figure, mannequin::Posture posture,
                                           const FootPlaces& from, FootPlaces& to, double turn = 0.0);

/// `there`, or as much of the way to it from `start` as the legs, in closed form, let both feet be exactly where `feet`
/// has them; `start` itself where that is nothing. No foot glides by it, whatever the solver left.
mannequin::Posture stoodOn(const mannequin::Figure& figure, const mannequin::Posture& start,
                           const mannequin::Posture& there, const FootPlaces& feet);

}  // namespace hapticell::manipulation
