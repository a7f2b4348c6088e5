// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/omni_firewire/omni_packets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hapticell::driver {

namespace {

constexpr std::size_t kLeast = 36;  // Bytes up to the packet's number.
constexpr int kZero = 0x7FF, kMost = 4095;
constexpr std::uint16_t kStatus = 0x53C0, kLight = 0x3, kMotors = 0x8;

unsigned word(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<unsigned>(bytes[at] | (bytes[at + 1] << 8));
}

void put(std::array<std::uint8_t, 16>& bytes, std::size_t at, unsigned value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>(value >> 8);
}

}  // namespace

std::optional<OmniReading> readOmniPacket(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kLeast) return std::nullopt;
  OmniReading reading;
  for (std::size_t i = 0; i < 3; ++i) {
    reading.encoders[i] = static_cast<std::int16_t>(word(bytes, 4 + 2 * i));
    const unsigned a = word(bytes, 10 + 2 * i), b = word(bytes, 22 + 2 * i);
    if (a + b == 0) return std::nullopt;
    reading.gimbal_ratios[i] = static_cast<double>(a) / (a + b);
  }
  reading.button1 = (bytes[19] & 1) == 0;
  reading.button2 = (bytes[19] & 2) == 0;
  reading.docked = (bytes[19] & 4) == 0;
  reading.packet = word(bytes, 32) | word(bytes, 34) << 16;
  return reading;
}

std::array<std::uint8_t, 16> makeOmniPacket(const dvec3& commands, bool motors, bool light) {
  std::array<std::uint8_t, 16> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double wanted = motors && std::isfinite(commands[i]) ? std::clamp(commands[i], -1.0, 1.0) : 0.0;
    const int value = std::clamp(kZero + static_cast<int>(std::lround(wanted * (kMost - kZero))), 0, kMost);
    put(bytes, 2 * i, static_cast<unsigned>(value));
  }
  put(bytes, 6, static_cast<unsigned>(kStatus | (light ? kLight : 0) | (motors ? kMotors : 0)));
  return bytes;
}

std::string omniSerial(std::uint32_t q) {
  char text[32];
  std::snprintf(text, sizeof text, "%1u%02u%02u%1u%05u", q >> 23 & 7u, q >> 19 & 15u, q >> 14 & 31u, q >> 11 & 7u,
                q >> 1 & 1023u);
  return text;
}

}  // namespace hapticell::driver
