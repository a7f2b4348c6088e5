// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {

/// The part of the body that must move for a figure to look at something (NUREG-0700 rev. 3; EN ISO 14738 uses similar
/// zones).
enum class VisionZone : std::uint8_t {
  kPreferred,  ///< Within 15 deg of the line of sight, eyes at rest.
  kEyes,       ///< Eyes turn: 35 deg to the side, 20 deg up, 40 deg down.
  kHead,       ///< The head turns too: 60 deg to the side, 75 deg up.
  kOutside,    ///< Only with a turn of the trunk.
};
const char* wordOf(VisionZone zone);

/// A target seen from between the eyes.
struct Sight {
  dvec3 p_WEyes{0.0};
  double distance = 0.0;   ///< m
  double azimuth = 0.0;    ///< rad, to the left of where the head faces.
  double elevation = 0.0;  ///< rad, above.
  VisionZone zone = VisionZone::kOutside;
};
Sight sightOf(const Figure& figure, const FigurePose& pose, const dvec3& p_WTarget);

/// The camera of the figure's eyes: looks along its -z, x to the right, y up, turned by the gaze.
Pose eyePose(const Figure& figure, const FigurePose& pose, const Gaze& gaze);

/// Gaze that looks at a target, kept within its limits.
Gaze gazeAt(const Figure& figure, const FigurePose& pose, const dvec3& p_WTarget);

}  // namespace hapticell::mannequin
