// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hapticell::driver {

/// How a CyberGlove sends.
struct GloveFormat {
  std::size_t sensors = 22;  ///< 18 or 22.
  bool status = false;       ///< A status byte behind the readings (8 bits only).
  bool wide = false;         ///< 16 bits a sensor, with time stamps (CyberGlove III); else 8.
};

/// One sample of all sensors.
struct GloveSample {
  std::array<double, 22> readings{};  ///< 0 .. 255, those of 16 bits scaled to it.
  std::size_t count = 0;
  bool has_status = false, switch_on = false, light_on = false, glove_in = false;
};

/// Finds samples in a stream of bytes, whatever is between them.
///
/// 8 bits: 'G' or 'S', the readings (1 .. 255), the status byte where enabled, 0x00. Nothing but the end is ever 0x00,
/// so that frames; there is no checksum, so a frame of another length is garbage as a whole. 16 bits: 0D 0A 00, a time
/// stamp of 14 bytes ending in 'S', the readings big-endian in 1 .. 4094; any of these bytes may also stand in the
/// data, so that a frame counts only when all of it fits.
class GloveFrames {
 public:
  explicit GloveFrames(const GloveFormat& format) : format_(format) {}

  /// Takes bytes; the newest whole sample among them, if there is one, goes to `sample`. True when there is.
  bool take(std::span<const std::uint8_t> bytes, GloveSample& sample);
  /// Frames that were not as they should be, so far.
  std::size_t garbled() const { return garbled_; }

 private:
  bool takeNarrow(std::uint8_t byte, GloveSample& sample);
  bool takeWide(GloveSample& sample);

  GloveFormat format_;
  std::vector<std::uint8_t> pending_;
  std::size_t garbled_ = 0;
};

}  // namespace hapticell::driver
