// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

namespace hapticell::exchange::topics {

// Names of topics, frames, schemas and metadata in the files that this program writes (docs/user/recordings-mcap.md).
// Topics of a motion stand behind its prefix: "" for the first, "/motion_1" for the second.

inline constexpr std::string_view kJoints = "/joint_states", kMoved = "/moved/pose", kTransforms = "/tf",
                                  kWrench = "/moved/wrench", kState = "/moved/state", kPoints = "/moved/points",
                                  kTouches = "/moved/contacts";
inline constexpr std::string_view kStylus = "/stylus/pose", kProxy = "/stylus/proxy", kForce = "/stylus/wrench",
                                  kButtons = "/stylus/buttons", kHeld = "/stylus/moved";
inline constexpr std::string_view kContacts = "/contacts", kScores = "/score";
inline constexpr const char* kWorldFrame = "world";
inline constexpr const char* kDeviceFrame = "device";
inline constexpr const char* kMotionMetadata = "hapticell_motion";
inline constexpr const char* kRecordingMetadata = "hapticell_recording";

inline constexpr const char* kContactSchema =
    R"({"title":"hapticell.Contact","type":"object","properties":{"first":{"type":"string"},"second":{"type":"string"},)"
    R"("time_in":{"type":"number"},"time_out":{"type":"number"},"max_force":{"type":"number"}}})";
inline constexpr const char* kStateSchema =
    R"({"title":"hapticell.State","type":"object","properties":{"force_x":{"type":"number"},"force_y":{"type":"number"},)"
    R"("force_z":{"type":"number"},"contact":{"type":"number"},"configuration":{"type":"number"}}})";
inline constexpr const char* kPointSchema =
    R"({"title":"hapticell.Point","type":"object","properties":{"frame":{"type":"integer"},"name":{"type":"string"},)"
    R"("by_hand":{"type":"boolean"},"dwell":{"type":"number"},"pose_apart":{"type":"boolean"}}})";
inline constexpr const char* kScoreSchema =
    R"({"title":"hapticell.Score","type":"object","properties":{"trainee":{"type":"string"},"exercise":{"type":"string"},)"
    R"("date":{"type":"string"},"kind":{"type":"string"},"help":{"type":"number"},"success":{"type":"boolean"},)"
    R"("points":{"type":"number"},"completed":{"type":"number"},"time":{"type":"number"},)"
    R"("mean_deviation":{"type":"number"},"max_deviation":{"type":"number"},"mean_force":{"type":"number"},)"
    R"("max_force":{"type":"number"},"smoothness":{"type":"number"},"contacts":{"type":"integer"}}})";

/// Seconds as whole nanoseconds, to the nearest.
inline std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

}  // namespace hapticell::exchange::topics
