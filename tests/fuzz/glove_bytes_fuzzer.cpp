// SPDX-License-Identifier: Apache-2.0
// Any bytes as what a CyberGlove sends; the first says which format is expected and how long the pieces are. Readings
// stay in their range, and neither the samples nor the count of garbage depend on the pieces.
#include "haptic/devices/drivers/cyberglove/glove_frames.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using namespace hapticell;
using driver::GloveFormat;
using driver::GloveFrames;
using driver::GloveSample;

GloveFormat formatOf(std::uint8_t bits) {
  GloveFormat format;
  format.sensors = (bits & 1) != 0 ? 18 : 22;
  format.wide = (bits & 2) != 0;
  format.status = !format.wide && (bits & 4) != 0;
  return format;
}

void checkSample(const GloveSample& sample, const GloveFormat& format) {
  fuzz::check(sample.count == format.sensors);
  fuzz::check(sample.has_status == format.status);
  for (std::size_t i = 0; i < sample.count; ++i) fuzz::check(sample.readings[i] > 0.0 && sample.readings[i] <= 255.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const GloveFormat format = formatOf(data[0]);
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);

  GloveFrames by_piece(format), by_byte(format);
  GloveSample newest, newest_by_byte;
  bool found = false, found_by_byte = false;
  fuzz::inPieces(bytes, 1 + (data[0] >> 3), [&](auto piece) { found |= by_piece.take(piece, newest); });
  fuzz::inPieces(bytes, 1, [&](auto piece) { found_by_byte |= by_byte.take(piece, newest_by_byte); });

  fuzz::check(found == found_by_byte && by_piece.garbled() == by_byte.garbled());
  if (found) {
    checkSample(newest, format);
    fuzz::check(newest.readings == newest_by_byte.readings);
  }
  return 0;
}
