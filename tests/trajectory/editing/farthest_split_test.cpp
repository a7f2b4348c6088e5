// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/farthest_split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace hapticell::trajectory {
namespace {

/// Heights over frames 0, 1, 2 …; the deviation from the straight line between the ends, over the tolerance.
struct Heights {
  std::vector<double> y;
  double tolerance = 1.0;
  double operator()(std::size_t i, const FrameSpan& span) const {
    const double share = static_cast<double>(i - span.first) / static_cast<double>(span.last - span.first);
    return std::abs(y[i] - (y[span.first] + share * (y[span.last] - y[span.first]))) / tolerance;
  }
};

std::vector<std::size_t> kept(const Heights& heights) {
  std::vector<std::size_t> frames = {0, heights.y.size() - 1};
  splitAtFarthest({{0, heights.y.size() - 1}}, heights, frames);
  return frames;
}

/// Douglas and Peucker's method as they published it: by recursion.
void recurse(const Heights& heights, std::size_t first, std::size_t last, std::set<std::size_t>& found) {
  std::size_t at = first;
  double worst = 1.0;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (const double off = heights(i, {first, last}); off > worst) worst = off, at = i;
  }
  if (at == first) return;
  found.insert(at);
  recurse(heights, first, at, found);
  recurse(heights, at, last, found);
}

TEST(FarthestSplit, KeepsCornersAndNothingOfStraightLines) {
  EXPECT_EQ(kept({{0, 2, 4, 6, 8}}), (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(kept({{0, 3, 6, 3, 0}}), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(kept({{0, 1, 0}}), (std::vector<std::size_t>{0, 2})) << "just the tolerance";
  EXPECT_EQ(kept({{0, 5}}), (std::vector<std::size_t>{0, 1}));
}

TEST(FarthestSplit, IsThePublishedMethodAndLeavesNoFrameFarther) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-3.0, 3.0);
  for (int round = 0; round < 50; ++round) {
    Heights heights;
    heights.tolerance = 1.5;
    for (int i = 0; i < 60; ++i) heights.y.push_back(height(random));
    const std::vector<std::size_t> frames = kept(heights);
    std::set<std::size_t> expected = {0, 59};
    recurse(heights, 0, 59, expected);
    ASSERT_EQ(frames, std::vector<std::size_t>(expected.begin(), expected.end()));
    for (std::size_t k = 1; k < frames.size(); ++k) {
      for (std::size_t i = frames[k - 1] + 1; i < frames[k]; ++i)
        ASSERT_LE(heights(i, {frames[k - 1], frames[k]}), 1.0);
    }
  }
}

TEST(FarthestSplit, KeepsTheSameFramesOnAllCores) {
  std::mt19937 random(11);
  std::normal_distribution<double> step(0.0, 0.3);
  Heights heights;
  heights.y = {0.0};
  while (heights.y.size() < 60000) heights.y.push_back(heights.y.back() + step(random));
  for (std::size_t i = 20000; i < 30000; ++i) heights.y[i] = 40.0;  // Of equal ones the first.
  for (const double tolerance : {0.5, 5.0, 1e6}) {
    heights.tolerance = tolerance;
    const std::vector<FrameSpan> spans = {{0, 100}, {100, 45000}, {45000, 59999}};
    std::vector<std::size_t> alone = {0, 100, 45000, 59999}, together = alone;
    splitAtFarthest(spans, heights, alone);
    splitAtFarthestTogether(spans, heights, together);
    EXPECT_EQ(together, alone) << tolerance;
    EXPECT_EQ(alone.size() > 1000, tolerance < 1.0);
  }
}

TEST(FarthestSplit, KeepsSpansApart) {
  const Heights heights{{0, 9, 0, 0, 9, 0}};
  std::vector<std::size_t> frames = {0, 2, 3, 5};
  splitAtFarthest({{0, 2}, {3, 5}}, heights, frames);
  EXPECT_EQ(frames, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  frames = {};
  splitAtFarthest({}, heights, frames);
  EXPECT_TRUE(frames.empty());
}

}  // namespace
}  // namespace hapticell::trajectory
