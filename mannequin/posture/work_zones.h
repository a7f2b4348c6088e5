// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture.h"
#include "mannequin/posture/vision.h"

namespace hapticell::mannequin {

/// Working zones similar to those of EN ISO 14738, as closed volumes in the world. The standard's figures are for
/// percentiles of a population; here the same zones are built from the measures of this figure, and their bounds are
/// our choice (docs/dev/mannequin.md).
enum class WorkZone {
  kPreferred,   ///< From 50 mm under elbow height to half way to the shoulder, within the forearm's grip radius.
  kAcceptable,  ///< From elbow rest to shoulder height, within 0.9 of the arm's grip radius.
};
geometry::TriangleMesh workZone(const Figure& figure, const Posture& posture, WorkZone zone);

/// The visual field up to `length` (m), as a closed volume about the line of sight: within 15 deg preferred; range of
/// the eyes (35 deg to the side, 20 up, 40 down); range of the head (60 to the side, 60 up and down).
geometry::TriangleMesh visionVolume(const Figure& figure, const FigurePose& pose, const Gaze& gaze, VisionZone zone,
                                    double length);

}  // namespace hapticell::mannequin
