// SPDX-License-Identifier: Apache-2.0
#include "trajectory/checks/program_promises.h"

#include <gtest/gtest.h>

#include "tests/trajectory/motion/motions.h"

namespace hapticell {
namespace {

using trajectory::ProgramFile;
using trajectory::ProgramFormat;
using trajectory::Trajectory;

constexpr ProgramFormat kLanguages[] = {ProgramFormat::kKrl,      ProgramFormat::kRapid, ProgramFormat::kFanuc,
                                        ProgramFormat::kUrScript, ProgramFormat::kVal3,  ProgramFormat::kInform};

std::vector<ProgramFile> written(const Trajectory& motion, ProgramFormat format,
                                 const trajectory::ProgramOptions& options) {
  auto files = trajectory::exportProgram(motion, format, options);
  EXPECT_TRUE(files.has_value()) << (files ? "" : files.error().message());
  return files ? std::move(*files) : std::vector<ProgramFile>{};
}

/// The same motion with one frame moved by `off` along x.
Trajectory withOneOff(const Trajectory& motion, std::size_t frame, double off) {
  Trajectory other = motion.emptyCopy();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Trajectory::Frame one = motion[i];
    if (i == frame) one.X_WT.p.x += off;
    other.addFrame(one, motion.joints(i));
  }
  return other;
}

TEST(ProgramPromises, EveryLanguageKeepsItsTargetsAndAWrongOneIsNamed) {
  const Trajectory motion = test::recordedGesture(2.0, 20.0, 0.0);
  const Trajectory other = withOneOff(motion, 17, 2e-5);
  for (const ProgramFormat format : kLanguages) {
    SCOPED_TRACE(static_cast<int>(format));
    trajectory::ProgramOptions options;
    options.name = "GESTURE";
    const auto kept = trajectory_checks::programPromises(motion, written(motion, format, options), format, options);
    ASSERT_TRUE(kept.has_value()) << kept.error().message();
    EXPECT_TRUE(kept->areKept()) << kept->missed("gesture").message();
    const auto off = trajectory_checks::programPromises(motion, written(other, format, options), format, options);
    ASSERT_TRUE(off.has_value()) << off.error().message();
    ASSERT_FALSE(off->areKept());
    EXPECT_EQ(off->worst()->name, "position");
    EXPECT_EQ(english(off->worst()->place), "at frame 17");
    EXPECT_NEAR(off->worst()->measured, 2e-5, 2e-6);
  }
}

TEST(ProgramPromises, ABaseByNumbersIsMeasuredToo) {
  const Trajectory motion = test::recordedGesture(2.0, 20.0, 0.0);
  const Trajectory other = withOneOff(motion, 3, 1e-4);
  const std::pair<ProgramFormat, const char*> bases[] = {{ProgramFormat::kKrl, "{X 120.5,Y -30,Z 200,A 90,B 0,C 180}"},
                                                         {ProgramFormat::kUrScript, "p[0.1,-0.2,0.3,0,0,1.5708]"}};
  for (const auto& [format, base] : bases) {
    SCOPED_TRACE(base);
    trajectory::ProgramOptions options;
    options.base = base;
    const auto kept = trajectory_checks::programPromises(motion, written(motion, format, options), format, options);
    ASSERT_TRUE(kept.has_value()) << kept.error().message();
    EXPECT_TRUE(kept->areKept()) << kept->missed("gesture").message();
    const auto off = trajectory_checks::programPromises(motion, written(other, format, options), format, options);
    ASSERT_TRUE(off.has_value()) << off.error().message();
    EXPECT_FALSE(off->areKept());
  }
}

TEST(ProgramPromises, ATargetThatIsMissingIsAnError) {
  const Trajectory motion = test::recordedGesture(2.0, 20.0, 0.0);
  const trajectory::ProgramOptions options;
  Trajectory less = motion.emptyCopy();
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) less.addFrame(motion[i]);
  for (const ProgramFormat format : kLanguages) {
    EXPECT_FALSE(trajectory_checks::programPromises(motion, written(less, format, options), format, options));
  }
}

}  // namespace
}  // namespace hapticell
