// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>

#include "cli/ergonomics/ergonomics_commands.h"
#include "cli/ergonomics/ergonomics_input.h"
#include "cli/ergonomics/ergonomics_report.h"
#include "cli/kit/motion_options.h"
#include "mannequin/body/figure.h"
#include "mannequin/ergonomics/advice/motion_scores.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct ErgonomicsOptions {
  std::string input;
  std::string motion, up, markers;
  ergonomics::MotionTask task;
  std::optional<double> fail_over;
};

Expected<ordered_json> scored(const ergonomics::ScoredMethod& method, Expected<ScoredInput> input) {
  HAPTICELL_TRY(input);
  return scoredReport(method, *input);
}

Expected<ordered_json> lifting(const nlohmann::json& given) {
  const auto input = liftingInput(given);
  HAPTICELL_TRY(input);
  if (input->is_composite) {
    const auto result = ergonomics::compositeLift(input->tasks, input->conditions);
    HAPTICELL_TRY(result);
    return compositeReport(*input, *result);
  }
  const auto result = ergonomics::lift(input->tasks.front(), input->conditions);
  HAPTICELL_TRY(result);
  return liftingReport(input->tasks.front(), *result);
}

Expected<ordered_json> judge(const std::string& method, const nlohmann::json& input) {
  if (method == "rula") return scored(ergonomics::Rula(), rulaInput(input));
  if (method == "reba") return scored(ergonomics::Reba(), rebaInput(input));
  if (method == "owas") return scored(ergonomics::Owas(), owasInput(input));
  return lifting(input);
}

ergonomics::MotionMethod motionMethodOf(const std::string& method) {
  if (method == "rula") return ergonomics::MotionMethod::kRula;
  if (method == "reba") return ergonomics::MotionMethod::kReba;
  return ergonomics::MotionMethod::kOwas;
}

Expected<ordered_json> judgeMotion(const std::string& method, const ErgonomicsOptions& options) {
  const auto reading = motionReading(options.up, options.markers);
  HAPTICELL_TRY(reading);
  const auto recorded = mannequin::readRecordedMotion(options.motion, *reading);
  HAPTICELL_TRY(recorded);
  const auto figure = mannequin::makeFigure({});
  HAPTICELL_TRY(figure);
  const ergonomics::MotionMethod kind = motionMethodOf(method);
  auto scores = ergonomics::scoreMotion(*recorded, *figure, kind, options.task);
  if (!scores) {
    if (scores.error().file.empty()) scores.error().file = options.motion;
    return tl::unexpected(scores.error());
  }
  ordered_json report = motionReport(kind, *scores, options.task);
  addReading(*recorded, report);
  return report;
}

Expected<ordered_json> result(const std::string& method, const ErgonomicsOptions& options) {
  if (options.input.empty() == options.motion.empty()) {
    return makeError({.place = "--input, --motion",
                      .found = options.input.empty() ? Text("neither is given") : Text("both are given"),
                      .expected = "one of the two"});
  }
  if (!options.motion.empty()) return judgeMotion(method, options);
  if (!options.up.empty() || !options.markers.empty())
    return makeError(
        {.place = "--up, --markers", .found = "given without --motion", .expected = "--motion with a recorded motion"});
  const auto input = readErgonomicsInput(options.input);
  HAPTICELL_TRY(input);
  auto judged = judge(method, *input);
  const bool is_file = options.input.find('{') == std::string::npos;
  if (!judged && judged.error().file.empty() && is_file) judged.error().file = options.input;
  return judged;
}

/// No score (a load that nobody may lift, a posture that cannot be judged) counts as over any limit.
bool isOver(const ordered_json& report, const std::optional<double>& limit) {
  if (!limit) return false;
  const auto& score = report["score"];
  return !score.is_number() || score.get<double>() > *limit;
}

ExitStatus run(const std::string& method, const ErgonomicsOptions& options, const ResultWriter& writer) {
  const auto failed = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  const auto judged = result(method, options);
  if (!judged) return failed(judged.error());
  if (const auto written = writer.write(*judged); !written) return failed(written.error());
  return isOver(*judged, options.fail_over) ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

void addMotionOptions(Subcommand method, const std::string& name, ErgonomicsOptions& options) {
  method
      .option("--motion", options.motion,
              "Recorded motion to score instead: .bvh, .amc with its .asf, or .c3d (markers)")
      .takes(ValueKind::kFile);
  addMotionReading(method, options.up, options.markers);
  const auto whole = [&](const char* option, int& value, int greatest, const char* description) {
    method.option(option, value, description).withinWhole(0, greatest);
  };
  if (name == "rula") {
    whole("--muscle-use", options.task.muscle_use, 1, "Of the motion: static or repeated (0, 1)");
    whole("--force", options.task.force, 3, "Of the motion (0 to 3)");
  } else if (name == "reba") {
    whole("--load", options.task.load, 3, "Of the motion (0 to 3)");
    whole("--coupling", options.task.coupling, 3, "Of the motion (0 to 3)");
    whole("--activity", options.task.activity, 3, "Of the motion (0 to 3)");
  } else {
    method.option("--load-kg", options.task.load_kg, "Of the motion, kg").within(0.0, 1e6);
  }
}

}  // namespace

void addErgonomicsCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("ergonomics", "Score a posture or a lift, with the reasons");
  command.mustGoOn();
  addErgonomicsPostureCommands(command, chosen);
  const auto options = std::make_shared<ErgonomicsOptions>();
  const std::pair<const char*, const char*> methods[] = {
      {"rula", "RULA, from sub-scores or angles of one side"},
      {"reba", "REBA, from sub-scores or angles of one side"},
      {"owas", "OWAS, from a code of four digits"},
      {"niosh", "The revised NIOSH lifting equation; several \"tasks\" give the composite index"},
  };
  for (const auto& [name, description] : methods) {
    Subcommand method = command.add(name, description);
    method.option("--input", options->input, "JSON: a file, the text itself, or - for standard input")
        .takes(ValueKind::kJson);
    if (std::string_view(name) != "niosh") addMotionOptions(method, name, *options);
    method.option("--fail-over", options->fail_over, "Exit 1 if the score is above this");
    method.onChosen([options, &chosen, method_name = std::string(name)] {
      chosen = [options, method_name](ResultWriter& writer) { return run(method_name, *options, writer); };
    });
  }
}

}  // namespace hapticell::cli
