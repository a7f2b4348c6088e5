// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::workcell {

/// What a guide (virtual fixture; L. Rosenberg, 1993) lets the moved frame M of its entity do.
enum class GuideKind {
  kPoint,    ///< M stays at the guide's origin; it may turn.
  kLine,     ///< M stays on the z axis.
  kPlane,    ///< M stays in the plane normal to z.
  kCircle,   ///< M stays on a circle of `radius` about z.
  kHinge,    ///< The entity only rotates about z, from its pose when it is taken.
  kSlider,   ///< The entity only slides along z.
  kScrew,    ///< The entity turns about z and advances `pitch` a turn.
  kTube,     ///< M stays within `radius` of the path.
  kSurface,  ///< M stays at `offset` from the surface of the entity `surface`.
  kLock,     ///< M keeps the locked directions of the guide's axes.
};

/// A guide of the workcell: a virtual fixture bound to one entity, felt while that is held.
///
/// Positions along a hinge are radians, along a slider or a line metres, from the entity's placement in the document.
struct Guide {
  std::string name;  ///< Unique among the guides.
  GuideKind kind = GuideKind::kLine;
  std::string entity;  ///< Bound to it, by name.
  bool enabled = true;
  Pose X_WG;                                     ///< Origin and axes; z is the axis or the normal.
  double radius = 0.05;                          ///< m, above 0: circle, tube.
  double pitch = 0.001;                          ///< m a turn: screw.
  double offset = 0.0;                           ///< m, 0 or more: surface.
  std::string surface;                           ///< Surface: the name of the entity whose surface is followed.
  std::optional<double> lower = {}, upper = {};  ///< Stops of line, slider and hinge.
  double friction = 0.0;                         ///< N, dry, 0 to 3.
  std::vector<double> detents;                   ///< Where it snaps in: line, slider, hinge.
  double detent_width = 0.01;                    ///< m to either side, above 0.
  double detent_stiffness = 200.0;               ///< N/m, 0 to 500.
  std::vector<dvec3> path;                       ///< Tube: at least two points in the cell.
  double help = 0.0;                             ///< N/m towards the path's middle: tube; 0 to 500.
  /// Tube: m, 0 to 1, that the help pulls ahead along the path: the hand is led. 0: only to the middle.
  double lead = 0.0;
  std::array<bool, 6> locked{};  ///< Lock: x y z, then turning about them.
};

/// Refuses values that are not finite or out of range, with what was found.
Expected<void> checkGuide(const Guide& guide);

}  // namespace hapticell::workcell
