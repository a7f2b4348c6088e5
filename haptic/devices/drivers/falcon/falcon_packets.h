// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hapticell::driver {

/// A packet of the Falcon's firmware, the same in both directions: '<', three 16-bit numbers of four letters each (low
/// nibble first, each nibble + 'A'), a letter of bits, another letter, '>'.
struct FalconPacket {
  std::array<std::int16_t, 3> values{};  ///< Out: motors; in: encoders.
  std::uint8_t bits = 0;                 ///< Out: kLights, kHoming; in: buttons, and one bit per homed motor.
};

inline constexpr std::uint8_t kFalconHoming = 1, kFalconGreen = 2, kFalconBlue = 4, kFalconRed = 8;  // Out.
inline constexpr std::uint8_t kFalconHomed = 0x70;                                                   // In.
inline constexpr std::size_t kFalconPacketSize = 16;

std::array<std::uint8_t, kFalconPacketSize> encodeFalcon(const FalconPacket& packet);

/// Finds packets in the device's bytes. A packet that has a wrong length or an invalid letter is counted and discarded.
class FalconReader {
 public:
  /// Takes bytes; returns the newest complete packet, if there is one.
  std::optional<FalconPacket> take(std::span<const std::uint8_t> bytes);
  std::size_t garbled() const { return garbled_; }
  void clear() { pending_.clear(); }

 private:
  std::vector<std::uint8_t> pending_;
  std::size_t garbled_ = 0;
};

}  // namespace hapticell::driver
