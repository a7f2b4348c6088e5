// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/smoothing.h"

#include <gtest/gtest.h>

#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/simplification.h"

namespace hapticell::trajectory {
namespace {

using test::gestureAt;
using test::recordedGesture;

double rmsFromTruth(const Trajectory& trajectory) {
  double sum = 0.0;
  for (const auto& frame : trajectory.frames()) {
    const dvec3 left = frame.X_WT.p - gestureAt(frame.t).p;
    sum += glm::dot(left, left);
  }
  return std::sqrt(sum / static_cast<double>(trajectory.size()));
}

// 30 s at 1 kHz, tremor of 9 Hz and 0.3 mm: at most 1 mm and 1 degree off, jerk over 300 times less, nearer to the
// truth.
TEST(Smoothing, TakesTremorAndKeepsThePath) {
  const Trajectory recorded = recordedGesture(30.0, 1000.0, 3e-4, 1e-6);
  const Smoothed smooth = smoothed(recorded);
  EXPECT_LE(smooth.report.max_deviation.position, 0.001);
  EXPECT_LE(smooth.report.max_deviation.angle, 0.0175);
  EXPECT_GE(smooth.report.rms_jerk_before / smooth.report.rms_jerk_after, 300.0);
  EXPECT_LT(rmsFromTruth(smooth.trajectory), 0.5 * rmsFromTruth(recorded));
  EXPECT_NEAR(smooth.report.tremor.position, 3e-4 / std::sqrt(2.0), 5e-5);
  EXPECT_FALSE(smooth.report.tremor_exceeds_tolerance);
  ASSERT_EQ(smooth.trajectory.size(), recorded.size());
  EXPECT_EQ(smooth.trajectory[100].t, recorded[100].t);
  EXPECT_LT(distanceBetween(smooth.trajectory[0].X_WT, recorded[0].X_WT).position, 1e-6);
}

TEST(Smoothing, WarnsWhereTheTremorIsLargerThanTheTolerance) {
  SmoothingOptions tight;
  tight.tolerance = {2e-4, 0.01};
  EXPECT_TRUE(smoothed(recordedGesture(4.0, 200.0, 4e-4), tight).report.tremor_exceeds_tolerance);
}

TEST(Smoothing, MeetsFramesSetByHandAndCarriesJointsAlong) {
  Trajectory recorded;
  recorded.joint_names = {"q1", "q2"};
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    const double noise = i % 2 == 0 ? 2e-4 : -2e-4;
    Pose X = gestureAt(t);
    X.p.x += noise;
    const double joints[] = {std::sin(t), std::cos(0.5 * t)};
    recorded.addFrame({t, X, i == 250}, joints);
  }
  const Smoothed smooth = smoothed(recorded);
  EXPECT_LT(distanceBetween(smooth.trajectory[250].X_WT, recorded[250].X_WT).position, 1e-5);
  EXPECT_NEAR(smooth.trajectory.joints(300)[0], std::sin(3.0), 5e-4);
}

TEST(Smoothing, LooksForNoTremorWhereTimeHardlyGoesOrRuns) {
  for (const double step : {1e-300, 1e300}) {
    Trajectory odd;
    for (int i = 0; i < 12; ++i) odd.addFrame({step * i, gestureAt(0.1 * i)});
    EXPECT_EQ(estimateTremor(odd).position, 0.0) << step;
  }
}

TEST(Smoothing, KeepsItsToleranceHoweverFewTheFrames) {
  for (const double side : {0.005, 0.1}) {
    Trajectory square;
    for (int i = 0; i <= 20; ++i) {
      const int k = i % 4;
      square.addFrame({1.0 * i, Pose::translation({k == 1 || k == 2 ? side : 0.0, k >= 2 ? side : 0.0, 0.0})});
    }
    const Smoothed smooth = smoothed(square);
    for (std::size_t i = 0; i < square.size(); ++i) {
      EXPECT_LE(glm::distance(smooth.trajectory[i].X_WT.p, square[i].X_WT.p), 0.001) << i;
    }
  }
}

TEST(Smoothing, LeavesFewFramesAlone) {
  Trajectory one;
  one.addFrame({0.0, gestureAt(0.0)});
  EXPECT_EQ(smoothed(one).trajectory.size(), 1u);
  EXPECT_EQ(rmsJerk(one), 0.0);
}

TEST(Simplification, StaysWithinItsToleranceAndDropsMostFrames) {
  const Trajectory recorded = recordedGesture(30.0, 100.0, 0.0);
  for (const double mm : {0.25, 1.0, 5.0}) {
    const PathTolerance tolerance{1e-3 * mm, mm * 0.0174533, 1e-3 * mm};
    const Trajectory few = simplified(recorded, tolerance);
    const PoseDistance deviation = largestDeviation(recorded, few).pose;
    EXPECT_LE(deviation.position, tolerance.position * 1.0001) << mm;
    EXPECT_LE(deviation.angle, tolerance.angle * 1.0001) << mm;
    EXPECT_LT(few.size(), recorded.size() / 4) << mm;
    EXPECT_EQ(few[0].t, recorded[0].t);
    EXPECT_EQ(few.frames().back().t, recorded.frames().back().t);
  }
}

TEST(Simplification, KeepsFramesSetByHandAndDwells) {
  Trajectory straight;
  for (int i = 0; i <= 100; ++i) {
    straight.addFrame({0.1 * i, Pose::translation({0.01 * i, 0, 0}), i == 30, i == 60 ? 2.0 : 0.0});
  }
  EXPECT_EQ(framesToKeep(straight, {}), (std::vector<std::size_t>{0, 30, 60, 100}));
}

TEST(Simplification, DropsFramesInWhichNothingMoves) {
  Trajectory trajectory;
  for (int i = 0; i < 50; ++i)
    trajectory.addFrame({0.01 * i, Pose::translation({i < 40 ? 0.0 : 0.01 * (i - 39), 0, 0})});
  const Trajectory moving = withoutStillFrames(trajectory, {1e-6, 1e-6});
  EXPECT_EQ(moving.size(), 11u);
  EXPECT_EQ(moving[1].t, trajectory[40].t);
}

}  // namespace
}  // namespace hapticell::trajectory
