// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/recorder.h"

#include <gtest/gtest.h>

namespace hapticell::trajectory {
namespace {

/// Rests for 1 s, moves 0.1 m along x in the next second, rests again; a step a millisecond.
Trajectory recorded(const RecordingOptions& options, double mark_at = -1.0) {
  Trajectory empty;
  empty.joint_names = {"q1"};
  Recorder recorder(empty, options);
  for (int i = 0; i <= 3000; ++i) {
    const double t = 0.001 * i;
    const double x = 0.1 * std::min(1.0, std::max(0.0, t - 1.0));
    const double joint = 2.0 * x;
    if (std::abs(t - mark_at) < 1e-9) {
      recorder.mark(t, Pose::translation({x, 0, 0}), std::span(&joint, 1));
    } else {
      recorder.add(t, Pose::translation({x, 0, 0}), std::span(&joint, 1));
    }
  }
  return recorder.finish();
}

TEST(Recorder, BeginsWhenTheEntityMovesAndEndsWithTheLastStep) {
  for (const RecordingMode mode : {RecordingMode::kEveryStep, RecordingMode::kByTime, RecordingMode::kByDistance}) {
    RecordingOptions options;
    options.mode = mode;
    const Trajectory trajectory = recorded(options);
    ASSERT_GE(trajectory.size(), 3u);
    EXPECT_EQ(trajectory[0].t, 0.0);
    EXPECT_NEAR(trajectory[0].X_WT.p.x, 0.0, 6e-4);
    EXPECT_NEAR(trajectory.duration(), 2.0, 0.01);
    EXPECT_NEAR(trajectory.frames().back().X_WT.p.x, 0.1, 1e-12);
    EXPECT_NEAR(trajectory.joints(trajectory.size() - 1)[0], 0.2, 1e-12);
  }
}

TEST(Recorder, TimeAndDistanceAreKept) {
  RecordingOptions options;
  options.interval_s = 0.05;
  const Trajectory by_time = recorded(options);
  for (std::size_t i = 1; i + 1 < by_time.size(); ++i) EXPECT_NEAR(by_time[i].t - by_time[i - 1].t, 0.05, 1e-9);
  options.mode = RecordingMode::kByDistance;
  options.spacing = {0.01, 1.0};
  const Trajectory by_distance = recorded(options);
  EXPECT_NEAR(static_cast<double>(by_distance.size()), 11.0, 1.0);
}

TEST(Recorder, ByHandKeepsOnlyWhatIsMarked) {
  RecordingOptions options;
  options.mode = RecordingMode::kByHand;
  const Trajectory trajectory = recorded(options, 1.5);
  ASSERT_EQ(trajectory.size(), 1u);
  EXPECT_TRUE(trajectory[0].by_hand);
  EXPECT_NEAR(trajectory[0].X_WT.p.x, 0.05, 1e-9);
  options.mode = RecordingMode::kByTime;
  const Trajectory with_mark = recorded(options, 1.5);
  int marked = 0;
  for (const auto& frame : with_mark.frames()) marked += frame.by_hand ? 1 : 0;
  EXPECT_EQ(marked, 1);
}

/// A figure bends an arm while its root stands where it is.
TEST(Recorder, JointsThatMoveAloneAreAMotion) {
  for (const auto mode : {RecordingMode::kByTime, RecordingMode::kByDistance, RecordingMode::kEveryStep}) {
    Trajectory empty;
    empty.joint_names = {"shoulder", "elbow"};
    RecordingOptions options;
    options.mode = mode;
    Recorder recorder(empty, options);
    for (int i = 0; i <= 100; ++i) {
      const double elbow = i < 20 ? 0.0 : 0.01 * (i - 20);
      recorder.add(0.01 * i, {}, std::vector<double>{0.1, elbow});
    }
    const Trajectory recorded = recorder.finish();
    ASSERT_GE(recorded.size(), 8u) << static_cast<int>(mode);
    EXPECT_LT(recorded.duration(), 0.83) << "the pause before it is no part of it";
    EXPECT_NEAR(recorded.joints(0)[1], 0.0, 1e-12);
    EXPECT_NEAR(recorded.joints(recorded.size() - 1)[1], 0.8, 1e-12);
    if (mode == RecordingMode::kByDistance) {
      EXPECT_LT(recorded.size(), 14u) << "every five degrees of a joint";
    }
  }
}

TEST(Recorder, NothingMovedIsNothingRecorded) {
  Recorder recorder(Trajectory{}, {});
  for (int i = 0; i < 100; ++i) recorder.add(0.01 * i, Pose::identity());
  EXPECT_TRUE(recorder.finish().empty());
}

}  // namespace
}  // namespace hapticell::trajectory
