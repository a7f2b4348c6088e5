// SPDX-License-Identifier: Apache-2.0
// What the trajectory panels compute, without a display.
#include <gtest/gtest.h>

#include <set>

#include "app/trajectory/docks/time_axis.h"
#include "app/trajectory/motions/kept_motion.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/motions/motion_work.h"
#include "app/trajectory/motions/trace_curves.h"
#include "app/trajectory/motions/track_rows.h"
#include "app/trajectory/motions/usual_format.h"
#include "app/trajectory/training/exercise_files.h"
#include "kinematics/model/robot_model.h"
#include "tests/support/test_data.h"
#include "trajectory/checks/motion_promises.h"

namespace hapticell::app {
namespace {

TEST(TimeAxis, PixelsAndSecondsGoBothWays) {
  const TimeAxis axis{200, 1000, -1.0, 9.0};
  EXPECT_DOUBLE_EQ(axis.x(4.0), 600.0);
  EXPECT_DOUBLE_EQ(axis.t(axis.x(3.21)), 3.21);
}

TEST(TimeAxis, NamedTicksAreRoundAndFarEnoughApart) {
  for (const double length : {0.05, 0.7, 3.0, 24.0, 36000.0}) {
    const TimeAxis axis{200, 1000, 0.0, length};
    double last = -1e9;
    int named = 0;
    for (const auto& tick : axis.ticks()) {
      if (!tick.named) continue;
      ++named;
      EXPECT_GE(axis.x(tick.t) - last, 59.9) << length;
      last = axis.x(tick.t);
    }
    EXPECT_GE(named, 3) << length;
  }
}

TEST(TimeAxis, ZoomsAboutATimeAndNeverToNothing) {
  const TimeAxis axis{200, 1000, 0.0, 10.0};
  const TimeAxis nearer = axis.zoomed(2.0, 4.0);
  EXPECT_DOUBLE_EQ(nearer.x(4.0), axis.x(4.0));
  EXPECT_DOUBLE_EQ(nearer.end - nearer.begin, 5.0);
  EXPECT_GE(axis.zoomed(1e9, 4.0).end - axis.zoomed(1e9, 4.0).begin, 0.0099);
}

Motion checkedMotion() {
  trajectory::Trajectory trajectory;
  for (int i = 0; i <= 100; ++i) trajectory.addFrame({0.1 * i, Pose::translation({0.01 * i, 0, 0}), i == 50});
  Motion motion;
  motion.name = "m";
  motion.trajectory = std::make_shared<const trajectory::Trajectory>(std::move(trajectory));
  manipulation::PathCheckResult check;
  check.findings.push_back({manipulation::PathFinding::Kind::kCollision, 3.0, 4.0, "gripper", "table", 0.0, {}});
  check.findings.push_back({manipulation::PathFinding::Kind::kSingularity, 3.5, 6.0, "", "", 0.0, {}});
  motion.check = check;
  return motion;
}

TEST(Check, TheStrongestMarkCounts) {
  const Motion motion = checkedMotion();
  EXPECT_EQ(markAt(motion, 1.0), CheckMark::kFree);
  EXPECT_EQ(markAt(motion, 3.7), CheckMark::kCollision);
  EXPECT_EQ(markAt(motion, 5.0), CheckMark::kCareful);
  Motion unchecked = motion;
  unchecked.check.reset();
  EXPECT_EQ(markAt(unchecked, 3.7), CheckMark::kNone);
  EXPECT_TRUE(checkLine(*motion.check).contains("contacts: 1"));
  EXPECT_TRUE(findingText(motion.check->findings[0]).contains("table"));
}

TEST(MotionFrames, LongMotionsGetFewRowsThatLeaveNothingOut) {
  const Motion motion = checkedMotion();
  EXPECT_EQ(motionFrames(motion, 200).size(), 101u) << "all of them";
  const auto rows = motionFrames(motion, 10);
  EXPECT_LT(rows.size(), 20u);
  EXPECT_EQ(rows.front().frame, 0u);
  EXPECT_EQ(rows.back().frame, 100u);
  const auto has = [&](std::size_t frame) {
    return std::any_of(rows.begin(), rows.end(), [frame](const auto& row) { return row.frame == frame; });
  };
  EXPECT_TRUE(has(50)) << "set by hand";
  EXPECT_TRUE(has(30)) << "where a finding begins";
  for (const auto& row : rows) {
    EXPECT_TRUE(row.checked);
    const bool touches = row.frame >= 30 && row.frame <= 40;
    if (touches) {
      EXPECT_EQ(row.mark, Mark::kContact) << row.frame;
      EXPECT_TRUE(row.finding.contains("table"));
    }
    if (row.frame > 60) {
      EXPECT_EQ(row.mark, Mark::kNone) << row.frame;
    }
  }
  Motion unchecked = motion;
  unchecked.check.reset();
  EXPECT_FALSE(motionFrames(unchecked, 10).front().checked);
  EXPECT_TRUE(motionFrames(Motion{}, 10).empty()) << "still being read";
}

TEST(MotionFrames, AProgramShowsAllItsPointsByTheirNames) {
  trajectory::Trajectory program;
  for (int i = 0; i < 500; ++i) program.addFrame({0.1 * i, Pose::translation({0.01 * i, 0, 0}), true});
  program = trajectory::withName(program, 7, "above the clamp").value();
  Motion motion;
  motion.trajectory = std::make_shared<const trajectory::Trajectory>(program);
  const auto rows = motionFrames(motion, 200);
  ASSERT_EQ(rows.size(), 500u) << "each was set by somebody";
  EXPECT_EQ(rows[7].own_name, "above the clamp");
  EXPECT_EQ(rows[7].name, "above the clamp · 0.70 s");
  EXPECT_EQ(rows[8].name, "Frame 9 · 0.80 s") << "nothing else is said of what all of them are";
  // Of a recording the points that were set, and samples.
  trajectory::Trajectory mixed;
  for (int i = 0; i < 5000; ++i) mixed.addFrame({0.01 * i, Pose::translation({0.001 * i, 0, 0}), i % 10 == 3});
  motion.trajectory = std::make_shared<const trajectory::Trajectory>(mixed);
  const auto few = motionFrames(motion, 200);
  EXPECT_EQ(std::count_if(few.begin(), few.end(), [&](const auto& row) { return mixed[row.frame].by_hand; }), 500)
      << "however many they are";
  EXPECT_LE(few.size(), 702u);
  EXPECT_TRUE(std::any_of(few.begin(), few.end(), [](const auto& row) { return row.name.contains("by hand"); }));
}

TEST(Trace, IsColouredWhereTheCheckFoundSomething) {
  const auto curves = traceCurves(checkedMotion(), 600, {}, 0.0);
  double contact = 0.0, all = 0.0;
  bool by_hand = false;
  for (const SceneCurve& curve : curves) {
    by_hand = by_hand || (curve.points_W.size() == 1 && std::abs(curve.points_W[0].x - 0.5) < 1e-9);
    for (std::size_t i = 1; i < curve.points_W.size(); ++i) {
      const double way = glm::distance(curve.points_W[i], curve.points_W[i - 1]);
      all += way;
      if (curve.role == SceneCurve::Role::kContact) contact += way;
    }
  }
  EXPECT_NEAR(all, 1.0, 1e-9);
  EXPECT_NEAR(contact, 0.1, 0.011);
  EXPECT_TRUE(by_hand) << "a disc for a frame set by hand";
}

TEST(Limits, ASolidHasAssumedOnesAndARobotItsOwn) {
  trajectory::Trajectory solid;
  EXPECT_EQ(limitsOf({}, solid).velocity.size(), 6u);
  EXPECT_EQ(limitsOf({}, solid).acceleration[0], 2.0);
}

TEST(KeptMotion, WhatIsAskedIsMeasuredOnTheFile) {
  trajectory::Trajectory given, kept;
  for (int i = 0; i <= 50; ++i) {
    given.addFrame({0.1 * i, Pose::translation({0.01 * i, 0, i == 25 ? 0.004 : 0.0})});
    if (i % 50 == 0) kept.addFrame(given[static_cast<std::size_t>(i)]);
  }
  const auto measure = [&](const trajectory::PathTolerance& tolerance) {
    return missedPromise(kept, [&](const auto& file) {
      EXPECT_TRUE(std::filesystem::exists(file));
      return trajectory_checks::simplifyPromises(given, tolerance, file);
    });
  };
  EXPECT_FALSE(measure({0.005, 0.1, 0.1}).has_value());
  const auto missed = measure({0.001, 0.1, 0.1});
  ASSERT_TRUE(missed.has_value());
  EXPECT_EQ(missed->name, "position");
  EXPECT_NEAR(missed->measured, 0.004, 1e-9);
  EXPECT_TRUE(missedPromise(kept, [](const auto&) -> Expected<Promises> { return makeError({.found = "unreadable"}); }))
      << "what cannot be measured is not kept";
}

TEST(ExerciseFiles, WhatCannotBeReadBackIsNotKept) {
  const test::TemporaryFolder folder;
  trajectory::Trajectory expert;
  expert.entity = "part";
  for (int i = 0; i < 10; ++i) expert.addFrame({0.1 * i, Pose::translation({0.01 * i, 0, 0})});
  manipulation::Exercise exercise;
  exercise.name = "Over";
  exercise.text = "Follow it.";
  exercise.workcell = folder.path() / "cell.hcell";
  const QString file = QString::fromStdString((folder.path() / "over.hexercise").string());
  const auto files = [&] { return std::distance(std::filesystem::directory_iterator(folder.path()), {}); };
  exercise.stiffness = 600.0;  // More than an exercise may have: the file could not be opened.
  const auto refused = saveExercise(exercise, expert, file);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message().find("stiffness"), std::string::npos) << refused.error().message();
  EXPECT_EQ(files(), 0) << "neither the exercise nor its recording is kept";
  exercise.stiffness = 300.0;
  const auto saved = saveExercise(exercise, expert, file);
  ASSERT_TRUE(saved.has_value()) << saved.error().message();
  EXPECT_EQ(files(), 2);
  EXPECT_EQ(manipulation::readExercise(file.toStdString())->stiffness, 300.0);
}

TEST(Formats, TheUsualOneIsThatOfTheRobotsController) {
  const std::pair<const char*, const char*> robots[]{
      {"kuka_kr16_2", "krl"}, {"ABB IRB 4600", "rapid"}, {"fanuc_lrmate200id", "fanuc"}, {"ur5e", "urscript"},
      {"UR10", "urscript"},   {"my_ur_20", "urscript"},  {"staubli_tx2_60", "val3"},     {"motoman_gp7", "inform"},
      {"turntable", "ros"},   {"franka_panda", "ros"},   {"four5", "ros"}};
  for (const auto& [name, word] : robots) {
    kinematics::RobotModel model;
    model.name = name;
    EXPECT_EQ(usualFormat(model).toStdString(), word) << name;
  }
}

TEST(Formats, EachHasAWordAndANameOfItsOwn) {
  std::set<QString> words, names;
  for (const MotionFormat& format : motionFormats()) {
    EXPECT_TRUE(words.insert(format.word).second) << format.word.toStdString();
    EXPECT_TRUE(names.insert(format.name).second) << format.name.toStdString();
  }
  for (const char* program : {"krl", "rapid", "fanuc", "urscript", "val3", "inform"})
    EXPECT_EQ(words.count(program), 1u) << program;
}

}  // namespace
}  // namespace hapticell::app
