// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_runs.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "agents/runner/agent_run.h"
#include "agents/runner/run_recorder.h"
#include "agents/task/agent_section.h"
#include "geometry/system/listed.h"

namespace hapticell::agents {

RunResult runOnce(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options) {
  AgentRun run(cell, number, mode, options);
  while (run.step()) {
  }
  return run.finish();
}

RecordedRun recordRun(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options) {
  AgentRun run(cell, number, mode, options);
  RunRecorder recorder(cell);
  recorder.add(run.loop());
  for (bool goes_on = true; goes_on;) {
    goes_on = run.step();
    recorder.add(run.loop());
    recorder.addWishes(run.loop());
  }
  return {run.finish(), recorder.motion(), recorder.wishes()};
}

Expected<void> checkWeights(const AgentTask& task, const RunOptions& options) {
  for (const auto& [name, weight] : options.weights) {
    const bool known = std::any_of(task.agents.begin(), task.agents.end(),
                                   [&, &wanted = name](const AgentSection& one) { return one.kind == wanted; });
    if (known && weight >= 0.0 && weight <= 100.0) continue;
    if (known)
      return makeError({.place = Text("weight of '%1'", name),
                        .found = std::to_string(weight),
                        .expected = "a number from 0 to 100"});
    const std::string names = listed(task.agents, [](const AgentSection& one) { return one.kind; });
    return makeError({.place = std::string("weights"),
                      .found = Text("the task has no agent '%1'", name),
                      .expected = Text("one of %1", names)});
  }
  return {};
}

std::vector<RunResult> runAgents(const AgentCell& cell, std::uint64_t count, const std::vector<RunMode>& modes,
                                 const RunOptions& options, int jobs, const std::atomic<bool>& cancelled,
                                 const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::size_t total = static_cast<std::size_t>(count) * modes.size();
  std::vector<RunResult> results(total);
  std::mutex mutex;
  std::size_t done = 0;
  tbb::task_arena arena(jobs > 0 ? jobs : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, total,
        [&](std::size_t i) {
          if (cancelled) return;
          results[i] = runOnce(cell, i % count, modes[i / count], options);
          const std::lock_guard lock(mutex);
          ++done;
          if (progress) progress(done, total);
        },
        tbb::simple_partitioner());
  });
  if (cancelled) return {};
  return results;
}

}  // namespace hapticell::agents
