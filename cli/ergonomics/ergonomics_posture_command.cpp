// SPDX-License-Identifier: Apache-2.0
// `ergonomics posture`, `en1005`, `iso11226`, `eaws` and `workplace`: what needs a figure, zones, or a whole cell.
#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <memory>
#include <optional>
#include <string>

#include "cli/ergonomics/ergonomics_advice_report.h"
#include "cli/ergonomics/ergonomics_commands.h"
#include "cli/ergonomics/ergonomics_input.h"
#include "cli/ergonomics/ergonomics_posture_input.h"
#include "cli/kit/command_listener.h"
#include "cli/kit/kept_result.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/ergonomics/report/posture_report.h"
#include "mannequin/ergonomics/scores/hand_force.h"
#include "mannequin/posture/posture_file.h"
#include "mannequin/shape/figure_model.h"
#include "studies/workplace/workplace_check.h"
#include "studies/workplace/workplace_search.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;
using namespace ergonomics;

struct PostureOptions {
  std::string cell, mannequin;
  std::string sex = "male", posture = "standing", task;
  std::optional<double> percentile, stature, mass;
  std::vector<std::string> reports, task_reports;
  std::string language = "en", date, picture, force_limits, company, logo;
  std::string input;
  std::vector<std::string> station;
  std::vector<double> rise{-0.2, 0.2, 0.04}, away{-0.12, 0.2, 0.04};
  bool sit = false, allow_miss = false;
  std::optional<double> fail_over;
};

/// Who is scored, in which posture, at which task.
struct Subject {
  PostureReportInput input;
  std::shared_ptr<const workcell::DocumentState> state{};
  workcell::EntityId id = 0;
  std::vector<Text> warnings{};  ///< Of reading the cell.
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  char text[16];
  return std::strftime(text, sizeof text, "%Y-%m-%d", &parts) > 0 ? text : "";
}

Expected<Subject> subjectOfCell(const PostureOptions& options) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.cell, notes);
  HAPTICELL_TRY(document);
  const workcell::DocumentState& state = document->state();
  const workcell::Entity* found = nullptr;
  for (const auto& entity : state.entities) {
    const bool wanted = options.mannequin.empty() ? !found : entity->name == options.mannequin;
    if (entity->figure() && wanted) found = entity.get();
  }
  if (!found)
    return makeError(
        {.file = options.cell,
         .place = "--mannequin",
         .found = options.mannequin.empty() ? Text("no mannequin in the cell") : Text("'" + options.mannequin + "'"),
         .expected = "the name of a mannequin of the cell"});
  Subject subject;
  subject.state = std::make_shared<workcell::DocumentState>(state);
  subject.id = found->id;
  subject.warnings = notes.warnings;
  subject.input.figure = *found->figure();
  subject.input.posture = mannequin::toPosture(*found->figure(), {found->X_WE, found->joints()});
  if (const WorkTask* task = state.workTaskOf(found->name)) subject.input.task = *task;
  subject.input.subtitle = options.cell + ", " + found->name;
  return subject;
}

Expected<Subject> subjectOfFigure(const PostureOptions& options) {
  mannequin::BodyRequest request;
  if (options.sex != "male" && options.sex != "female")
    return makeError({.place = "--sex", .found = "'" + options.sex + "'", .expected = "male or female"});
  request.sex = options.sex == "male" ? mannequin::Sex::kMale : mannequin::Sex::kFemale;
  if (options.percentile.has_value() == options.stature.has_value())
    return makeError({.found = options.stature ? Text("both --percentile and --stature") : Text("no body size"),
                      .expected = "--cell, or one of --percentile and --stature"});
  const auto stature = options.stature ? Expected<double>(*options.stature)
                                       : mannequin::statureOfPercentile(request.sex, *options.percentile);
  HAPTICELL_TRY(stature);
  request.stature = *stature;
  request.mass = options.mass;
  const auto figure = mannequin::makeFigure(request);
  HAPTICELL_TRY(figure);
  Subject subject;
  subject.input.figure = *figure;
  if (const auto known = mannequin::libraryPosture(*figure, options.posture)) {
    subject.input.posture = *known;
  } else {
    bool has_root = false;
    const auto read = mannequin::readPosture(options.posture, &has_root);
    HAPTICELL_TRY(read);
    subject.input.posture = has_root ? *read : mannequin::onFloor(*figure, *read);
  }
  subject.input.subtitle = options.posture;
  subject.input.source = options.posture;
  return subject;
}

