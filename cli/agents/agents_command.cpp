// SPDX-License-Identifier: Apache-2.0
#include "cli/agents/agents_command.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "agents/runner/agent_runs.h"
#include "cli/agents/run_report.h"
#include "cli/kit/kept_result.h"
#include "cli/kit/stop_signal.h"
#include "cli/study/study_progress.h"
#include "manipulation/checks/path_check.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::cli {

namespace {

using agents::AgentCell;
using agents::RunMode;
using agents::RunResult;
using nlohmann::ordered_json;

struct AgentsOptions {
  std::string task, record, wishes;
  std::vector<std::string> modes, weights;
  bool without_planner = false;
  int runs = 1, seed = 1, jobs = 0, run = 0;
};

Expected<std::vector<RunMode>> modesOf(const AgentsOptions& options) {
  if (options.modes.empty()) return std::vector{RunMode::kBoth};
  std::vector<RunMode> modes;
  for (const std::string& word : options.modes) {
    bool known = false;
    for (const RunMode mode : {RunMode::kOperator, RunMode::kAgents, RunMode::kBoth}) {
      if (word != toString(mode)) continue;
      modes.push_back(mode);
      known = true;
    }
    if (!known) return makeError({.place = std::string("--modes"), .found = word, .expected = "operator, agents or both"});
  }
  return modes;
}

Expected<agents::RunOptions> runOptionsOf(const AgentsOptions& options) {
  agents::RunOptions run;
  run.seed = static_cast<std::uint64_t>(options.seed);
  run.planner = !options.without_planner;
  for (const std::string& word : options.weights) {
    const auto equals = word.find('=');
    const std::string number = equals == std::string::npos ? "" : word.substr(equals + 1);
    std::size_t read = 0;
    double weight = -1.0;
    try {
      weight = std::stod(number, &read);
    } catch (const std::exception&) {
      read = 0;
    }
    if (read == 0 || read != number.size() || !(weight >= 0.0 && weight <= 100.0))
      return makeError({.place = std::string("--weights"), .found = word, .expected = "NAME=NUMBER, from 0 (off) to 100"});
    run.weights[word.substr(0, equals)] = weight;
  }
  return run;
}

/// Writes the motion of a run after code of its own has read it back and gone through it: no contact, the clearance kept.
Expected<ordered_json> record(const AgentCell& cell, const AgentsOptions& options, RunMode mode,
                              const agents::RunOptions& run) {
  const agents::RecordedRun made = agents::recordRun(cell, static_cast<std::uint64_t>(options.run), mode, run);
  ordered_json json = runJson(cell, made.result);
  if (!options.record.empty()) {
    const auto measure = [&](const std::filesystem::path& written) -> Expected<Promises> {
      const auto motion = trajectory::readTrajectory(written);
      HAPTICELL_TRY(motion);
      manipulation::PathCheckOptions check;
      auto moved_by = manipulation::parseMovedBy(motion->moved);
      HAPTICELL_TRY(moved_by);
      check.hold.moved_by = std::move(*moved_by);
      const auto found = manipulation::checkPath(cell.scene(), cell.entity().name, *motion, check, {});
      HAPTICELL_TRY(found);
      Promises promises;
      Promise contacts{"contacts", 0.0, 0.0};
      Promise limits{"joint_limits", 0.0, 0.0};
      for (const manipulation::PathFinding& finding : found->findings) {
        const bool collides = finding.kind == manipulation::PathFinding::Kind::kCollision;
        if (collides && contacts.measured == 0.0)
          contacts.place = Text("%1 and %2", finding.first, finding.second);
        if (collides) contacts.measured += 1.0;
        if (finding.kind == manipulation::PathFinding::Kind::kJointLimit) limits.measured += 1.0;
      }
      promises.list = {contacts, limits};
      promises.help = "This is a bug of the agents. Please report it.";
      json["least_clearance"] = finiteOrNull(found->least_clearance);
      return promises;
    };
    HAPTICELL_TRY(writeKept(options.record, trajectory::toJsonText(made.motion), ".htraj", false, measure, json));
    json["recorded"] = options.record;
    json["frames"] = made.motion.size();
  }
  if (!options.wishes.empty()) {
    HAPTICELL_TRY(writeFileAtomically(options.wishes, made.wishes_csv));
    json["wishes"] = options.wishes;
  }
  return json;
}

/// One line that is written over on a terminal; nothing elsewhere.
class RunsProgress {
 public:
  void show(std::size_t done, std::size_t total) const {
    if (total < 10 || done * 10 / total == (done - 1) * 10 / total) return;
    std::cerr << "hapticell-cli: " << done << " of " << total << " runs\n";
  }
};

Expected<ordered_json> runTask(const AgentsOptions& options) {
  const auto modes = modesOf(options);
  HAPTICELL_TRY(modes);
  const auto run = runOptionsOf(options);
  HAPTICELL_TRY(run);
  const StopSignal stop;
  const auto cell = AgentCell::load(options.task, {});
  HAPTICELL_TRY(cell);
  HAPTICELL_TRY(checkWeights((*cell)->task(), *run));
  for (const Text& note : (*cell)->notes()) warn(note);
  const agents::AgentTask& task = (*cell)->task();
  ordered_json json{{"task", task.name}, {"entity", task.entity}, {"seed", options.seed}, {"notes", (*cell)->notes()}};
  if (!options.record.empty() || !options.wishes.empty()) {
    const auto recorded = record(**cell, options, modes->back(), *run);
    HAPTICELL_TRY(recorded);
    json["recording"] = *recorded;
    return json;
  }
  const RunsProgress progress;
  const auto results = agents::runAgents(**cell, static_cast<std::uint64_t>(options.runs), *modes, *run, options.jobs,
                                         stop.asked(), [&](std::size_t done, std::size_t total) {
                                           progress.show(done, total);
                                         });
  if (results.empty()) return makeError({.found = "stopped before all runs were made; there is no result"});
  json["modes"] = ordered_json::array();
  for (const RunMode mode : *modes) json["modes"].push_back(summaryOf(**cell, mode, results));
  json["runs"] = ordered_json::array();
  for (const RunResult& result : results) json["runs"].push_back(runJson(**cell, result));
  return json;
}

}  // namespace

void addAgentsCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("agents", "Move an entity to a goal by agents, by a simulated operator, or by both");
  const auto options = std::make_shared<AgentsOptions>();
  command.option("task", options->task, "Task: cell, entity, goal and agents (.toml)")
      .takes(ValueKind::kToml)
      .required();
  command.option("--runs", options->runs, "Seeded runs of each mode (default: 1)").withinWhole(1, 100'000);
  command.option("--seed", options->seed, "Seed for starts, goals and the operator's mistakes (default: 1)")
      .withinWhole(0, 2'000'000'000);
  command.option("--modes", options->modes, "operator, agents, both; several with commas (default: both)")
      .separatedByCommas();
  command.option("--weights", options->weights, "AGENT=WEIGHT instead of the task's, 0: off; several with commas")
      .separatedByCommas();
  command.flag("--without-planner", options->without_planner,
               "Do not hand deadlocks that no agent takes over to the planner");
  command.option("--jobs", options->jobs, "Threads (default: one a core)").withinWhole(1, 4096);
  command.option("--run", options->run, "Number of the run that is recorded (default: 0)")
      .withinWhole(0, 2'000'000'000);
  command.option("--record", options->record,
                 "Record one run as a motion; written only if it is free of contact when read back")
      .takes(ValueKind::kMotion);
  command.option("--wishes", options->wishes, "Write what each agent wanted in each step of that run")
      .takes(ValueKind::kTable);
  command.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      const auto answer = runTask(*options);
      const auto written = answer ? writer.write(*answer) : Expected<void>(tl::unexpected<Error>(answer.error()));
      if (written) return ExitStatus::kDone;
      report(written.error());
      return ExitStatus::kBadInput;
    };
  });
}

}  // namespace hapticell::cli
