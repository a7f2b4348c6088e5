// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/falcon/falcon_packets.h"

namespace hapticell::driver {

namespace {

constexpr std::uint8_t kFirstLetter = 'A';

std::optional<FalconPacket> decode(std::span<const std::uint8_t> body) {
  FalconPacket packet;
  for (std::size_t i = 0; i < 12; ++i) {
    if (body[i] < kFirstLetter || body[i] > kFirstLetter + 15) return std::nullopt;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    unsigned value = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      value |= static_cast<unsigned>(body[4 * axis + nibble] - kFirstLetter) << (4 * nibble);
    }
    packet.values[axis] = static_cast<std::int16_t>(value);
  }
  if (body[12] < kFirstLetter || body[12] > kFirstLetter + 0x7F) return std::nullopt;
  packet.bits = static_cast<std::uint8_t>(body[12] - kFirstLetter);
  return packet;
}

}  // namespace

std::array<std::uint8_t, kFalconPacketSize> encodeFalcon(const FalconPacket& packet) {
  std::array<std::uint8_t, kFalconPacketSize> bytes{};
  bytes[0] = '<';
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = static_cast<std::uint16_t>(packet.values[axis]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      bytes[1 + 4 * axis + nibble] = static_cast<std::uint8_t>(kFirstLetter + ((value >> (4 * nibble)) & 0xF));
    }
  }
  bytes[13] = static_cast<std::uint8_t>(kFirstLetter + packet.bits);
  bytes[14] = kFirstLetter;
  bytes[15] = '>';
  return bytes;
}

std::optional<FalconPacket> FalconReader::take(std::span<const std::uint8_t> bytes) {
  std::optional<FalconPacket> newest;
  for (const std::uint8_t byte : bytes) {
    if (byte == '<' && (pending_.empty() || pending_.size() < kFalconPacketSize - 1)) {
      if (!pending_.empty()) ++garbled_;  // The one before was cut short.
      pending_.clear();
    }
    if (pending_.empty() && byte != '<') continue;
    pending_.push_back(byte);
    if (pending_.size() < kFalconPacketSize) continue;
    const auto packet = pending_.back() == '>' ? decode(std::span(pending_).subspan(1)) : std::nullopt;
    if (packet)
      newest = packet;
    else
      ++garbled_;
    pending_.clear();
  }
  return newest;
}

}  // namespace hapticell::driver
