// SPDX-License-Identifier: Apache-2.0
#include "trajectory/training/training.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/test_data.h"
#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/editing.h"
#include "trajectory/training/path_progress.h"

namespace hapticell::trajectory {
namespace {

using test::gestureAt;
using test::recordedGesture;

/// A file of this test alone, gone at its end.
struct OwnFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("training-" + std::to_string(::getpid()) + ".htrain");
  ~OwnFile() { std::filesystem::remove(path); }
};

/// Down into a hole and out again: the same places twice.
Trajectory inAndOut() {
  Trajectory motion;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.01 * i;
    motion.addFrame({t, Pose::translation({0, 0, -0.05 * (t <= 1.0 ? t : 2.0 - t)})});
  }
  return motion;
}

TEST(Training, ResultsOfVersion01AreRead) {
  const auto kept = readTraining(hapticell::test::sourceFile("tests/samples/0.1/kim.htrain"));
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_EQ(kept->trainee, "Kim");
  ASSERT_EQ(kept->attempts.size(), 2u);
  EXPECT_TRUE(kept->attempts[0].success);
  EXPECT_EQ(kept->attempts[0].score.points, 71.5);
  EXPECT_EQ(kept->attempts[1].score.contacts, 7);
  EXPECT_EQ(kept->attempts[1].kind, RunKind::kPractice);
  EXPECT_EQ(kept->nextHelp(), 0.8);
}

TEST(PathProgress, TellsTheWayInFromTheWayOut) {
  PathProgress progress(inAndOut());
  EXPECT_NEAR(progress.length(), 0.1, 1e-9);
  for (int i = 0; i <= 100; ++i) progress.follow(Pose::translation({0.001, 0, -0.0005 * i}));
  EXPECT_NEAR(progress.way(), 0.05, 2e-3);
  for (int i = 100; i >= 0; --i) progress.follow(Pose::translation({0.001, 0, -0.0005 * i}));
  // At the turning point both ways are equally near: it may have gone back the way it came.
  const bool out = progress.share() > 0.95, back = progress.share() < 0.05;
  EXPECT_TRUE(out || back);
}

TEST(PathProgress, WaitsForTheTraineeAndIsNotJumpedAhead) {
  PathProgress progress(recordedGesture(10.0, 50, 0.0));
  for (int i = 0; i < 50; ++i) progress.follow(gestureAt(0.0));
  EXPECT_LT(progress.way(), 1e-3);
  // A hand that leaps to the end is not there: the way between was not gone.
  for (int i = 0; i < 5; ++i) progress.follow(gestureAt(10.0));
  EXPECT_LT(progress.share(), 0.6);
  const auto window = progress.window(0.02, 0.03);
  double length = 0.0;
  for (std::size_t i = 1; i < window.size(); ++i) length += glm::distance(window[i - 1], window[i]);
  EXPECT_LT(length, 0.051);
}

/// The nearest place itself, so that the frames of a recording and the poses seen while it was made say the same.
TEST(PathProgress, DoesNotDependOnWhereItWasBefore) {
  Trajectory expert;
  for (int i = 0; i <= 4; ++i) expert.addFrame({0.1 * i, Pose::translation({0.05 * i, 0, 0})});
  const double end = 0.1973;
  for (const double step : {0.0017, 0.0049, 0.011, 0.023}) {
    PathProgress progress(expert);
    for (double x = 0.0; x < end; x += step) progress.follow(Pose::translation({x, 0.002, 0}));
    progress.follow(Pose::translation({end, 0.002, 0}));
    EXPECT_NEAR(progress.way(), end, 5e-5) << step;
  }
}

/// Beyond the last place and back a little, as a held part does when it is let go: a trainee who does not do that is there.
TEST(PathProgress, DoesNotAskToRepeatHowTheExpertSettled) {
  Trajectory expert;
  for (int i = 0; i <= 60; ++i) expert.addFrame({0.01 * i, Pose::translation({0.001 * i, 0, 0})});
  for (int i = 1; i <= 24; ++i) expert.addFrame({0.6 + 0.01 * i, Pose::translation({0.06 - 1e-4 * i, 0, 0})});
  PathProgress beyond(expert);
  for (int i = 0; i <= 80; ++i) beyond.follow(Pose::translation({0.001 * i, 0, 0}));
  EXPECT_EQ(beyond.share(), 1.0);
  PathProgress before(expert);
  for (int i = 0; i <= 50; ++i) before.follow(Pose::translation({0.001 * i, 0, 0}));
  EXPECT_LT(before.share(), 0.92);
  // Out and back again by more than that is part of the task.
  PathProgress in(inAndOut());
  for (int i = 0; i <= 100; ++i) in.follow(Pose::translation({0, 0, -0.0005 * i}));
  EXPECT_NEAR(in.share(), 0.5, 0.02);
}