Expected<Subject> subjectOf(const PostureOptions& options) {
  auto subject = options.cell.empty() ? subjectOfFigure(options) : subjectOfCell(options);
  if (!subject) return subject;
  if (!options.task.empty()) {
    const auto given = readErgonomicsInput(options.task);
    HAPTICELL_TRY(given);
    const auto task = workTaskInput(*given);
    HAPTICELL_TRY(task);
    subject->input.task = *task;
  }
  if (!options.force_limits.empty()) {
    auto limits = readForceTable(options.force_limits);
    HAPTICELL_TRY(limits);
    subject->input.own_limits = std::move(*limits);
  }
  if (!options.picture.empty()) {
    auto picture = readPng(options.picture);
    HAPTICELL_TRY(picture);
    subject->input.scene = std::move(*picture);
  }
  if (!options.logo.empty()) {
    auto logo = readPng(options.logo);
    HAPTICELL_TRY(logo);
    subject->input.logo = std::move(*logo);
  }
  subject->input.company = options.company;
  subject->input.language = languageOf(options.language);
  subject->input.date = options.date.empty() ? today() : options.date;
  return subject;
}

Expected<void> writeReports(const PostureOptions& options, PostureReportInput& input) {
  if (options.reports.empty() && options.task_reports.empty()) return {};
  input.places = betterPlaces(input.figure, input.posture, input.task);
  input.bodies = atSameTask(mannequin::boundaryFigures(), input.figure, input.posture, input.task);
  const Report page = postureReport(input);
  for (const std::string& file : options.reports) {
    if (auto written = writeReport(page, file); !written) return written;
  }
  const Report task_page = taskReport(input);
  for (const std::string& file : options.task_reports) {
    if (auto written = writeReport(task_page, file); !written) return written;
  }
  return {};
}

ExitStatus failed(const Error& error) {
  report(error);
  return ExitStatus::kBadInput;
}

