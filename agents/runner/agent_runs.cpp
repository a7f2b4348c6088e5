// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_runs.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "agents/runner/agent_run.h"
#include "agents/task/agent_section.h"
#include "geometry/system/listed.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::agents {

namespace {

/// The motion of a run: a mannequin as a whole, with all joints; a robot by its tool; a solid by its middle.
class Recorder {
 public:
  explicit Recorder(const AgentCell& cell) {
    motion_.name = cell.task().name;
    motion_.entity = cell.entity().name;
    const bool figure = cell.entity().figure() != nullptr;
    whole_ = figure;
    motion_.moved = "geometric_center";
    if (figure) motion_.moved = "whole";
    if (cell.entity().robot() == nullptr) return;
    if (!figure) motion_.moved = "tcp";
    for (const int joint : cell.entity().robot()->moving)
      motion_.joint_names.push_back(cell.entity().robot()->joints[static_cast<std::size_t>(joint)].name);
  }

  void add(const AgentLoop& loop) {
    const manipulation::EntityConfiguration& at = loop.body().configuration();
    trajectory::Trajectory::Frame frame;
    frame.t = loop.t();
    frame.X_WT = whole_ ? at.X_WE : loop.body().handle();
    motion_.addFrame(frame, at.joints);
  }

  void addWishes(const AgentLoop& loop) {
    if (csv_.empty()) {
      csv_ = "t";
      for (const ShownWish& wish : loop.wishes()) {
        for (const char* column : {"_x", "_y", "_z", "_strength"}) csv_ += "," + wish.name + column;
      }
      csv_ += "\n";
    }
    csv_ += trajectory::shortestText(loop.t());
    for (const ShownWish& wish : loop.wishes()) {
      for (const double value : {wish.arrow_W.x, wish.arrow_W.y, wish.arrow_W.z, wish.strength})
        csv_ += "," + trajectory::shortestText(value);
    }
    csv_ += "\n";
  }

  trajectory::Trajectory motion_;
  std::string csv_;

 private:
  bool whole_ = false;
};

}  // namespace

RunResult runOnce(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options) {
  AgentRun run(cell, number, mode, options);
  while (run.step()) {
  }
  return run.finish();
}

RecordedRun recordRun(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options) {
  AgentRun run(cell, number, mode, options);
  Recorder recorder(cell);
  recorder.add(run.loop());
  for (bool goes_on = true; goes_on;) {
    goes_on = run.step();
    recorder.add(run.loop());
    recorder.addWishes(run.loop());
  }
  return {run.finish(), std::move(recorder.motion_), std::move(recorder.csv_)};
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
