// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/exercise.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <map>

#include "manipulation/session/session.h"
#include "tests/support/test_data.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::manipulation {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, double> kScales{{"peg_in_hole", 1.0}, {"door", 4.0}, {"screw", 1.0}, {"extraction", 2.0}};

struct Cell {
  Exercise exercise;
  trajectory::Trajectory expert;
  SessionOptions session;
};

Cell cellOf(const std::string& stem) {
  const fs::path folder = hapticell::test::sourceFile("config/exercises");
  Cell cell;
  const auto exercise = readExercise(folder / (stem + ".hexercise"));
  EXPECT_TRUE(exercise.has_value());
  if (!exercise) return cell;
  cell.exercise = *exercise;
  const auto expert = trajectory::readTrajectory(exercise->recording);
  EXPECT_TRUE(expert.has_value());
  Diagnostics notes;
  const auto document = workcell::loadDocument(exercise->workcell, notes);
  EXPECT_TRUE(document.has_value());
  const auto hand = haptic::readHandPath(folder / (stem + "-hand.csv"));
  EXPECT_TRUE(hand.has_value());
  if (!expert || !document || !hand) return cell;
  EXPECT_TRUE(notes.warnings.empty());
  cell.expert = *expert;
  SessionOptions& options = cell.session;
  options.entities = document->snapshotEntities();
  options.pairs = document->state().pairPolicy();
  options.guides = document->state().guides;
  options.entity = expert->entity;
  options.hand = *hand;
  options.moved_by = *parseMovedBy(expert->moved);
  options.axes.mode = AxesMode::kCell;
  options.scale = {ScaleLevel::kNumber, kScales.at(stem)};
  options.configuration.manipulation.rate_hz = 100;
  options.recording = trajectory::RecordingOptions{};
  return cell;
}

TEST(Exercise, OfVersion01IsReadWithItsCellAndMotion) {
  const fs::path folder = hapticell::test::sourceFile("tests/samples/0.1");
  const auto kept = readExercise(folder / "extraction.hexercise");
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_EQ(kept->name, "Extraction");
  EXPECT_EQ(kept->workcell, folder / "extraction.hcell");
  EXPECT_EQ(kept->recording, folder / "extraction-expert.htraj");
  EXPECT_EQ(kept->tube_radius, 0.015);
}

TEST(ExerciseFile, IsComparedFieldByField) {
  const test::TemporaryFolder folder;
  Exercise exercise;
  exercise.name = "Über den Tisch";
  exercise.text = "Follow \"it\".";
  exercise.workcell = folder.path() / "cell.hcell";
  exercise.recording = folder.path() / "sub/way.htraj";
  exercise.tube_radius = 1.0 / 30.0;
  const fs::path file = folder.write("a.hexercise", exerciseText(exercise, folder.path()));
  EXPECT_TRUE(checkExercise(exercise, file));
  const auto expectMiss = [&](const Exercise& wanted, const std::string& field) {
    const auto same = checkExercise(wanted, file);
    ASSERT_FALSE(same) << field;
    EXPECT_NE(same.error().message().find("'" + field + "'"), std::string::npos) << same.error().message();
  };
  Exercise other = exercise;
  other.name = "Über";
  expectMiss(other, "name");
  other = exercise, other.text += " ";
  expectMiss(other, "text");
  other = exercise, other.workcell = folder.path() / "other.hcell";
  expectMiss(other, "workcell");
  other = exercise, other.recording = folder.path() / "way.htraj";
  expectMiss(other, "recording");
  for (const auto& [field, value] :
       {std::pair("tube_radius", &other.tube_radius), std::pair("lead", &other.lead),
        std::pair("stiffness", &other.stiffness), std::pair("pass", &other.pass),
        std::pair("deviation_costs_all", &other.rule.deviation), std::pair("force_costs_all", &other.rule.force),
        std::pair("slowness_costs_all", &other.rule.slowness)}) {
    other = exercise;
    *value *= 1.0 + 1e-12;
    expectMiss(other, field);
  }
  // Written without a word, and refused by whoever opens it.
  other = exercise, other.stiffness = 600.0;
  folder.write("a.hexercise", exerciseText(other, folder.path()));
  expectMiss(other, "stiffness");
}

class Exercises : public testing::TestWithParam<const char*> {};

/// The expert's own hand, led by the expert's recording: it gets through, touches nothing it should not, and scores.
TEST_P(Exercises, TheSimulatedHandGetsThrough) {
  Cell cell = cellOf(GetParam());
  ASSERT_FALSE(cell.expert.empty());
  cell.session.training = {cell.exercise, cell.expert, 1.0};
  const auto report = runSession(cell.session);
  ASSERT_TRUE(report.has_value()) << report.error().message();
  EXPECT_GT(report->training_share, 0.98);
  EXPECT_LT(report->forces.penetration_max_m, 1e-4);
  const TrainingRun run(cell.exercise, cell.expert, 1.0);
  const auto attempt = run.finish(report->recording, "2026-01-01T00:00:00Z");
  EXPECT_TRUE(attempt.success) << attempt.score.points;
  EXPECT_GT(attempt.score.points, 75.0);
}

