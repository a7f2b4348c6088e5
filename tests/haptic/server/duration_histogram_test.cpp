// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/duration_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "haptic/server/clock.h"
#include "haptic/server/loop_report.h"

namespace hapticell::haptic {
namespace {

TEST(DurationHistogram, PercentilesAreThoseOfTheSortedListWithinABucket) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> spread(11.0, 2.5);  // Around 60 us, up to seconds.
  DurationHistogram histogram;
  std::vector<double> all;
  for (int i = 0; i < 20'000; ++i) {
    const auto nanoseconds = static_cast<std::int64_t>(spread(random));
    histogram.add(nanoseconds);
    all.push_back(1e-9 * static_cast<double>(nanoseconds));
  }
  std::sort(all.begin(), all.end());
  for (const double p : {0.001, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const double exact = all[static_cast<std::size_t>(std::ceil(p * 20'000)) - 1];
    EXPECT_GE(histogram.percentile(p), exact) << p;
    EXPECT_LE(histogram.percentile(p), std::max(1.0626 * exact, exact + 1.001e-6)) << p;
  }
  EXPECT_EQ(histogram.max(), all.back());
  const auto below = std::count_if(all.begin(), all.end(), [](double d) { return d < 1.024e-3; });
  EXPECT_EQ(histogram.countBelow(1.024e-3), static_cast<std::uint64_t>(below));
}

TEST(DurationHistogram, MergingIsAddingBoth) {
  DurationHistogram a, b, both;
  for (int i = 0; i < 1000; ++i) {
    DurationHistogram& one = i % 3 ? a : b;
    one.add(i * i * 1000);
    both.add(i * i * 1000);
  }
  a.merge(b);
  for (const double p : {0.0, 0.25, 0.5, 0.75, 1.0}) EXPECT_EQ(a.percentile(p), both.percentile(p));
  EXPECT_EQ(a.count(), both.count());
}

TEST(DurationHistogram, TakesAnyDuration) {
  DurationHistogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0.0);
  histogram.add(-5);
  EXPECT_EQ(histogram.max(), 0.0);
  histogram.add(std::int64_t{1} << 62);
  EXPECT_EQ(histogram.count(), 2u);
  EXPECT_GT(histogram.percentile(1.0), 60.0);
}

TEST(LoopStatistics, CountRateMissesAndForgetOldLateness) {
  LoopStatistics statistics(1000.0);
  LoopFigures figures;
  std::int64_t now = 0;
  for (int i = 0; i < 20'000; ++i) {
    const bool hiccup = i == 100;
    now += hiccup ? 11'000'000 : 1'000'000;
    statistics.addTick(now, hiccup ? 10'000'000 : 50'000, hiccup ? 10 : 0);
    if (statistics.due()) statistics.collect(now, figures);
    if (i == 1100) {
      EXPECT_NEAR(figures.recent_lateness.max(), 0.010, 1e-9);
    }
  }
  EXPECT_EQ(figures.ticks, 20'000u);
  EXPECT_EQ(figures.missed, 10u);
  EXPECT_NEAR(figures.rate_hz, 1000.0, 0.01);
  EXPECT_NEAR(figures.lateness.max(), 0.010, 1e-9) << "since the start";
  EXPECT_NEAR(figures.recent_lateness.max(), 50e-6, 1e-9) << "forgotten after 10 s at most";
  const std::string report = loopReport(figures);
  EXPECT_NE(report.find("20000 ticks"), std::string::npos) << report;
  EXPECT_NE(report.find("10 missed"), std::string::npos) << report;
  EXPECT_NE(report.find("max 10.000"), std::string::npos) << report;
}

TEST(LoopStatistics, CountLateAndRefusedSetsAndTellTheClocks) {
  LoopStatistics statistics(1000.0);
  LoopFigures figures;
  statistics.addTick(1, 0, 0);
  for (const double age : {0.01, kLateSetAge, 0.101, 2.0}) statistics.addSetAge(toNanoseconds(age));
  for (int i = 0; i < 3; ++i) statistics.addRefusedSet();
  statistics.collect(2, figures);
  const std::string report = loopReport(figures);
  EXPECT_NE(report.find("2 late, 3 refused"), std::string::npos) << report;
  const ServerStatistics told = statisticsOf(figures, {.round_trip = 0.02, .clock_offset = -3.5});
  EXPECT_EQ(told.late_sets, 2u);
  EXPECT_EQ(told.refused_sets, 3u);
  EXPECT_DOUBLE_EQ(told.round_trip_ms, 20.0);
  EXPECT_DOUBLE_EQ(told.clock_offset_ms.value(), -3500.0);
  EXPECT_FALSE(statisticsOf(figures, {}).clock_offset_ms.has_value()) << "not measured yet";
}

}  // namespace
}  // namespace hapticell::haptic
