// SPDX-License-Identifier: Apache-2.0
// What timing is made of: the place on a path by time, bounds at the places of a grid, parts from rest to rest.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "trajectory/timing/path_timing.h"
#include "trajectory/timing/retimed_part.h"
#include "trajectory/timing/timing_grid.h"
#include "trajectory/timing/way_timing.h"

namespace hapticell::trajectory {
namespace {

/// 1 m along x, frames every 0.1 m and 0.1 s.
Trajectory straightMotion(std::size_t frames = 11) {
  Trajectory motion;
  for (std::size_t i = 0; i < frames; ++i) {
    const double x = 0.1 * static_cast<double>(i);
    EXPECT_TRUE(motion.addFrame({.t = x, .X_WT = Pose::translation({x, 0, 0})}));
  }
  return motion;
}

RetimingOptions slowTool() {
  RetimingOptions options;
  options.mode = TimingMode::kConstantSpeed;
  options.speed = 0.25;
  options.acceleration = 1.0;
  return options;
}

TEST(PathTiming, ATriangleOfSpeedIsTheParabolasOfSchool) {
  const PathTiming timing({0.0, 1.0, 2.0}, {0.0, 2.0, 0.0});  // 2 m/s2 up to 2 m/s, and down.
  EXPECT_NEAR(timing.duration(), 2.0, 1e-12);
  for (const double t : {0.0, 0.3, 0.9}) {
    EXPECT_NEAR(timing.at(t).s, t * t, 1e-12);
    EXPECT_NEAR(timing.at(t).speed, 2.0 * t, 1e-12);
    EXPECT_NEAR(timing.at(2.0 - t).s, 2.0 - t * t, 1e-12);
  }
  EXPECT_EQ(timing.at(-1.0).s, 0.0);
  EXPECT_EQ(timing.at(9.0).s, 2.0);
  const PathTiming slow = timing.stretched(3.0);
  EXPECT_NEAR(slow.duration(), 6.0, 1e-12);
  EXPECT_NEAR(slow.at(1.5).s, timing.at(0.5).s, 1e-12);
  EXPECT_NEAR(slow.at(1.5).acceleration, 2.0 / 9.0, 1e-12);
}

TEST(PathTiming, AveragedIsTheMeanOverTheWindow) {
  const PathTiming timing({0.0, 1.0, 2.0}, {0.0, 2.0, 0.0});
  const PathTiming averaged = timing.averaged(0.5);
  EXPECT_NEAR(averaged.duration(), 2.5, 1e-12) << "longer by the window";
  for (const double t : {0.2, 0.8, 1.3, 2.2}) {
    double sum = 0.0;  // By steps, as a second way.
    for (int i = 0; i < 5000; ++i) sum += timing.at(t - 0.5 + 0.5 * (i + 0.5) / 5000.0).s / 5000.0;
    EXPECT_NEAR(averaged.at(t).s, sum, 1e-7);
  }
  double before = averaged.at(0.0).acceleration, most = 0.0;
  for (double t = 0.001; t < 2.5; t += 0.001) {
    most = std::max(most, std::abs(averaged.at(t).acceleration - before));
    before = averaged.at(t).acceleration;
  }
  EXPECT_LT(most, 0.001 * 4.0 / 0.5 * 1.01) << "the acceleration changes by 4 in a window, nowhere at once";
}

TEST(TimingGrid, BoundsAreThoseOfTheStraightLine) {
  const StraightPath path(straightMotion(), 2.0, LimitedBy::kPose);  // 0.5 m for each unit.
  MotionLimits limits;
  limits.velocity = limits.acceleration = {0.5, 1, 1, 1, 1, 1};
  const TimingGrid grid(path, limits, 11);
  EXPECT_EQ(grid.s().front(), 0.0);
  EXPECT_EQ(grid.s().back(), 2.0);
  EXPECT_NEAR(grid.speedBound(3), 1.0, 1e-12) << "0.5 m/s is a unit a second";
  TimingStage stage;
  grid.fill(2, stage);
  for (const BoundLine& line : stage.lower) EXPECT_NEAR(line.at(0.0), -1.0, 1e-12) << "0.5 m/s2";
  std::vector<double> speeds(grid.size(), 0.8);
  const LimitUse even = grid.useBetween(speeds);
  EXPECT_NEAR(even.velocity, 0.8, 1e-12);
  EXPECT_NEAR(even.acceleration, 0.0, 1e-12);
  std::vector<double> first(6), second(6);
  grid.derivatives(0.77, first, second);
  EXPECT_NEAR(first[0], 0.5, 1e-12);
  EXPECT_NEAR(second[0], 0.0, 1e-12);
  MotionLimits half = limits;
  half.velocity[0] = 0.25;
  EXPECT_NEAR(TimingGrid(grid, half).speedBound(3), 0.25, 1e-12) << "the square of half the speed";
}

TEST(TimingStage, ABoundWithoutAccelerationBoundsTheSpeed) {
  TimingStage stage;
  stage.add({0.0, 4.0, 1.0});
  EXPECT_EQ(stage.x_most, 0.25);
  EXPECT_TRUE(stage.upper.empty());
  stage.add({-2.0, 1.0, 1.0});  // -1 <= -2 u + x <= 1
  ASSERT_EQ(stage.upper.size(), 1u);
  EXPECT_NEAR(stage.upper[0].at(0.5), 0.75, 1e-12);
  EXPECT_NEAR(stage.lower[0].at(0.5), -0.25, 1e-12);
  stage.clear();
  EXPECT_EQ(stage.x_most, 0.25);
  EXPECT_TRUE(stage.lower.empty());
}

TEST(WayTiming, ConstantSpeedIsATrapezoidOfTheTool) {
  const StraightPath path(straightMotion(), 2.0, LimitedBy::kPose);
  const auto timing = wayTimingOf(path, slowTool());
  ASSERT_TRUE(timing) << timing.error().message();
  EXPECT_NEAR(timing->duration, 1.0 / 0.25 + 0.25 / 1.0, 1e-9) << "the way at its speed, and once its ramp";
  EXPECT_NEAR(path.pose(timing->way(2.125)).p.x, 0.5, 1e-6);
  const double there = path.pose(timing->way(3.0)).p.x, before = path.pose(timing->way(2.0)).p.x;
  EXPECT_NEAR(there - before, 0.25, 1e-6);
  const WayTiming slower = timing->slower(2.0);
  EXPECT_NEAR(slower.duration, 2.0 * timing->duration, 1e-12);
  EXPECT_EQ(slower.way(4.0), timing->way(2.0));
}

TEST(RetimedPart, ItsSamplesBeginAndEndAtItsFramesAndGoEvenly) {
  const Trajectory motion = straightMotion();
  const RetimingOptions options = slowTool();
  auto part = RetimedPart::of(motion, {2, 8}, options, LimitedBy::kPose);
  ASSERT_TRUE(part) << part.error().message();
  EXPECT_EQ(part->frames.size(), 7u);
  EXPECT_NEAR(part->ways.back(), 0.6, 1e-12);
  part->sample(100, part->timing.duration / 100.0, options);
  ASSERT_EQ(part->samples.size(), 101u);
  EXPECT_EQ(part->samples[0].X_WT.p, motion[2].X_WT.p);
  EXPECT_EQ(part->samples[100].X_WT.p, motion[8].X_WT.p);
  const double dt = part->timing.duration / 100.0;
  EXPECT_NEAR(part->samples[51].X_WT.p.x - part->samples[50].X_WT.p.x, 0.25 * dt, 1e-6);
  EXPECT_NEAR(part->given[50].X_WT.p.x, part->samples[50].X_WT.p.x, 1e-6) << "the same place of the given motion";
  Deviation worst;
  EXPECT_TRUE(part->missedFrames(options, worst).empty());
  EXPECT_LT(worst.pose.position, 1e-9);
}

TEST(RetimedPart, FramesThatStraightWaysMissAreToldByTheMotionsNumbers) {
  Trajectory bow;  // A half circle of 0.1 m: three chords miss it by millimetres.
  for (int i = 0; i <= 30; ++i) {
    const double a = 0.1 * i;
    EXPECT_TRUE(bow.addFrame({.t = 0.1 * i, .X_WT = Pose::translation({0.1 * std::cos(a), 0.1 * std::sin(a), 0.0})}));
  }
  const RetimingOptions options = slowTool();
  auto part = RetimedPart::of(bow, {5, 25}, options, LimitedBy::kPose);
  ASSERT_TRUE(part);
  part->sample(3, part->timing.duration / 3.0, options);
  Deviation worst;
  const std::vector<std::size_t> missed = part->missedFrames(options, worst);
  ASSERT_FALSE(missed.empty());
  for (const std::size_t frame : missed) EXPECT_TRUE(frame > 5 && frame < 25) << frame;
  EXPECT_GT(worst.pose.position, 1e-3);
  part->sample(2000, part->timing.duration / 2000.0, options);
  worst = {};
  EXPECT_TRUE(part->missedFrames(options, worst).empty());
}

TEST(RetimedPart, StopsWhereItsOptionsSaySo) {
  const std::atomic<bool> stop{true};
  RetimingOptions options = slowTool();
  options.stop = &stop;
  const auto part = RetimedPart::of(straightMotion(), {0, 10}, options, LimitedBy::kPose);
  ASSERT_FALSE(part);
  EXPECT_EQ(part.error().message(), Error(retimingStopped()).message());
}

TEST(MotionPiece, ItsCopyHasItsFramesOnly) {
  const Trajectory motion = straightMotion();
  const Trajectory piece = pieceOf(motion, {3, 5});
  ASSERT_EQ(piece.size(), 3u);
  EXPECT_EQ(piece[0].t, motion[3].t);
  EXPECT_EQ(piece[2].X_WT.p, motion[5].X_WT.p);
}

}  // namespace
}  // namespace hapticell::trajectory
