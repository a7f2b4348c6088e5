// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hapticell::trajectory {
namespace {

Playback threeFrames() {
  Playback playback;
  playback.setFrames({0.5, 0.0, 2.0});
  return playback;
}

TEST(Playback, WithoutFramesDoesNothing) {
  Playback playback;
  playback.play();
  EXPECT_FALSE(playback.isPlaying());
  EXPECT_FALSE(playback.advance(1.0));
  playback.step(1);
  EXPECT_EQ(playback.time(), 0.0);
}

TEST(Playback, RunsAtItsSpeedAndStopsAtTheEnd) {
  Playback playback = threeFrames();
  playback.setSpeed(2.0);
  playback.play();
  EXPECT_TRUE(playback.advance(0.25));
  EXPECT_DOUBLE_EQ(playback.time(), 0.5);
  EXPECT_TRUE(playback.advance(10.0));
  EXPECT_DOUBLE_EQ(playback.time(), 2.0);
  EXPECT_FALSE(playback.isPlaying());
  playback.play();
  EXPECT_DOUBLE_EQ(playback.time(), 0.0);
}

TEST(Playback, LoopsWithoutLosingTime) {
  Playback playback = threeFrames();
  playback.setLoop(true);
  playback.play();
  playback.advance(4.75);
  EXPECT_NEAR(playback.time(), 0.75, 1e-12);
  EXPECT_TRUE(playback.isPlaying());
}

TEST(Playback, PassesOverNoStopAndMakesTheTimeUp) {
  Playback playback = threeFrames();
  playback.setStops({1.3, 0.4});
  playback.play();
  std::vector<double> seen;
  for (int i = 0; i < 8 && playback.isPlaying(); ++i) {
    playback.advance(0.35);
    seen.push_back(playback.time());
  }
  ASSERT_EQ(seen.size(), 6u) << "2 s in steps of 0.35 s, as without stops";
  for (const double stop : {0.4, 1.3}) EXPECT_NE(std::find(seen.begin(), seen.end(), stop), seen.end()) << stop;
  EXPECT_NEAR(seen[2], 1.05, 1e-12) << "it is where the clock is";
  playback.setLoop(true);
  playback.setStops({0.1});
  playback.seek(1.9);
  playback.play();
  playback.advance(0.3);
  EXPECT_DOUBLE_EQ(playback.time(), 0.1) << "beyond the turn of the loop too";
  playback.advance(0.05);
  EXPECT_NEAR(playback.time(), 0.25, 1e-12);
}

TEST(Playback, StepsFromFrameToFrame) {
  Playback playback = threeFrames();
  playback.step(1);
  EXPECT_DOUBLE_EQ(playback.time(), 0.5);
  playback.seek(1.1);
  playback.step(-1);
  EXPECT_DOUBLE_EQ(playback.time(), 0.5);
  playback.step(-1);
  playback.step(-1);
  EXPECT_DOUBLE_EQ(playback.time(), 0.0);
  playback.step(1);
  playback.step(1);
  playback.step(1);
  EXPECT_DOUBLE_EQ(playback.time(), 2.0);
}

TEST(Playback, KeepsItsTimeInsideNewFrames) {
  Playback playback = threeFrames();
  playback.seek(1.5);
  playback.setFrames({0.0, 1.0});
  EXPECT_DOUBLE_EQ(playback.time(), 1.0);
  playback.setSpeed(-3.0);
  EXPECT_GT(playback.speed(), 0.0);
}

}  // namespace
}  // namespace hapticell::trajectory
