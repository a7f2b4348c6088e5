// SPDX-License-Identifier: Apache-2.0
#include "cli/agents/run_report.h"

#include <algorithm>
#include <functional>

#include "agents/wishes/agent.h"
#include "cli/kit/result_writer.h"

namespace hapticell::cli {

namespace {

using agents::RunResult;
using nlohmann::ordered_json;

/// Null of no values.
ordered_json medianOf(std::vector<double> values) {
  if (values.empty()) return nullptr;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

ordered_json runJson(const agents::AgentCell& cell, const RunResult& run) {
  ordered_json json{{"run", run.number},
                    {"mode", toString(run.mode)},
                    {"solved", run.solved},
                    {"reason", run.reason},
                    {"time_s", run.time_s},
                    {"way_m", run.way_m},
                    {"remaining_m", run.remaining_m},
                    {"clearance_m", run.clearance_m},
                    {"deadlocks", run.deadlocks},
                    {"plans", run.plans},
                    {"handed_over", run.handed_over},
                    {"strengths", run.strengths}};
  if (!cell.entity().figure()) return json;
  json["rula"] = run.rula;
  json["reba"] = run.reba;
  json["rula_worst"] = run.rula_worst;
  json["comfort"] = run.comfort;
  json["balance_m"] = run.balance_m;
  if (cell.lookAt() != 0) json["seen"] = run.seen;
  return json;
}

ordered_json summaryOf(const agents::AgentCell& cell, agents::RunMode mode, const std::vector<RunResult>& runs) {
  std::vector<RunResult> solved;
  std::size_t count = 0;
  int deadlocks = 0;
  double clearance = agents::kLook;
  for (const RunResult& run : runs) {
    if (run.mode != mode) continue;
    ++count;
    deadlocks += run.deadlocks;
    clearance = std::min(clearance, run.clearance_m);
    if (run.solved) solved.push_back(run);
  }
  const auto median = [&](const std::function<double(const RunResult&)>& value) {
    std::vector<double> values;
    for (const RunResult& run : solved) values.push_back(value(run));
    return medianOf(std::move(values));
  };
  ordered_json json{{"mode", toString(mode)},
                    {"runs", count},
                    {"solved", solved.size()},
                    {"median_time_s", median([](const RunResult& run) { return run.time_s; })},
                    {"median_way_m", median([](const RunResult& run) { return run.way_m; })},
                    {"least_clearance_m", clearance},
                    {"deadlocks", deadlocks}};
  if (!cell.entity().figure()) return json;
  json["median_rula"] = median([](const RunResult& run) { return run.rula; });
  json["median_reba"] = median([](const RunResult& run) { return run.reba; });
  json["median_rula_worst"] = median([](const RunResult& run) { return run.rula_worst; });
  json["median_comfort"] = median([](const RunResult& run) { return run.comfort; });
  json["median_balance_m"] = median([](const RunResult& run) { return run.balance_m; });
  return json;
}

}  // namespace hapticell::cli
