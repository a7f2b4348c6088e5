// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/cyberglove/glove_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

namespace hapticell::driver {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes narrowFrame(std::uint8_t first, std::optional<std::uint8_t> status = {}) {
  Bytes bytes = {'G'};
  for (int i = 0; i < 22; ++i) bytes.push_back(static_cast<std::uint8_t>(first + i));
  if (status) bytes.push_back(*status);
  bytes.push_back(0);
  return bytes;
}

/// Of a CyberGlove III: each reading is `value`.
Bytes wideFrame(unsigned value) {
  Bytes bytes = {0x0D, 0x0A, 0x00};
  for (int i = 0; i < 13; ++i) bytes.push_back(static_cast<std::uint8_t>('0' + i % 10));
  bytes.push_back('S');
  for (int i = 0; i < 22; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
  }
  return bytes;
}

TEST(GloveFrames, AFrameMayComeInAnyPieces) {
  const Bytes frame = narrowFrame(10, std::uint8_t{1 | 2});
  for (std::size_t piece = 1; piece <= frame.size(); ++piece) {
    GloveFrames frames({.status = true});
    GloveSample sample;
    int found = 0;
    for (std::size_t at = 0; at < frame.size(); at += piece)
      found += frames.take(std::span(frame).subspan(at, std::min(piece, frame.size() - at)), sample) ? 1 : 0;
    ASSERT_EQ(found, 1) << piece;
    EXPECT_EQ(sample.count, 22u);
    EXPECT_EQ(sample.readings[0], 10.0);
    EXPECT_EQ(sample.readings[21], 31.0);
    EXPECT_TRUE(sample.has_status && sample.glove_in && sample.switch_on);
    EXPECT_FALSE(sample.light_on);
    EXPECT_EQ(frames.garbled(), 0u);
  }
}

TEST(GloveFrames, TheNewestOfSeveralCountsAndOthersAreSkipped) {
  GloveFrames frames({});
  GloveSample sample;
  Bytes bytes = narrowFrame(10);
  bytes.insert(bytes.end(), {'G', 1, 2, 0});  // Too short.
  bytes.insert(bytes.end(), {'?', 0});
  const Bytes last = narrowFrame(50);
  bytes.insert(bytes.end(), last.begin(), last.end());
  EXPECT_TRUE(frames.take(bytes, sample));
  EXPECT_EQ(sample.readings[0], 50.0);
  EXPECT_EQ(frames.garbled(), 2u);
  EXPECT_FALSE(frames.take(narrowFrame(10, std::uint8_t{1}), sample)) << "a byte too many";
  EXPECT_EQ(sample.readings[0], 50.0) << "unchanged";
}

TEST(GloveFrames, WideReadingsAreScaledAndMayHoldTheMarkOfAFrame) {
  GloveFrames frames({.wide = true});
  GloveSample sample;
  EXPECT_TRUE(frames.take(wideFrame(0x0D0A), sample)) << "the mark's own bytes within the data";
  EXPECT_NEAR(sample.readings[5], 0x0D0A * 255.0 / 4095.0, 1e-9);
  EXPECT_FALSE(frames.take(wideFrame(4095), sample)) << "beyond 4094";
  EXPECT_FALSE(frames.take(wideFrame(0), sample));
  EXPECT_TRUE(frames.take(wideFrame(4094), sample)) << "in step again";
  EXPECT_LT(sample.readings[0], 255.0);
}

TEST(GloveFrames, FramesAreFoundAgainAfterAnyBytes) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255);
  for (const bool wide : {false, true}) {
    GloveFrames frames({.wide = wide});
    GloveSample sample;
    for (int round = 0; round < 200; ++round) {
      Bytes noise;
      for (int i = 0; i < 100; ++i) noise.push_back(static_cast<std::uint8_t>(byte(random)));
      frames.take(noise, sample);
      for (const double reading : sample.readings) ASSERT_TRUE(reading >= 0.0 && reading <= 255.0);
    }
    // One frame may be lost in what the noise began.
    const Bytes good = wide ? wideFrame(2000) : narrowFrame(10);
    bool found = false;
    for (int i = 0; i < 4; ++i) found = frames.take(good, sample) || found;
    EXPECT_TRUE(found);
    EXPECT_NEAR(sample.readings[0], wide ? 2000 * 255.0 / 4095.0 : 10.0, 1e-9);
  }
}

}  // namespace
}  // namespace hapticell::driver
