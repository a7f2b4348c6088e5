// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/pose.h"
#include "mannequin/figure.h"
#include "mannequin/posture.h"

namespace hapticell::manipulation {

using FootPlaces = std::array<Pose, 2>;  ///< X_WF of the left and the right foot.

/// The places of feet as they are meant: turned as they were when the figure was taken, at least one on its floor.
FootPlaces standingFeet(const FootPlaces& taken, const FootPlaces& now);

/// Where the feet of a figure go next while its hand lacks `missing_W` (m): one foot at a time is lifted by up to 40
/// mm, goes a stride ahead of the other along the floor, and is put down; forward by 0.20 m, to a side by 0.18 m with
/// the other foot closing up, and never across each other. Where nothing is missing a lifted foot is put down where it
/// is. Which foot is on its way is read from `now`, so the answer depends on nothing else.
///
/// `taken`: how the feet stood when the figure was taken (floor, stance, heading). No foot moves farther than `most`
/// (m) along the floor and as much up or down.
FootPlaces nextFeet(const FootPlaces& taken, const FootPlaces& now, const dvec3& missing_W, double most);

/// A lifted foot brought back towards its place beside the other, by `most` (m).
FootPlaces homeward(const FootPlaces& taken, const FootPlaces& now, double most);

/// A posture that goes along with its feet: the pelvis by the mean of their ways, and to where neither leg is quite
/// straight; the legs follow in closed form. The heel of a lifted foot in `to` may rise for it. Nothing where the
/// limits of the legs do not let them.
std::optional<mannequin::Posture> goneWith(const mannequin::Figure& figure, mannequin::Posture posture,
                                           const FootPlaces& from, FootPlaces& to);

}  // namespace hapticell::manipulation
