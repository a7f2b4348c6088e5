// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>

#include "cli/commands.h"
#include "cli/ergonomics_input.h"
#include "cli/ergonomics_report.h"
#include "mannequin/ergonomics/owas.h"
#include "mannequin/ergonomics/reba.h"
#include "mannequin/ergonomics/rula.h"

namespace hapticell::cli {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

struct ErgonomicsOptions {
  std::string input;
  std::optional<double> fail_over;
};

Expected<ordered_json> scored(const ergonomics::ScoredMethod& method, Expected<ScoredInput> input) {
  if (!input) return tl::unexpected(input.error());
  return scoredReport(method, *input);
}

Expected<ordered_json> lifting(const json& given) {
  const auto input = liftingInput(given);
  if (!input) return tl::unexpected(input.error());
  if (input->is_composite) {
    const auto result = ergonomics::compositeLift(input->tasks, input->conditions);
    if (!result) return tl::unexpected(result.error());
    return compositeReport(*input, *result);
  }
  const auto result = ergonomics::lift(input->tasks.front(), input->conditions);
  if (!result) return tl::unexpected(result.error());
  return liftingReport(input->tasks.front(), *result);
}

Expected<ordered_json> judge(const std::string& method, const json& input) {
  if (method == "rula") return scored(ergonomics::Rula(), rulaInput(input));
  if (method == "reba") return scored(ergonomics::Reba(), rebaInput(input));
  if (method == "owas") return scored(ergonomics::Owas(), owasInput(input));
  return lifting(input);
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
  const auto input = readErgonomicsInput(options.input);
  if (!input) return failed(input.error());
  const auto result = judge(method, *input);
  if (!result) {
    Error error = result.error();
    if (error.file.empty() && options.input.find('{') == std::string::npos) error.file = options.input;
    return failed(error);
  }
  if (const auto written = writer.write(*result); !written) return failed(written.error());
  return isOver(*result, options.fail_over) ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

}  // namespace

void addErgonomicsCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("ergonomics", "Score a posture or a lift, with the reasons");
  command->require_subcommand(1);
  const auto options = std::make_shared<ErgonomicsOptions>();
  const std::pair<const char*, const char*> methods[] = {
      {"rula", "RULA, from sub-scores or angles of one side"},
      {"reba", "REBA, from sub-scores or angles of one side"},
      {"owas", "OWAS, from a code of four digits"},
      {"niosh", "The revised NIOSH lifting equation; several \"tasks\" give the composite index"},
  };
  for (const auto& [name, description] : methods) {
    CLI::App* method = command->add_subcommand(name, description);
    method->add_option("--input", options->input, "JSON: a file, the text itself, or - for standard input")->required();
    method->add_option("--fail-over", options->fail_over, "Exit with 1 where the score is over this");
    method->callback([options, &chosen, method_name = std::string(name)] {
      chosen = [options, method_name](ResultWriter& writer) { return run(method_name, *options, writer); };
    });
  }
}

}  // namespace hapticell::cli