/// What ends a run by itself is complete, though the recording's frames lie a little before and after.
TEST(ScoreRun, IsCompleteBeforeTheRunEndsByItself) {
  const Trajectory expert = recordedGesture(10.0, 200, 0.0);
  const PathProgress whole(expert);
  Trajectory run;
  for (int i = 0; i <= 985; ++i) run.addFrame({0.01 * i, whole.expertAt(0.001 * i * whole.length())});
  EXPECT_EQ(scoreRun(expert, run, {}).completed, 1.0);
  const Trajectory shorter = [&] {
    Trajectory first;
    for (std::size_t i = 0; i < 975; ++i) first.addFrame({0.01 * static_cast<double>(i), run[i].X_WT});
    return first;
  }();
  EXPECT_NEAR(scoreRun(expert, shorter, {}).completed, 0.974, 4e-3);
}

TEST(ScoreRun, TheExpertHimselfHasAllPoints) {
  const Trajectory expert = recordedGesture(6.0, 100, 0.0);
  const TrainingScore score = scoreRun(expert, expert);
  EXPECT_NEAR(score.points, 100.0, 0.5);
  EXPECT_EQ(score.completed, 1.0);
  EXPECT_LT(score.mean_deviation, 1e-4);
}

TEST(ScoreRun, HasPointsForARunOfAnyLengthOfTime) {
  const Trajectory expert = recordedGesture(6.0, 100, 0.0);
  Trajectory eternal;
  for (const auto& frame : expert.frames()) eternal.addFrame({1e300 * frame.t, frame.X_WT});
  const double points = scoreRun(expert, eternal).points;
  EXPECT_GE(points, 0.0);
  EXPECT_LT(points, 100.0);
}

TEST(ScoreRun, KnowsAShiftedSlowShakyRun) {
  const Trajectory expert = recordedGesture(6.0, 100, 0.0);
  const Trajectory aside = transformed(expert, Pose::translation({0.004, 0, 0}));
  const TrainingScore shifted = scoreRun(expert, aside);
  // The nearest place of the path is nearer than the shift, never farther.
  EXPECT_GT(shifted.mean_deviation, 0.001);
  EXPECT_LE(shifted.max_deviation, 0.0041);
  EXPECT_LT(shifted.points, 100.0);
  const TrainingScore shaky = scoreRun(expert, recordedGesture(6.0, 100, 0.002));
  EXPECT_LT(shaky.smoothness, shaky.expert_smoothness - 1.0);
  EXPECT_LT(shaky.points, shifted.points);
  Trajectory slow;
  for (const auto& frame : expert.frames()) slow.addFrame({2.0 * frame.t, frame.X_WT});
  EXPECT_NEAR(scoreRun(expert, slow).time, 12.0, 0.3);
  const auto half = trimmed(expert, 0.0, 3.0);
  ASSERT_TRUE(half.has_value());
  EXPECT_NEAR(scoreRun(expert, *half).completed, 0.5, 0.1);
  EXPECT_EQ(scoreRun(expert, Trajectory{}).points, 0.0);
}

TEST(ScoreRun, CountsForceAndContacts) {
  const Trajectory expert = recordedGesture(2.0, 50, 0.0);
  Trajectory run = expert.emptyCopy();
  run.channel_names = {"force_x", "force_y", "force_z", "contact"};
  for (std::size_t i = 0; i < expert.size(); ++i) {
    const double felt[4] = {0.0, 3.0, i == 10 ? 4.0 : 0.0, 1.0};
    run.addFrame(expert[i], {}, felt);
  }
  run.touches = {{0.1, 0.4, "peg", "wall", 5.0}, {1.0, 1.2, "peg", "wall", 3.0}};
  const TrainingScore score = scoreRun(expert, run);
  EXPECT_DOUBLE_EQ(score.max_force, 5.0);
  EXPECT_NEAR(score.mean_force, 3.0, 0.05);
  EXPECT_EQ(score.contacts, 2);
  EXPECT_NEAR(score.contact_time, 0.5, 1e-12);
  EXPECT_LT(score.points, 90.0);
}

TEST(NextHelp, FadesWithSuccess) {
  TrainingSession session{"Ana", "Peg in hole", {}};
  EXPECT_EQ(session.nextHelp(), 1.0);
  double help = 1.0;
  for (int i = 0; i < 5; ++i) {
    session.attempts.push_back({"2026-01-01T00:00:00Z", help, true, {}});
    EXPECT_LT(session.nextHelp(), help + 1e-12);
    help = session.nextHelp();
  }
  EXPECT_EQ(help, 0.0);
  session.attempts.push_back({"", 0.0, false, {}});
  EXPECT_EQ(session.nextHelp(), 0.0);
  session.attempts.push_back({"", 0.0, false, {}});
  EXPECT_NEAR(session.nextHelp(), 0.1, 1e-12);
}

