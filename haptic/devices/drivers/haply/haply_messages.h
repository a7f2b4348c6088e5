// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::driver {

/// What a message of Haply's service tells about one Inverse3 and the grip on it.
struct HaplyReport {
  std::string device_id;
  dvec3 cursor{0.0};  ///< m, the service's axes: x right, y away, z up.
  std::optional<dquat> orientation;
  std::uint32_t buttons = 0;  ///< a, b, c.
};

/// Reads a message: {"inverse3":[{"device_id":..., "state":{"cursor_position":{"x","y","z"}}}],
/// "wireless_verse_grip":[{"state":{"orientation":{"x","y","z","w"},"buttons":{"a","b","c"}}}]}. Nothing where it is no
/// JSON, a number is missing or not finite, or a quaternion is none. A message without an Inverse3 is an empty list.
std::optional<std::vector<HaplyReport>> readHaplyMessage(const std::string& text);

/// The command that exerts `force` (N, the service's axes) on that device's cursor.
std::string haplyForceCommand(const std::string& device_id, const dvec3& force);

}  // namespace hapticell::driver
