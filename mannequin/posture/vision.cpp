// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/vision.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

const char* wordOf(VisionZone zone) {
  constexpr const char* kWords[] = {"preferred", "eyes", "head", "outside"};
  return kWords[static_cast<std::size_t>(zone)];
}

Sight sightOf(const Figure& figure, const FigurePose& pose, const dvec3& p_WTarget) {
  const SegmentPlace& head = pose[Segment::kHead];
  Sight sight;
  sight.p_WEyes = head.point(figure.p_HeadEyes);
  const dvec3 d = glm::transpose(head.R_WS) * (p_WTarget - sight.p_WEyes);
  sight.distance = glm::length(d);
  sight.azimuth = std::atan2(d.y, d.x);
  sight.elevation = std::atan2(d.z, std::hypot(d.x, d.y));
  const double side = std::abs(sight.azimuth), off = std::atan2(std::hypot(d.y, d.z), d.x);
  const bool eyes_reach = sight.elevation <= kGazeUpLimit && sight.elevation >= -kGazeDownLimit;
  if (off <= 15.0 * kDegree) {
    sight.zone = VisionZone::kPreferred;
  } else if (side <= kGazeYawLimit && eyes_reach) {
    sight.zone = VisionZone::kEyes;
  } else if (side <= 60.0 * kDegree && std::abs(sight.elevation) <= 75.0 * kDegree) {
    sight.zone = VisionZone::kHead;
  }
  return sight;
}

Pose eyePose(const Figure& figure, const FigurePose& pose, const Gaze& gaze) {
  const SegmentPlace& head = pose[Segment::kHead];
  const dmat3 looking = head.R_WS * aboutZ(gaze.yaw) * aboutY(gaze.pitch);
  // A camera's x is to the right, y up, and it looks along -z.
  const dmat3 camera(-looking[1], looking[2], -looking[0]);
  return {head.point(figure.p_HeadEyes), glm::normalize(glm::quat_cast(camera))};
}

Gaze gazeAt(const Figure& figure, const FigurePose& pose, const dvec3& p_WTarget) {
  const Sight sight = sightOf(figure, pose, p_WTarget);
  return {std::clamp(sight.azimuth, -kGazeYawLimit, kGazeYawLimit),
          std::clamp(-sight.elevation, -kGazeUpLimit, kGazeDownLimit)};
}

}  // namespace hapticell::mannequin
