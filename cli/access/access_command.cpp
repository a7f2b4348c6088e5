// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "access/access_report.h"
#include "access/removal_check.h"
#include "cli/access/access_commands.h"
#include "cli/access/access_json.h"
#include "cli/kit/kept_result.h"
#include "cli/kit/stop_signal.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/body/anthropometry.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using namespace access;
using nlohmann::ordered_json;

/// m/s of the written way: an unhurried hand. Half: slow; twice: hasty.
constexpr double kHandSpeed = 0.1;
/// m: a larger tolerance would hide real blockers. Half: some press fits cannot be asked about; twice: walls vanish.
constexpr double kMostTolerance = 2e-3;

struct AccessOptions {
  std::string workcell, part, within, sex, report, output, shown;
  std::vector<double> percentiles, tool;
  double tolerance = AccessQuestion().tolerance, glove = BodyQuestion().glove;
  std::optional<double> mass;
  bool nobody = false, allow_miss = false;
};

/// "P5F", "P62.5M"
std::string bodyName(mannequin::Sex sex, double percentile) {
  return "P" + shortNumber(percentile) + (sex == mannequin::Sex::kMale ? "M" : "F");
}

Expected<std::vector<mannequin::NamedFigure>> bodiesOf(const AccessOptions& options) {
  if (options.nobody) return std::vector<mannequin::NamedFigure>();
  if (options.percentiles.empty() && options.sex.empty()) return mannequin::boundaryFigures();
  const std::vector<double> percentiles = options.percentiles.empty() ? std::vector{5.0, 50.0, 95.0} : options.percentiles;
  std::vector<mannequin::NamedFigure> bodies;
  for (const auto sex : {mannequin::Sex::kFemale, mannequin::Sex::kMale}) {
    if (options.sex == (sex == mannequin::Sex::kMale ? "female" : "male")) continue;
    for (const double percentile : percentiles) {
      const auto stature = mannequin::statureOfPercentile(sex, percentile);
      HAPTICELL_TRY(stature);
      auto figure = mannequin::makeFigure({.sex = sex, .stature = *stature});
      HAPTICELL_TRY(figure);
      bodies.push_back({bodyName(sex, percentile), std::move(*figure)});
    }
  }
  return bodies;
}

Expected<AccessQuestion> accessQuestionOf(const AccessOptions& options, const workcell::Document& document) {
  AccessQuestion question;
  question.part = options.part;
  question.within = options.within;
  question.tolerance = options.tolerance;
  question.people.glove = options.glove;
  if (!options.tool.empty()) question.people.tool = {options.tool[0], 0.5 * options.tool[1]};
  auto bodies = bodiesOf(options);
  HAPTICELL_TRY(bodies);
  question.people.bodies = std::move(*bodies);
  if (const workcell::Entity* part = document.findByName(options.part)) question.people.load_kg = part->contact.mass;
  if (options.mass) question.people.load_kg = *options.mass;
  if (!options.shown.empty()) {
    auto shown = trajectory::readTrajectory(options.shown);
    HAPTICELL_TRY(shown);
    question.shown = std::make_shared<const trajectory::Trajectory>(std::move(*shown));
  }
  const auto source = manipulation::sourceOf(document, manipulation::pairDefaults(config::Configuration()));
  question.scene = manipulation::PreparedScene::prepare(source.entities, source.pairs, source.defaults);
  return question;
}

/// The way of the part in its turn, measured as it was written.
Expected<void> writeWay(const AccessOptions& options, const AccessAnswer& answer, ordered_json& json) {
  json["path"] = nullptr;
  const RemovalStep* step = answer.step();
  if (step == nullptr) {
    if (options.output.empty()) return {};
    return makeError({.file = options.output,
                      .found = Text("no way out was found for %1, so nothing was written", options.part),
                      .fix = "Ask without --output for what blocks it."});
  }
  std::string extension = fs::path(options.output).extension().string();
  if (options.output.empty()) extension = ".htraj";
  if (extension != ".htraj" && extension != ".csv")
    return makeError({.file = options.output,
                      .found = Text("the file's ending '%1'", extension),
                      .expected = ".htraj or .csv"});
  const auto motion = trajectoryOf(*answer.removal, step->unit, step->way, kHandSpeed);
  const std::string text = extension == ".csv" ? trajectory::toCsvText(motion) : trajectory::toJsonText(motion);
  const MeasureFile measure = [&](const fs::path& written) -> Expected<Promises> {
    const auto read = trajectory::readTrajectory(written);
    HAPTICELL_TRY(read);
    return removalPromises(*answer.removal, step->unit, step->gone, *read);
  };
  HAPTICELL_TRY(writeKept(options.output, text, extension, options.allow_miss, measure, json));
  if (!options.output.empty()) json["path"] = options.output;
  return {};
}

