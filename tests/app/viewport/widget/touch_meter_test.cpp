// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/touch_meter.h"

#include <gtest/gtest.h>

namespace hapticell::app {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(TouchMeter, CountsEachContactOnceWithTheFirstFrameThatShowsIt) {
  TouchMeter meter;
  meter.drawn(0);
  meter.shown(5 * kMs);
  EXPECT_EQ(meter.figures().contacts, 0u) << "nothing was felt";
  meter.drawn(10 * kMs);
  meter.shown(40 * kMs);
  meter.drawn(10 * kMs);
  meter.shown(70 * kMs);
  EXPECT_EQ(meter.figures().contacts, 1u);
  EXPECT_DOUBLE_EQ(meter.figures().last_s, 0.030);
  meter.drawn(100 * kMs);
  meter.shown(120 * kMs);
  meter.drawn(200 * kMs);
  meter.drawn(210 * kMs);  // Two frames before the first is on the screen: what was felt first waits longest.
  meter.shown(245 * kMs);
  EXPECT_EQ(meter.figures().contacts, 3u);
  EXPECT_DOUBLE_EQ(meter.figures().last_s, 0.045);
  EXPECT_DOUBLE_EQ(meter.figures().median_s, 0.030);
  EXPECT_DOUBLE_EQ(meter.figures().worst_s, 0.045);
}

TEST(TouchMeter, WhatNobodyCouldSeeIsNotCounted) {
  TouchMeter meter;
  meter.skipBefore(900 * kMs);
  meter.drawn(500 * kMs);
  meter.shown(1000 * kMs);
  EXPECT_EQ(meter.figures().contacts, 0u);
  meter.drawn(950 * kMs);
  meter.shown(1000 * kMs);
  EXPECT_EQ(meter.figures().contacts, 1u);
}

TEST(TouchMeter, KeepsTheLastHundred) {
  TouchMeter meter;
  for (int i = 1; i <= 300; ++i) {
    meter.drawn(100 * i * kMs);
    meter.shown((100 * i + (i <= 200 ? 90 : 20)) * kMs);
  }
  EXPECT_EQ(meter.figures().contacts, 100u);
  EXPECT_DOUBLE_EQ(meter.figures().worst_s, 0.020);
}

}  // namespace
}  // namespace hapticell::app
