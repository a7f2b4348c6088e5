// SPDX-License-Identifier: Apache-2.0
#include "trajectory/playback.h"

#include <gtest/gtest.h>

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