TEST(TrainingFile, ComesBackAsItWasWritten) {
  TrainingSession session{"Ana \"A\" Lee", "Door", {}};
  session.attempts.push_back(
      {"2026-05-04T10:11:12+02:00", 0.8, true, scoreRun(recordedGesture(2, 50, 0), recordedGesture(2, 50, 0.001))});
  session.attempts.push_back({"2026-05-04T10:13:00+02:00", 0.6, false, {}});
  const OwnFile own;
  const auto& file = own.path;
  std::ofstream(file) << toJsonText(session);
  const auto read = readTraining(file);
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(toJsonText(*read), toJsonText(session));
  EXPECT_EQ(read->attempts[0].score.points, session.attempts[0].score.points);
  const std::string csv = toCsvText(session);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_TRUE(csv.starts_with("attempt,date,help,success,points"));
}

TEST(TrainingFile, WhatIsWrongIsNamed) {
  const OwnFile own;
  const auto& file = own.path;
  for (const char* text :
       {"", "{}", "[1]", R"({"format":"hapticell-training","version":9})",
        R"({"format":"hapticell-training","version":1,"trainee":"a","exercise":"b","attempts":[{"date":"x"}]})",
        R"({"format":"hapticell-training","version":1,"trainee":"a","exercise":"b","attempts":3})"}) {
    std::ofstream(file) << text;
    const auto read = readTraining(file);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(read.error().message().find(own.path.string()), std::string::npos);
  }
}

TEST(TrainingSession, RunsWithoutGuidanceStandApart) {
  TrainingSession session{"Ana", "Peg", {}};
  const auto add = [&](RunKind kind, const char* date, double help, bool success, double points) {
    TrainingAttempt attempt;
    attempt.kind = kind;
    attempt.date = date;
    attempt.help = help;
    attempt.success = success;
    attempt.score.points = points;
    session.attempts.push_back(attempt);
  };
  add(RunKind::kPractice, "2026-02-28T23:00:00+01:00", 1.0, true, 90.0);
  add(RunKind::kRetention, "2026-03-01T22:00:00Z", 0.0, false, 40.0);
  session.attempts.back().recording = "runs/2.htraj";
  EXPECT_NEAR(session.nextHelp(), 0.8, 1e-12) << "a test takes and gives no help";
  EXPECT_EQ(session.restBefore("2026-03-01T22:00:00Z"), 86400.0) << "over the month's end and another zone";
  EXPECT_FALSE(session.restBefore("2026-02-28T20:00:00Z").has_value()) << "before all practice";
  EXPECT_FALSE(session.restBefore("soon").has_value());
  EXPECT_EQ(session.count(RunKind::kRetention), 1u);
  EXPECT_EQ(session.count(RunKind::kTransfer), 0u);
  const std::string csv = toCsvText(session);
  EXPECT_NE(csv.find(",contacts,kind,rest_s\n"), std::string::npos);
  EXPECT_NE(csv.find(",retention,86400\n"), std::string::npos) << csv;
  const auto file = std::filesystem::temp_directory_path() / ("kinds-" + std::to_string(::getpid()) + ".htrain");
  const auto read = [&](const std::string& text) {
    std::ofstream(file) << text;
    return readTraining(file);
  };
  const std::string text = toJsonText(session);
  const auto back = read(text);
  ASSERT_TRUE(back.has_value()) << back.error().message();
  EXPECT_EQ(back->attempts[0].kind, RunKind::kPractice);
  EXPECT_EQ(back->attempts[1].kind, RunKind::kRetention);
  EXPECT_EQ(back->attempts[1].recording, "runs/2.htraj");
  // Files of before there were kinds: all runs were practice.
  std::string old = text;
  for (const char* word : {"practice", "retention"}) {
    const std::string field = std::string("\"kind\": \"") + word + "\",";
    ASSERT_NE(old.find(field), std::string::npos) << old;
    old.erase(old.find(field), field.size());
  }
  const auto before = read(old);
  ASSERT_TRUE(before.has_value()) << before.error().message();
  EXPECT_EQ(before->attempts[1].kind, RunKind::kPractice);
  std::string odd = text;
  odd.replace(odd.find("retention"), 9, "holiday");
  EXPECT_FALSE(read(odd).has_value());
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace hapticell::trajectory