/// A hand that only holds on is led a good part of the way by the help alone; without help it stays where it is.
TEST_P(Exercises, AreWhatTheirFilesSay) {
  const fs::path folder = hapticell::test::sourceFile("config/exercises");
  const auto exercise = readExercise(folder / (std::string(GetParam()) + ".hexercise"));
  ASSERT_TRUE(exercise.has_value());
  EXPECT_FALSE(exercise->text.empty());
  EXPECT_TRUE(fs::exists(exercise->workcell) && fs::exists(exercise->recording));
}

INSTANTIATE_TEST_SUITE_P(Shipped, Exercises, testing::Values("peg_in_hole", "door", "screw", "extraction"));

TEST(TrainingRun, TheGuideGoesWithTheTraineeAndWaits) {
  trajectory::Trajectory expert;
  expert.entity = "peg";
  for (int i = 0; i <= 100; ++i) expert.addFrame({0.05 * i, Pose::translation({0.004 * i, 0, 0})});
  Exercise exercise;
  exercise.lead = 0.02;
  exercise.tube_radius = 0.01;
  TrainingRun run(exercise, expert, 1.0);
  for (int i = 0; i < 1000; ++i) run.follow({});
  EXPECT_NEAR(run.share(), 0.0, 1e-6) << "it waits";
  EXPECT_NEAR(run.guide().path.back().x, 0.03, 1e-9);
  EXPECT_EQ(run.guide().entity, "peg");
  EXPECT_TRUE(workcell::checkGuide(run.guide()).has_value());
  for (int i = 0; i <= 50; ++i) run.follow(Pose::translation({0.004 * i, 0.003, 0}));
  EXPECT_NEAR(run.share(), 0.5, 0.01);
  EXPECT_NEAR(run.guide().path.back().x, 0.23, 0.005);
  for (double x = 0.2; x < 0.3945; x += 0.004) run.follow(Pose::translation({x, 0.0, 0}));
  run.follow(Pose::translation({0.3945, 0.0, 0}));
  EXPECT_FALSE(run.isDone()) << "complete, though not so clearly that its recording must be";
  run.follow(Pose::translation({0.4, 0.0, 0}));
  EXPECT_TRUE(run.isDone());
  // Less help: a weaker pull in a wider tube; none: no guide.
  const TrainingRun half(exercise, expert, 0.5), none(exercise, expert, 0.0);
  EXPECT_NEAR(half.guide().help, 0.5 * exercise.stiffness, 1e-12);
  EXPECT_NEAR(half.guide().radius, 0.02, 1e-12);
  EXPECT_FALSE(none.guide().enabled);
}

/// The pull ahead is felt: a hand that holds loosely is moved along the expert's path.
TEST(TrainingRun, HelpLeadsAHandThatDoesNotGoItself) {
  Cell cell = cellOf("peg_in_hole");
  ASSERT_FALSE(cell.expert.empty());
  // The hand stays where it takes the peg.
  std::vector<haptic::HandSample> still;
  for (int i = 0; i <= 200; ++i) {
    haptic::HandSample sample = cell.session.hand.at(0.0);
    sample.t = 0.02 * i;
    sample.buttons = i >= 5 && i < 15 ? 1u : 0u;
    still.push_back(sample);
  }
  cell.session.hand = haptic::HandPath(std::move(still));
  std::map<double, double> went;
  for (const double help : {0.0, 1.0}) {
    cell.session.training = {cell.exercise, cell.expert, help};
    const auto report = runSession(cell.session);
    ASSERT_TRUE(report.has_value());
    went[help] = glm::distance(report->end.X_WM.p, cell.expert[0].X_WT.p);
    if (help > 0.0) {
      EXPECT_GT(report->forces.force_max_n, 0.5);
    }
  }
  EXPECT_LT(went[0.0], 5e-4);
  EXPECT_GT(went[1.0], went[0.0] + 5e-4);
}

TEST(ExerciseFile, ComesBackAndRefusesWhatIsOutOfRange) {
  Exercise exercise;
  exercise.name = "x";
  exercise.text = "do it";
  const fs::path folder = fs::temp_directory_path() / ("exercise-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  exercise.workcell = folder / "a.hcell";
  exercise.recording = folder / "sub" / "b.htraj";
  exercise.tube_radius = 0.0123;
  const auto write = [&](const std::string& text) {
    std::ofstream(folder / "x.hexercise") << text;
    return readExercise(folder / "x.hexercise");
  };
  const auto read = write(exerciseText(exercise, folder));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->recording, exercise.recording);
  EXPECT_EQ(read->tube_radius, 0.0123);
  exercise.stiffness = 501.0;
  EXPECT_FALSE(write(exerciseText(exercise, folder)).has_value());
  EXPECT_FALSE(write("{}").has_value());
  EXPECT_FALSE(write("no").has_value());
  EXPECT_EQ(exercisesIn(folder).size(), 1u);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace hapticell::manipulation