std::string dateToday() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  localtime_r(&now, &date);
  char text[20];
  std::strftime(text, sizeof text, "%Y-%m-%d", &date);
  return text;
}

Expected<ordered_json> accessAnswerOf(const AccessOptions& options) {
  const StopSignal stop;
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  HAPTICELL_TRY(document);
  for (const Text& note : notes.warnings) warn(note);
  const auto begin = std::chrono::steady_clock::now();
  const auto question = accessQuestionOf(options, *document);
  HAPTICELL_TRY(question);
  const auto prepared = std::chrono::steady_clock::now();
  const auto answer = accessOf(*question, {}, stop.asked());
  HAPTICELL_TRY(answer);
  if (!answer->is_complete) return makeError({.found = "stopped before everything was answered"});
  ordered_json json = accessJson(*question, *answer);
  HAPTICELL_TRY(writeWay(options, *answer, json));
  if (!options.report.empty()) {
    const Saying say = [](const Text& text) { return english(text); };
    const auto page = accessReport(*question, *answer, {fs::path(options.workcell).stem().string(), dateToday(), "en"}, say);
    HAPTICELL_TRY(ergonomics::writeReport(page, options.report));
    json["report"] = options.report;
  }
  const auto seconds = [](std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  };
  json["timing"] = {{"prepare_s", seconds(begin, prepared)}, {"answer_s", seconds(prepared, std::chrono::steady_clock::now())}};
  return json;
}

}  // namespace

void addAccessCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("access", "Check whether a part can be taken out, in which order, and who reaches and sees it");
  const auto options = std::make_shared<AccessOptions>();
  command.option("workcell", options->workcell, "Workcell document (.hcell)").takes(ValueKind::kWorkcell).required();
  command.option("--part", options->part, "Name of the solid that is to be taken out").required();
  command.option("--within", options->within,
                 "Assembly that it has to leave, and whose unlocked parts may go first (default: the topmost one)");
  command.option("--sex", options->sex, "Only women or only men").among({"female", "male"});
  command.option("--percentile", options->percentiles, "Percentiles of stature, such as 5,50,95")
      .separatedByCommas();
  command.flag("--nobody", options->nobody, "Evaluate the part alone, without persons");
  command.option("--glove", options->glove, "Room around the bare hand, m (default: 0.002)").within(0.0, 0.05);
  command.option("--tool", options->tool, "A straight tool between hand and part: LENGTH,DIAMETER in m")
      .separatedByCommas()
      .values(2);
  command.option("--mass", options->mass, "Mass of the part, kg (default: as in the cell)").within(0.0, 200.0);
  command.option("--tolerance", options->tolerance, "Overlap that counts as touching, m (default: 0.0001)")
      .within(0.0, kMostTolerance);
  command.option("--shown", options->shown, "Recorded motion of the part, checked and used instead of a search")
      .takes(ValueKind::kMotion);
  command.option("--report", options->report, "Page to write: .pdf, .html or .csv").takes(ValueKind::kFile);
  command.option("-o,--output", options->output, "Motion of the part to write (.htraj or .csv)").takes(ValueKind::kMotion);
  addAllowMiss(command, options->allow_miss);
  command.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      const auto answer = accessAnswerOf(*options);
      const auto written = answer ? writer.write(*answer) : Expected<void>(tl::unexpected<Error>(answer.error()));
      if (written) return ExitStatus::kDone;
      report(written.error());
      return ExitStatus::kBadInput;
    };
  });
}

}  // namespace hapticell::cli
