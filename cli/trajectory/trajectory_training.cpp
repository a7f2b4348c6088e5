// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include "cli/trajectory/motion_file.h"
#include "cli/trajectory/trajectory_edits.h"
#include "config/configuration.h"
#include "haptic/devices/hand_path.h"
#include "manipulation/session/session.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/motion_curves.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/training/training.h"
#include "workcell/files/document_lock.h"
#include "workcell/format/document_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

struct TrainingOptions {
  std::string file, output, run, hand, trainee, results, csv, date = "1970-01-01T00:00:00Z", folder, kind = "practice";
  double help = -1.0, scale = 1.0;
  std::size_t samples = 2000;
};

ordered_json scoreJson(const trajectory::TrainingScore& score) {
  return {{"points", score.points},
          {"completed", score.completed},
          {"time", score.time},
          {"expert_time", score.expert_time},
          {"mean_deviation", score.mean_deviation},
          {"max_deviation", score.max_deviation},
          {"mean_turn", score.mean_turn},
          {"mean_force", score.mean_force},
          {"max_force", score.max_force},
          {"smoothness", score.smoothness},
          {"expert_smoothness", score.expert_smoothness},
          {"contacts", score.contacts},
          {"contact_time", score.contact_time}};
}

std::string curvesText(const trajectory::MotionCurves& curves) {
  std::string text = "t";
  std::vector<const trajectory::MotionCurve*> all;
  for (const auto& curve : curves.cartesian) all.push_back(&curve);
  for (const auto& curve : curves.joints) all.push_back(&curve);
  for (const auto* curve : all)
    for (const char* order : {"", "_speed", "_acceleration", "_jerk"}) text += "," + curve->name + order;
  text += '\n';
  for (std::size_t i = 0; i < curves.samples; ++i) {
    text += trajectory::shortestText(curves.timeOf(i));
    for (const auto* curve : all)
      for (const auto* values : {&curve->value, &curve->speed, &curve->acceleration, &curve->jerk})
        text += "," + trajectory::shortestText((*values)[i]);
    text += '\n';
  }
  return text;
}

Expected<ordered_json> curves(const TrainingOptions& options) {
  const auto given = readMotionFile(options.file);
  HAPTICELL_TRY(given);
  const auto curves = trajectory::motionCurves(*given, options.samples);
  if (curves.samples == 0)
    return makeError(
        {.file = options.file, .place = "frames", .found = std::to_string(given->size()), .expected = "two or more"});
  if (!options.output.empty())
    if (auto written = writeFileAtomically(options.output, curvesText(curves)); !written)
      return tl::unexpected(written.error());
  ordered_json result{{"samples", curves.samples}, {"step", curves.step}};
  const auto add = [&](const trajectory::MotionCurve& curve) {
    const auto peaks = trajectory::peaksOf(curve);
    result["peaks"][curve.name] = {{"speed", peaks.speed}, {"acceleration", peaks.acceleration}, {"jerk", peaks.jerk}};
  };
  add(curves.path);
  for (const auto& curve : curves.cartesian) add(curve);
  for (const auto& curve : curves.joints) add(curve);
  return result;
}

Expected<ordered_json> score(const TrainingOptions& options) {
  const auto expert = readMotionFile(options.file);
  HAPTICELL_TRY(expert);
  const auto run = readMotionFile(options.run);
  HAPTICELL_TRY(run);
  if (expert->empty())
    return makeError({.file = options.file, .place = "frames", .found = "none", .expected = "the motion of an expert"});
  return scoreJson(trajectory::scoreRun(*expert, *run));
}

Expected<manipulation::SessionOptions> sessionOf(const TrainingOptions& options, const manipulation::Exercise& exercise,
                                                 Trajectory expert, double help) {
  manipulation::SessionOptions session;
  const auto configuration = config::loadConfiguration({});
  HAPTICELL_TRY(configuration);
  session.configuration = *configuration;
  Diagnostics notes;
  const auto document = workcell::loadDocument(exercise.workcell, notes);
  HAPTICELL_TRY(document);
  session.entities = document->snapshotEntities();
  session.pairs = document->state().pairPolicy();
  session.guides = document->state().guides;
  session.entity = expert.entity;
  if (!expert.moved.empty()) {
    const auto moved_by = manipulation::parseMovedBy(expert.moved);
    HAPTICELL_TRY(moved_by);
    session.moved_by = *moved_by;
  }
  auto hand = haptic::readHandPath(options.hand);
  HAPTICELL_TRY(hand);
  for (const auto& sentence : hand->assumptions()) warn(Text("%1: %2.", options.hand, sentence));
  session.hand = std::move(*hand);
  session.axes.mode = manipulation::AxesMode::kCell;
  session.scale = {manipulation::ScaleLevel::kNumber, options.scale};
  session.recording = trajectory::RecordingOptions{};
  session.training = {exercise, std::move(expert), help};
  return session;
}

