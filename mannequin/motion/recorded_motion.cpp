// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/recorded_motion.h"

#include <algorithm>
#include <cctype>

#include "geometry/system/text_case.h"
#include "mannequin/motion/body_frames.h"
#include "mannequin/motion/clip_map.h"
#include "mannequin/motion/marker_body.h"

namespace hapticell::mannequin {

namespace {

// Moments looked at, for a mean direction. Half, twice: no effect but time on motions of a person.
constexpr std::size_t kPostureSamples = 400;

/// From the ankles to the head, moment by moment, in the clip's axes.
std::vector<dvec3> upwardsOf(const MotionClip& clip, const ClipMap& map) {
  std::vector<dvec3> upwards;
  const std::size_t every = std::max<std::size_t>(1, clip.frames.size() / kPostureSamples);
  ClipPose pose;
  for (std::size_t f = 0; f < clip.frames.size(); f += every) {
    placeJoints(clip, clip.frames[f], pose);
    const auto p = [&](int joint) { return pose.p[static_cast<std::size_t>(joint)]; };
    upwards.push_back(p(map.head) - 0.5 * (p(map.ankle[0]) + p(map.ankle[1])));
  }
  return upwards;
}

UpAxis upOf(const MotionClip& clip, const ClipMap& map, const MotionReading& reading, std::vector<Text>& assumptions) {
  const std::optional<UpAxis> seen = upAxisOf(upwardsOf(clip, map));
  const auto axis = [](UpAxis up) { return Text("the file's %1 axis", nameOf(up)); };
  if (reading.up) {
    assumptions.push_back(
        seen && *seen != *reading.up
            ? Text("%1 is used as up, as set; the head is above the feet along %2", axis(*reading.up), axis(*seen))
            : Text("%1 is used as up, as set", axis(*reading.up)));
    return *reading.up;
  }
  if (seen) {
    assumptions.push_back(Text("%1 is used as up: the head is above the feet along it", axis(*seen)));
    return *seen;
  }
  assumptions.push_back(
      Text("the posture does not show which axis is up (the person lies or turns over); y is assumed, as usual in BVH "
           "and ASF; to change this, use --up"));
  return UpAxis::kY;
}

}  // namespace

Expected<RecordedMotion> recordedMotion(const MotionClip& clip, const MotionReading& reading) {
  const Expected<ClipMap> map = mapJoints(clip);
  HAPTICELL_TRY(map);
  RecordedMotion motion;
  motion.frame_time = clip.frame_time;
  motion.metres_per_unit = clip.metres_per_unit;
  motion.assumptions = clip.warnings;
  motion.up = upOf(clip, *map, reading, motion.assumptions);
  // A skeleton that faces its z axis with y up faces the world's x.
  const dmat3 quarter(dvec3(0, 1, 0), dvec3(-1, 0, 0), dvec3(0, 0, 1));
  const BodyFrames frames(clip, *map, quarter * uprightTurn(motion.up));
  motion.assumptions.insert(motion.assumptions.end(), frames.assumptions().begin(), frames.assumptions().end());
  motion.bodies.reserve(clip.frames.size());
  ClipPose pose;
  for (const ClipFrame& frame : clip.frames) {
    placeJoints(clip, frame, pose);
    motion.bodies.push_back(frames.bodyAt(pose));
    const RecordedBody& body = motion.bodies.back();
    for (std::size_t i = 0; i < 2; ++i) {
      const double least = std::min({glm::length(body.knee[i] - body.hip[i]), glm::length(body.ankle[i] - body.knee[i]),
                                     glm::length(body.elbow[i] - body.shoulder[i]),
                                     glm::length(body.hand[i] - body.elbow[i]), glm::length(body.neck - body.p_root)});
      if (least > 1e-4) continue;
      return makeError({.place = Text("frame %1", motion.bodies.size()),
                        .found = "bones of length zero",
                        .expected = "arms, legs and a trunk with lengths above 0"});
    }
  }
  return motion;
}

namespace {

Expected<RecordedMotion> recordedMarkers(const std::filesystem::path& file, const MotionReading& reading) {
  const Expected<MarkerClip> clip = readC3d(file, reading.up);
  HAPTICELL_TRY(clip);
  const Expected<MarkerSet> set =
      reading.markers.empty() ? recogniseMarkers(*clip) : readMarkerTable(reading.markers, *clip);
  HAPTICELL_TRY(set);
  return recordedMotion(*clip, *set);
}

Expected<RecordedMotion> recordedSkeleton(const std::filesystem::path& file, const MotionReading& reading) {
  if (!reading.markers.empty())
    return makeError({.file = file.string(),
                      .place = Text::plain("--markers"),
                      .found = "a table of markers for a skeleton",
                      .expected = "a recording in C3D"});
  const Expected<MotionClip> clip = readMotionFile(file);
  HAPTICELL_TRY(clip);
  return recordedMotion(*clip, reading);
}

}  // namespace

Expected<RecordedMotion> readRecordedMotion(const std::filesystem::path& file, const MotionReading& reading) {
  const std::string ending = lowerExtension(file);
  Expected<RecordedMotion> motion = ending == ".c3d" ? recordedMarkers(file, reading) : recordedSkeleton(file, reading);
  if (!motion && motion.error().file.empty()) motion.error().file = file.string();
  return motion;
}

}  // namespace hapticell::mannequin
