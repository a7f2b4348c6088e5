// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::driver {

/// One Inverse3 and its grip in a message of Haply's service.
struct HaplyReport {
  std::string device_id;
  dvec3 cursor{0.0};  ///< m, the service's axes: x right, y away, z up.
  std::optional<dquat> orientation;
  std::uint32_t buttons = 0;  ///< a, b, c.
};

/// Reads a message: {"inverse3":[{"device_id":..., "state":{"cursor_position":{"x","y","z"}}}],
/// "wireless_verse_grip":[{"state":{"orientation":{"x","y","z","w"},"buttons":{"a","b","c"}}}]}. Empty if the text is
/// not JSON, a number is missing or not finite, or a quaternion is invalid. A message without an Inverse3 gives an
/// empty list.
std::optional<std::vector<HaplyReport>> readHaplyMessage(const std::string& text);

/// The command that exerts `force` (N, the service's axes) on that device's cursor.
std::string haplyForceCommand(const std::string& device_id, const dvec3& force);

}  // namespace hapticell::driver