Expected<ordered_json> train(const TrainingOptions& options) {
  const auto exercise = manipulation::readExercise(options.file);
  HAPTICELL_TRY(exercise);
  auto expert = trajectory::readTrajectory(exercise->recording);
  HAPTICELL_TRY(expert);
  if (expert->empty())
    return makeError({.file = exercise->recording.string(),
                      .place = "frames",
                      .found = "none",
                      .expected = "the motion of an expert"});
  // From reading to writing: two runs at once would lose one.
  workcell::DocumentLock lock;
  if (!options.results.empty()) {
    auto taken = workcell::DocumentLock::takeForWriting(options.results);
    HAPTICELL_TRY(taken);
    lock = std::move(*taken);
  }
  trajectory::TrainingSession book{options.trainee, exercise->name, {}};
  if (!options.results.empty() && fs::exists(options.results)) {
    auto kept = trajectory::readTraining(options.results);
    HAPTICELL_TRY(kept);
    book = std::move(*kept);
  }
  const auto kind = trajectory::parseRunKind(options.kind);
  if (!kind)
    return makeError({.place = "--kind", .found = options.kind, .expected = "practice, retention or transfer"});
  const bool led = *kind == trajectory::RunKind::kPractice;
  const bool practised = book.count(trajectory::RunKind::kPractice) > 0;
  if (!led && practised != (*kind == trajectory::RunKind::kRetention))
    return makeError({.file = options.results,
                      .place = "--kind",
                      .found = options.kind,
                      .expected = practised ? Text("retention: an exercise that the trainee practised")
                                            : Text("transfer: an exercise that the trainee did not practise")});
  double help = 0.0;
  if (led) help = options.help >= 0.0 ? std::min(1.0, options.help) : book.nextHelp();
  const manipulation::TrainingRun scorer(*exercise, *expert, help);
  auto session = sessionOf(options, *exercise, std::move(*expert), help);
  HAPTICELL_TRY(session);
  const auto report = manipulation::runSession(*session);
  HAPTICELL_TRY(report);
  book.attempts.push_back(scorer.finish(report->recording, options.date));
  book.attempts.back().kind = *kind;
  std::vector<workcell::FileToWrite> files;
  if (!options.csv.empty()) files.push_back({options.csv, toCsvText(book)});
  if (!options.results.empty()) files.push_back({options.results, toJsonText(book)});
  HAPTICELL_TRY(workcell::writeFilesAtomically(files));
  HAPTICELL_TRY(saveTrajectory(report->recording, options.output));
  const auto& attempt = book.attempts.back();
  return ordered_json{{"exercise", exercise->name},
                      {"attempt", book.attempts.size()},
                      {"kind", wordOf(*kind)},
                      {"help", help},
                      {"success", attempt.success},
                      {"score", scoreJson(attempt.score)},
                      {"next_help", book.nextHelp()},
                      {"penetration", report->forces.penetration_max_m},
                      {"force_max", report->forces.force_max_n}};
}

Expected<ordered_json> exercises(const TrainingOptions& options) {
  ordered_json list = ordered_json::array();
  for (const fs::path& file : manipulation::exercisesIn(options.folder)) {
    const auto exercise = manipulation::readExercise(file);
    HAPTICELL_TRY(exercise);
    list.push_back({{"file", file.string()}, {"name", exercise->name}, {"text", exercise->text}});
  }
  return ordered_json{{"exercises", std::move(list)}};
}

using TrainingHandler = Expected<ordered_json> (*)(const TrainingOptions&);

}  // namespace

void addTrajectoryTraining(Subcommand command, Action& chosen) {
  const auto options = std::make_shared<TrainingOptions>();
  const auto add = [&](const char* name, const char* description, TrainingHandler handler) {
    Subcommand sub = command.add(name, description);
    sub.onChosen([options, &chosen, handler] {
      chosen = [options, handler](ResultWriter& writer) { return finishTrajectory(writer, handler(*options)); };
    });
    return sub;
  };
  Subcommand sub = add("curves", "List speed, acceleration and jerk over time", curves);
  sub.option("file", options->file, "A trajectory").takes(ValueKind::kMotion).required();
  sub.option("--samples", options->samples, "At most (2000)");
  sub.option("-o,--output", options->output, "A CSV file with all curves").takes(ValueKind::kTable);
  sub = add("score", "Score a trainee's run against the expert's", score);
  sub.option("file", options->file, "Trajectory of the expert").takes(ValueKind::kMotion).required();
  sub.option("--run", options->run, "Trajectory of the trainee").takes(ValueKind::kMotion).required();
  sub = add("train", "Simulate one run of an exercise", train);
  sub.option("file", options->file, "Exercise (.hexercise)").takes(ValueKind::kExercise).required();
  sub.option("--hand", options->hand, "Hand path of the trainee (CSV)").takes(ValueKind::kTable).required();
  sub.option("--help-share", options->help, "Guidance, 0 to 1 (default: from the results)");
  sub.option("--kind", options->kind, "practice (guided), or without guidance: retention, transfer");
  sub.option("--scale", options->scale, "Motion in the cell divided by motion of the hand (1)");
  sub.option("--trainee", options->trainee, "Trainee name, for new results");
  sub.option("--results", options->results, "Results file of the trainee (.htrain), read and written")
      .takes(ValueKind::kTrainingResults);
  sub.option("--csv", options->csv, "Write all runs as a table").takes(ValueKind::kTable);
  sub.option("--date", options->date, "Date for the results, ISO 8601");
  sub.option("-o,--output", options->output, "Recording of the run to write").takes(ValueKind::kMotion);
  sub = add("exercises", "List the exercises of a folder", exercises);
  sub.option("folder", options->folder, "Folder with *.hexercise files").takes(ValueKind::kFolder).required();
}

}  // namespace hapticell::cli
