// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hapticell::driver {

/// Format of a CyberGlove's samples.
struct GloveFormat {
  std::size_t sensors = 22;  ///< 18 or 22.
  bool status = false;       ///< A status byte follows the readings (8 bits only).
  bool wide = false;         ///< 16 bits per sensor, with time stamps (CyberGlove III); else 8.
};

/// One sample of all sensors.
struct GloveSample {
  std::array<double, 22> readings{};  ///< 0 .. 255, 16-bit readings are scaled to this range.
  std::size_t count = 0;
  bool has_status = false, switch_on = false, light_on = false, glove_in = false;
};

/// Finds samples in a stream of bytes and skips everything else.
///
/// 8 bits: 'G' or 'S', the readings (1 .. 255), the status byte if enabled, 0x00. Only the last byte can be 0x00, so it
/// marks the end of a frame. There is no checksum; a frame of another length is discarded. 16 bits: 0D 0A 00, a time
/// stamp of 14 bytes ending in 'S', the readings big-endian in 1 .. 4094; the data may contain any of these bytes, so a
/// frame counts only if all of it fits.
class GloveFrames {
 public:
  explicit GloveFrames(const GloveFormat& format) : format_(format) {}

  /// Takes bytes. If they complete a sample, stores the newest one in `sample` and returns true.
  bool take(std::span<const std::uint8_t> bytes, GloveSample& sample);
  /// Number of invalid frames so far.
  std::size_t garbled() const { return garbled_; }

 private:
  bool takeNarrow(std::uint8_t byte, GloveSample& sample);
  bool takeWide(GloveSample& sample);

  GloveFormat format_;
  std::vector<std::uint8_t> pending_;
  std::size_t garbled_ = 0;
};

}  // namespace hapticell::driver
