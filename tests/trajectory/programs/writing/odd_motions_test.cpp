// SPDX-License-Identifier: Apache-2.0
// Motions as hands and files really give them: repeated and nearly repeated frames, still starts, a single frame,
// hours. Whatever is done with them, what comes out is finite, in order, and no further from them than was allowed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/editing.h"
#include "trajectory/motion/motion_curves.h"
#include "trajectory/motion/playback.h"
#include "trajectory/programs/writing/program_export.h"
#include "trajectory/timing/retiming.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::trajectory {
namespace {

/// Every frame of a gesture so many times; copies off by `noise` (m and rad), `apart` seconds later.
Trajectory repeated(int times, double noise, double apart) {
  Trajectory motion;
  motion.name = "odd";
  for (int i = 0; i <= 80; ++i)
    for (int k = 0; k < times; ++k) {
      Pose X = test::gestureAt(0.05 * i);
      X.p.x += noise * k;
      X.q = glm::normalize(X.q * quaternionFromRotationVector({0.0, noise * k, 0.0}));
      motion.addFrame({0.05 * i + apart * k, X});
    }
  return motion;
}

/// Nothing moves for a while, then a gesture, then nothing again.
Trajectory stillAtBothEnds() {
  Trajectory motion;
  motion.name = "still";
  for (int i = 0; i <= 900; ++i) motion.addFrame({0.01 * i, test::gestureAt(std::clamp(0.01 * i - 3.0, 0.0, 3.0))});
  return motion;
}

void expectSane(const Trajectory& motion, const std::string& what) {
  double before = -1e300;
  for (const auto& frame : motion.frames()) {
    ASSERT_TRUE(std::isfinite(frame.t) && std::isfinite(glm::length(frame.X_WT.p))) << what;
    ASSERT_NEAR(glm::length(frame.X_WT.q), 1.0, 1e-9) << what;
    ASSERT_GT(frame.t, before) << what;
    before = frame.t;
  }
}

void expectFinite(const MotionCurves& curves, const std::string& what) {
  for (const auto& curve : curves.cartesian)
    for (const auto* values : {&curve.value, &curve.speed, &curve.acceleration, &curve.jerk})
      for (const double value : *values) ASSERT_TRUE(std::isfinite(value)) << what << ", " << curve.name;
}

/// All that can be done with a motion whatever it is.
void treat(const Trajectory& motion, const std::string& what) {
  const PathTolerance tolerance{1e-3, 0.0174533};
  const Smoothed smooth = smoothed(motion);
  expectSane(smooth.trajectory, what + ", smoothed");
  // Steps of several millimetres twenty times a second are told as tremor beyond the tolerance.
  if (!smooth.report.tremor_exceeds_tolerance) {
    EXPECT_LE(smooth.report.max_deviation.position, 1.0001e-3) << what;
  }
  const Trajectory few = simplified(motion, tolerance);
  expectSane(few, what + ", simplified");
  EXPECT_LE(largestDeviation(motion, few).pose.position, 1.0001e-3) << what;
  expectSane(reversed(motion), what + ", reversed");
  expectFinite(motionCurves(motion), what);
  for (const auto format : {ProgramFormat::kKrl, ProgramFormat::kRapid, ProgramFormat::kFanuc, ProgramFormat::kUrScript,
                            ProgramFormat::kVal3}) {
    const auto program = exportProgram(few, format, {});
    ASSERT_TRUE(program) << what << ": " << program.error().message();
    for (const ProgramFile& file : *program) EXPECT_EQ(file.content.find("nan"), std::string::npos) << what;
  }
}

TEST(OddMotions, RepeatedFramesAreHandled) {
  for (const double noise : {0.0, 1e-15, 1e-12, 1e-9})
    for (const double apart : {1e-9, 1e-4, 0.01}) {
      const std::string what = "noise " + std::to_string(noise) + ", apart " + std::to_string(apart);
      const Trajectory motion = repeated(3, noise, apart);
      ASSERT_EQ(motion.size(), 81u * 3u);
      treat(motion, what);
      RetimingOptions options;
      options.limits = {std::vector<double>(6, 0.5), std::vector<double>(6, 2.0), {}};
      const auto timed = retimed(motion, options);
      ASSERT_TRUE(timed) << what << ": " << timed.error().message();
      expectSane(timed->trajectory, what + ", timed");
      EXPECT_LE(timed->report.use.velocity, 1.001) << what;
      EXPECT_LE(timed->report.max_deviation.position, 1e-3) << what;
      // The copies neither cost time nor save it: as fast as the gesture without them.
      const auto once = retimed(repeated(1, 0.0, 0.0), options);
      ASSERT_TRUE(once);
      EXPECT_NEAR(timed->report.duration_after, once->report.duration_after, 0.02 * once->report.duration_after)
          << what;
    }
}

TEST(OddMotions, AFrameAtATimeThatWasIsRefused) {
  Trajectory motion;
  EXPECT_TRUE(motion.addFrame({1.0, {}}));
  EXPECT_FALSE(motion.addFrame({1.0, Pose::translation({1, 0, 0})}));
  EXPECT_FALSE(motion.addFrame({0.5, {}}));
  EXPECT_EQ(motion.size(), 1u);
}

TEST(OddMotions, StillStartsAreKeptByEditsAndDroppedByTiming) {
  const Trajectory motion = stillAtBothEnds();
  treat(motion, "still");
  EXPECT_NEAR(smoothed(motion).trajectory.duration(), 9.0, 1e-9) << "a rest is part of what was recorded";
  RetimingOptions options;
  options.limits = {std::vector<double>(6, 0.5), std::vector<double>(6, 2.0), {}};
  const auto timed = retimed(motion, options);
  ASSERT_TRUE(timed);
  EXPECT_GE(timed->report.still_frames, 590u);
  EXPECT_LT(timed->report.duration_after, 3.0);
  EXPECT_LT(distanceBetween(timed->trajectory[0].X_WT, motion[0].X_WT).position, 1e-9);
}

TEST(OddMotions, ASingleFrameIsAPlaceNoMotion) {
  Trajectory one;
  one.name = "one";
  one.addFrame({4.0, test::gestureAt(1.0)});
  treat(one, "one frame");
  EXPECT_EQ(motionCurves(one).samples, 0u);
  EXPECT_EQ(one.duration(), 0.0);
  EXPECT_EQ(one.poseAt(-1.0).p, one.poseAt(99.0).p);
  const auto timed = retimed(one, {});
  ASSERT_FALSE(timed) << "there is nothing to be timed";
  EXPECT_FALSE(timed.error().message().empty());
}

TEST(OddMotions, TenHoursComeBackBitForBitAndCanBeTreated) {
  // One frame a second here; 100 a second, 3.6 million frames, in trajectory_bench.
  Trajectory motion;
  motion.name = "shift";
  motion.reserve(36001);
  for (int i = 0; i <= 36000; ++i) motion.addFrame({i + 1e-9 * (i % 7), test::gestureAt(0.01 * i)});
  const auto folder = std::filesystem::temp_directory_path();
  for (const char* name : {"ten_hours_test.csv", "ten_hours_test.htraj"}) {
    const auto path = folder / name;
    std::ofstream(path) << (path.extension() == ".csv" ? toCsvText(motion) : toJsonText(motion));
    const auto read = readTrajectory(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->size(), motion.size());
    for (std::size_t i = 0; i < motion.size(); ++i) {
      ASSERT_EQ((*read)[i].t, motion[i].t) << i;
      ASSERT_EQ((*read)[i].X_WT.p, motion[i].X_WT.p) << i;
    }
  }
  const Trajectory few = simplified(motion, {5e-3, 0.05});
  expectSane(few, "ten hours, simplified");
  EXPECT_LT(few.size(), motion.size() / 3);
  EXPECT_LE(largestDeviation(motion, few).pose.position, 5.001e-3);
  expectFinite(motionCurves(motion), "ten hours");
}

}  // namespace
}  // namespace hapticell::trajectory