ExitStatus runPosture(const PostureOptions& options, const ResultWriter& writer) {
  auto subject = subjectOf(options);
  if (!subject) return failed(subject.error());
  const auto pose = mannequin::forwardKinematics(subject->input.figure, subject->input.posture);
  const PostureScores scores = scorePosture(subject->input.figure, subject->input.posture, pose, subject->input.task);
  if (auto written = writeReports(options, subject->input); !written) return failed(written.error());
  ordered_json document = postureScoresReport(subject->input, scores);
  if (subject->input.task.is_lift)
    document["niosh"] = liftOfPosture(subject->input.figure, pose, scores, subject->input.task);
  document["hand_forces"] =
      handForcesReport(handForces(subject->input.figure, pose, subject->input.task, subject->input.own_limits));
  if (!subject->warnings.empty()) document["warnings"] = subject->warnings;
  if (auto written = writer.write(document); !written) return failed(written.error());
  return options.fail_over && scores.rula() > *options.fail_over ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

ExitStatus runZones(const std::string& method, const PostureOptions& options, const ResultWriter& writer) {
  const auto input = readErgonomicsInput(options.input);
  if (!input) return failed(input.error());
  const auto judged = method == "eaws" ? eawsReport(*input) : zonesReport(method, *input);
  if (!judged) return failed(judged.error());
  if (auto written = writer.write(*judged); !written) return failed(written.error());
  const auto& level = (*judged)["level"];
  return options.fail_over && level.get<double>() > *options.fail_over ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

Expected<studies::WorkplaceQuestion> questionOf(const PostureOptions& options, const Subject& subject) {
  studies::WorkplaceQuestion question;
  for (const auto& entity : subject.state->entities) question.entities.push_back(*entity);
  question.mannequin = subject.id;
  for (const std::string& name : options.station) {
    const workcell::Entity* entity = subject.state->findByName(name);
    if (!entity)
      return makeError({.file = options.cell,
                        .place = "--station",
                        .found = "'" + name + "'",
                        .expected = "names of entities of the cell"});
    question.station.push_back(entity->id);
  }
  question.task = subject.input.task;
  question.rise_from = options.rise[0], question.rise_to = options.rise[1], question.rise_step = options.rise[2];
  question.away_from = options.away[0], question.away_to = options.away[1], question.away_step = options.away[2];
  question.may_sit = options.sit;
  return question;
}

ExitStatus runWorkplace(const PostureOptions& options, const ResultWriter& writer) {
  if (options.cell.empty()) return failed({"", "--cell", "not given", "a workcell with a mannequin at its task", ""});
  const auto subject = subjectOf(options);
  if (!subject) return failed(subject.error());
  const auto question = questionOf(options, *subject);
  if (!question) return failed(question.error());
  const std::atomic<bool> never{false};
  const CommandListener* const listener = commandListener();
  manipulation::SceneService scenes;
  const auto map = studies::searchWorkplace(*question, scenes, {}, listener != nullptr ? listener->stopAsked() : never);
  if (!map) return failed(map.error());
  ordered_json result = workplaceReport(*map);
  result["moves"] = ordered_json::array();
  for (const workcell::EntityId id : studies::movedWith(*question)) {
    for (const workcell::Entity& entity : question->entities)
      if (entity.id == id) result["moves"].push_back(entity.name);
  }
  if (map->best >= 0) {
    const auto measure = [&](const std::filesystem::path& file) -> Expected<Promises> {
      const auto place = bestPlaceIn(file);
      HAPTICELL_TRY(place);
      return studies::workplacePromises(*question, *place, studies::movedCell(*question, *place), scenes);
    };
    const auto kept = writeKept("", result.dump(), ".json", options.allow_miss, measure, result);
    if (!kept) return failed(kept.error());
  }
  if (auto written = writer.write(result); !written) return failed(written.error());
  const bool good = map->best >= 0 &&
                    (!options.fail_over || map->cells[static_cast<std::size_t>(map->best)].worst <= *options.fail_over);
  return options.fail_over && !good ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

void addSubject(Subcommand app, PostureOptions& options) {
  app.option("--cell", options.cell, "Workcell: its mannequin in its posture, with its task data")
      .takes(ValueKind::kWorkcell);
  app.option("--mannequin", options.mannequin, "Name of the mannequin of the cell (default: the first)");
  app.option("--sex", options.sex, "male or female, without a cell");
  app.option("--percentile", options.percentile, "Percentile of stature, without a cell");
  app.option("--stature", options.stature, "m, without a cell");
  app.option("--mass", options.mass, "kg, without a cell");
  app.option("--posture", options.posture, "A posture file, or a name of the library, without a cell")
      .takes(ValueKind::kJson);
  app.option("--task", options.task, "Task data as JSON: a file, the text itself, or -").takes(ValueKind::kJson);
}

}  // namespace

void addErgonomicsPostureCommands(Subcommand ergonomics, Action& chosen) {
  const auto options = std::make_shared<PostureOptions>();
  Subcommand posture = ergonomics.add("posture", "Score a mannequin's posture by all methods, with a report");
  addSubject(posture, *options);
  posture.option("--report", options->reports, "Write a report: .pdf, .html, .csv or .json; can be repeated")
      .takes(ValueKind::kFile);
  posture.option("--task-report", options->task_reports, "The task's page, in the same formats")
      .takes(ValueKind::kFile);
  posture.option("--picture", options->picture, "PNG for the report: the mannequin in its cell (hapticell --render)")
      .takes(ValueKind::kPicture);
  posture.option("--company", options->company, "Company name for the report");
  posture.option("--logo", options->logo, "Company logo for the report, a PNG").takes(ValueKind::kPicture);
  posture.option("--force-limits", options->force_limits, "Table of custom hand force limits (docs/user/formats.md)")
      .takes(ValueKind::kFile);
  posture.option("--language", options->language, "Language of the report: en or fr").among({"en", "fr"});
  posture.option("--date", options->date, "Date printed in the report (default: today)");
  posture.option("--fail-over", options->fail_over, "Exit 1 if RULA is above this");
  posture.onChosen(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runPosture(*options, writer); }; });
  for (const auto& [name, description] :
       {std::pair{"en1005", "EN 1005-4 zones of a posture, from angles"},
        std::pair{"iso11226", "ISO 11226 zones and holding times of a static posture, from angles"},
        std::pair{"eaws", "Points of the EAWS posture section (an outline), from shares of the cycle"}}) {
    Subcommand zones = ergonomics.add(name, description);
    zones.option("--input", options->input, "JSON: a file, the text itself, or - for standard input")
        .takes(ValueKind::kJson)
        .required();
    zones.option("--fail-over", options->fail_over, "Exit 1 if the level is above this");
    zones.onChosen([options, &chosen, method = std::string(name)] {
      chosen = [options, method](ResultWriter& writer) { return runZones(method, *options, writer); };
    });
  }
  Subcommand workplace = ergonomics.add("workplace", "Find the best placement of a table for four mannequins");
  addSubject(workplace, *options);
  workplace.option("--station", options->station, "Entities that move with the targets, separated by commas")
      .separatedByCommas()
      .required();
  workplace.option("--rise", options->rise, "Height range: from,to,step, m").separatedByCommas().values(3);
  workplace.option("--away", options->away, "Range away from the mannequin: from,to,step, m")
      .separatedByCommas()
      .values(3);
  workplace.flag("--sit", options->sit, "Try sitting as well");
  workplace.option("--fail-over", options->fail_over, "Exit 1 if no placement is this good");
  addAllowMiss(workplace, options->allow_miss);
  workplace.onChosen(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runWorkplace(*options, writer); }; });
}

}  // namespace hapticell::cli
