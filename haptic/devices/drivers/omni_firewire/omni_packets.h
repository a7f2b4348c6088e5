// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geometry/shapes/vector.h"

namespace hapticell::driver {

/// Content of a Phantom Omni's isochronous packet of 64 bytes. Layout according to raw_omni and phantom-drivers.
struct OmniReading {
  std::array<int, 3> encoders{};          ///< Counts: x, y, z.
  std::array<double, 3> gimbal_ratios{};  ///< A / (A + B) of each potentiometer, 0 .. 1.
  bool button1 = false, button2 = false, docked = false;
  std::uint32_t packet = 0;  ///< Counts up.
};

/// Empty if the packet is too short or a gimbal's two halves are both zero.
std::optional<OmniReading> readOmniPacket(std::span<const std::uint8_t> bytes);

/// The 16 bytes to the device: joint commands of -1 .. 1 (clamped; NaN becomes 0), motors, the dock's light.
std::array<std::uint8_t, 16> makeOmniPacket(const dvec3& commands, bool motors, bool light);

/// The serial number as the maker prints it, from the quadlet at 0x10060010.
std::string omniSerial(std::uint32_t quadlet);

}  // namespace hapticell::driver
