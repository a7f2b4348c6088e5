// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hapticell::driver {

/// A packet of the Falcon's firmware, the same in both directions: '<', three 16-bit numbers of four letters each (low
/// nibble first, each nibble + 'A'), a letter of bits, a letter more, '>'.
struct FalconPacket {
  std::array<std::int16_t, 3> values{};  ///< Out: motors; in: encoders.
  std::uint8_t bits = 0;                 ///< Out: kLights, kHoming; in: buttons, and a bit a motor that is homed.
};

inline constexpr std::uint8_t kFalconHoming = 1, kFalconGreen = 2, kFalconBlue = 4, kFalconRed = 8;  // Out.
inline constexpr std::uint8_t kFalconHomed = 0x70;                                                   // In.
inline constexpr std::size_t kFalconPacketSize = 16;

std::array<std::uint8_t, kFalconPacketSize> encodeFalcon(const FalconPacket& packet);

/// Finds packets in what the device sends. One that is short, long or holds what is no letter of these is garbage: it
/// is counted and left out, never taken for another.
class FalconReader {
 public:
  /// Takes bytes; the newest whole packet among them, if there is one.
  std::optional<FalconPacket> take(std::span<const std::uint8_t> bytes);
  std::size_t garbled() const { return garbled_; }
  void clear() { pending_.clear(); }

 private:
  std::vector<std::uint8_t> pending_;
  std::size_t garbled_ = 0;
};

}  // namespace hapticell::driver
